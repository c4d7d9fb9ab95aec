# SPDX-License-Identifier: BSD-3-Clause
"""coronet plot: a directory that is no run is told so in a sentence, a run gets the figures that fit it."""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy

PYTHON = Path(__file__).resolve().parents[2] / "python"
sys.path.insert(0, str(PYTHON))
sys.dont_write_bytecode = True

from coronet_plot import drop, pictures, style
from coronet_plot.frame import Frame
from coronet_plot.run import Run

STRETCHING = {
    "time": numpy.linspace(0, 0.008, 41),
    "angular_momentum_z": numpy.zeros(41),
    "semi_axis_x": numpy.linspace(1, 0.51, 41), "semi_axis_y": numpy.linspace(1, 1.95, 41),
    "centre_pressure": numpy.linspace(5.1e6, 1.2e6, 41),
    "exact_semi_axis_x": numpy.linspace(1, 0.5, 41), "exact_semi_axis_y": numpy.linspace(1, 2, 41),
    "exact_centre_pressure": numpy.linspace(5e6, 1.1e6, 41),
}
ROTATING = {"time": numpy.linspace(0, 1, 11), "angular_momentum_z": numpy.linspace(2, 2.0001, 11)}
PATCH = {"time": numpy.linspace(0, 0.02, 21), "corner_radius": numpy.linspace(0.7, 1.5, 21),
         "exact_corner_radius": numpy.linspace(0.7, 1.6, 21), "side_half_width": numpy.linspace(0.5, 0.4, 21)}


def write_run(directory, name, columns, gradient="cph", times=()):
    """A run with empty files for frames: what they hold is put in by `particles`."""
    (directory / "frames").mkdir(parents=True)
    (directory / "case.toml").write_text(
        f'name = "{name}"\ndimension = 2\n[method]\ngradient = "{gradient}"\n[particles]\nspacing = 0.1\n')
    numpy.savetxt(directory / "series.csv", numpy.column_stack(list(columns.values())), delimiter=",",
                  header=",".join(columns), comments="")
    names = [f"frames/{k:06}.vtkhdf" for k in range(len(times))]
    for file in names:
        (directory / file).touch()
    files = [{"name": file, "time": time} for file, time in zip(names, times)]
    listing = {"file-series-version": "1.0", "files": files}
    (directory / "frames.vtkhdf.series").write_text(json.dumps(listing))
    return directory


def particles(run, time, path):
    x, y = numpy.meshgrid(*2 * [numpy.linspace(-1, 1, 21)])
    positions = numpy.column_stack([x.ravel(), (1 + 100 * time) * y.ravel()])
    return Frame(time, positions, 5e6 * (1 - x * y).ravel())


def plot(*words):
    command = [sys.executable, "-B", PYTHON / "coronet_plot" / "__main__.py", *words]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True)


class Plot(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_complains(self, done, *words):
        self.assertEqual(done.returncode, 2)
        self.assertNotIn("Traceback", done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def assert_draws(self, done, directory, *names):
        self.assertEqual(done.returncode, 0, done.stderr)
        files = [directory / "figures" / name for name in names]
        self.assertEqual(done.stdout.split(), list(map(str, files)))
        for file in files:
            self.assertEqual(file.read_bytes()[:4], b"\x89PNG")

    def test_a_missing_directory_is_named(self):
        self.assert_complains(plot(self.folder / "none"), "none is not a directory")

    def test_what_a_run_lacks_is_named(self):
        self.assert_complains(plot(self.folder), "no case.toml and no series.csv")

    def test_every_directory_to_compare_with_must_be_a_run(self):
        run = write_run(self.folder / "run", "drop-stretching", STRETCHING)
        self.assert_complains(plot(run, "--with", self.folder), "no case.toml")

    def test_a_series_without_samples_is_told(self):
        run = write_run(self.folder / "run", "drop-stretching", STRETCHING)
        (run / "series.csv").write_text("time,step\n")
        self.assert_complains(plot(run), "has no samples yet")

    def test_a_file_that_is_no_frame_is_named_and_the_curves_are_there(self):
        run = write_run(self.folder / "run", "drop-stretching", STRETCHING, times=[0.0])
        done = plot(run)
        self.assert_complains(done, "000000.vtkhdf is not a frame")
        self.assertTrue((run / "figures" / "semi_axes.png").exists())

    def test_a_stretching_drop_without_frames_gets_its_curves(self):
        runs = [write_run(self.folder / gradient, "drop-stretching", STRETCHING, gradient)
                for gradient in ("sph", "cph", "fpm")]
        done = plot(runs[0], "--with", *runs[1:])
        self.assert_draws(done, runs[0], "semi_axes.png", "centre_pressure.png")
        self.assertIn("has no frames", done.stderr)

    def test_a_row_half_written_is_left_out(self):
        run = write_run(self.folder / "run", "drop-rotating", ROTATING)
        with (run / "series.csv").open("a") as file:
            file.write("1.1")
        self.assertEqual(len(Run(run).series["time"]), 11)
        self.assert_draws(plot(run), run, "angular_momentum.png")

    def test_a_patch_without_frames_gets_its_history(self):
        run = write_run(self.folder / "run", "square-patch", PATCH)
        self.assert_draws(plot(run), run, "patch_history.png")

    def test_runs_of_one_method_are_told_apart_by_their_directories(self):
        runs = [Run(write_run(self.folder / name, "square-patch", PATCH)) for name in ("a", "b")]
        self.assertEqual(style.labels(runs), ["CPH (a)", "CPH (b)"])

    def test_a_prefix_brings_the_largest_value_between_one_and_a_thousand(self):
        self.assertEqual(style.prefixed([0, 5e6], "Pa"), (1e-6, "MPa"))
        self.assertEqual(style.prefixed([-2e3, 1.0], "Pa"), (1e-3, "kPa"))
        self.assertEqual(style.prefixed([0.02], "s"), (1e3, "ms"))
        self.assertEqual(style.prefixed([0.0], "s"), (1.0, "s"))

    @mock.patch.object(pictures, "read_frame", particles)
    @mock.patch.object(drop, "read_frame", particles)
    def test_pictures_are_drawn_of_any_number_of_frames_and_runs(self):
        times = [0.0, 0.004, 0.008, 0.016, 0.02]
        for count in (1, 2, 5):
            run = Run(write_run(self.folder / str(count), "drop-stretching", STRETCHING, times=times[:count]))
            for draw in (pictures.particles, pictures.patch, drop.drop):
                draw([run]).savefig(self.folder / "one.png")
                draw([run, run, run]).savefig(self.folder / "three.png")


if __name__ == "__main__":
    unittest.main()
