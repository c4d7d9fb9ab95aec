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

from coronet_plot import dam_break, drop, droplet, history, pictures, rheology, style, tension
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
FALLING = {"time": numpy.linspace(0, 0.01, 21), "particles": numpy.full(21, 317),
           "angular_momentum_z": numpy.linspace(2, 3, 21), "kinetic_energy": numpy.linspace(0, 4e-3, 21),
           "spacing_min": numpy.linspace(1, 0.9, 21), "inside": numpy.linspace(0, 5e3, 21),
           "angular_momentum_drift": numpy.linspace(0, 0.5, 21), "rho": numpy.linspace(1000, 1001, 21)}
TIME = numpy.linspace(0, 2, 201)
DROPLET = {"time": TIME, "mass": numpy.full(201, 2.0), "spacing_min": numpy.full(201, 0.8),
           "kinetic_energy": numpy.zeros(201), "circularity": numpy.linspace(1.4, 1, 201),
           "area": numpy.linspace(2e-3, 1.99e-3, 201), "spacing_p01": numpy.full(201, 0.9),
           "mode_amplitude": 0.1 * numpy.exp(-0.5 * TIME) * numpy.cos(2 * numpy.pi * TIME / 0.4) + 0.01}
PROBES = """
[[probes]]
kind = "value"
name = "inside"
field = "pressure"
at = [0.0, 1e-4]
[[probes]]
kind = "value"
name = "rho"
field = "density"
at = [0.0, 0.0]
"""


def write_run(directory, name, columns, gradient="cph", times=(), more=""):
    """A run with empty files for frames: what they hold is put in by `particles`."""
    (directory / "frames").mkdir(parents=True)
    (directory / "case.toml").write_text(
        f'name = "{name}"\ndimension = 2\n[method]\ngradient = "{gradient}"\n[particles]\nspacing = 0.1\n{more}')
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
    return Frame(time, positions, 5e6 * (1 - x * y).ravel(), run.cell(time)[:2])


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

    def test_every_run_gets_its_history_and_every_value_probe_a_panel(self):
        runs = [write_run(self.folder / "fpm", "falling", FALLING, "fpm", more=PROBES),
                write_run(self.folder / "sph", "falling", FALLING, "sph")]
        self.assert_draws(plot(runs[0], "--with", runs[1]), runs[0],
                          "angular_momentum.png", "values.png", "history.png")
        panels = history.values([Run(runs[0])]).axes
        self.assertEqual([axes.get_ylabel() for axes in panels], ["pressure (kPa)", "density (kg/m³)"])
        self.assertEqual(panels[0].get_title(loc="left"), "inside, at (0, 0.1) mm")

    def test_a_drop_gets_its_mode_with_the_fit_and_theory_beside_it(self):
        run = write_run(self.folder / "run", "droplet", DROPLET,
                        more='[fluid]\ndensity = 1000.0\n[[probes]]\nkind = "mode"\nmode = 4\n')
        self.assertIsNone(droplet.fit(Run(run)))  # it has not ended yet
        measures = {"period": {"value": 0.4, "reference": 0.5}, "damping_rate": {"value": 0.5, "reference": 0.0}}
        (run / "summary.json").write_text(json.dumps({"status": "done", "measures": measures}))
        time, fitted = droplet.fit(Run(run))
        self.assertAlmostEqual(time[0], 0.5)  # one period of theory later
        numpy.testing.assert_allclose(fitted, DROPLET["mode_amplitude"][DROPLET["time"] >= 0.5], atol=1e-12)
        numpy.testing.assert_allclose(droplet.exact(Run(run)), 0.11 * numpy.cos(2 * numpy.pi * TIME / 0.5),
                                      atol=1e-12)
        self.assertEqual(droplet.mode([Run(run)]).axes[0].get_ylabel(), "amplitude of mode 4, over the radius")
        self.assert_draws(plot(run), run, "history.png", "mode.png", "droplet_history.png")
        measures["period"]["value"] = None  # it could not be fitted
        (run / "summary.json").write_text(json.dumps({"status": "done", "measures": measures}))
        self.assertIsNone(droplet.fit(Run(run)))

    def test_energies_are_drawn_as_changes_that_add_up(self):
        series = {"time": TIME, "kinetic_energy": 1 + TIME, "surface_energy": 5 - 3 * TIME, "dissipated_energy": TIME}
        run = write_run(self.folder / "run", "collision", series)
        found = tension.changes(Run(run))
        numpy.testing.assert_allclose(found["surface"], -3 * TIME)
        numpy.testing.assert_allclose(found["together"], -TIME)
        self.assertEqual(len(tension.energies([Run(run)]).axes[0].lines), 5)  # of four curves, and zero
        self.assert_draws(plot(run), run, "energies.png")

    def test_a_column_gets_its_wave_with_theorys_slope_from_where_it_has_doubled(self):
        series = {"time": TIME, "wave_amplitude": 0.01 * numpy.exp(2 * TIME), "neck_radius": 1 - TIME / 2}
        run = write_run(self.folder / "run", "column", series)
        self.assertEqual(len(tension.column([Run(run)]).axes[0].lines), 1)  # it has not ended yet
        (run / "summary.json").write_text(json.dumps({"status": "done", "measures": {"growth_rate": {"reference": 2.0}}}))
        found, exact = tension.column([Run(run)]).axes[0].lines
        numpy.testing.assert_allclose(exact.get_ydata(), found.get_ydata()[:len(exact.get_ydata())], rtol=1e-9)
        self.assert_draws(plot(run), run, "column.png")

    def test_a_breaking_dam_gets_its_front_and_its_pressure_beside_what_was_measured(self):
        series = {"time": TIME, "front": 0.3 + TIME, "low": 1e3 * TIME, "elsewhere": 1e3 * TIME}
        sensors = "".join(f'[[probes]]\nkind = "impact"\nname = "{name}"\ndepth = "height"\nwidth = "0.3"\n'
                          f'at = [1.0, {place}]\nsensor_width = 0.0021\n'
                          for name, place in {"low": 0.0015, "elsewhere": 0.01}.items())
        tables = {"tall": (0.6, ["dambreak_martin_moyce1952_a225"]),
                  "wide": (0.15, ["dambreak_lobovsky2014_front_H300", "dambreak_lobovsky2014_P1"])}
        for name, (height, names) in tables.items():
            run = self.folder / name
            write_run(run, name, series, more=f'[parameters]\nheight = {height}\n[fluid]\ndensity = 1000.0\n'
                      'gravity = [0.0, -9.81]\n[[probes]]\nkind = "dam-break"\ndepth = "height"\nwidth = "0.3"\n' + sensors)
            rows = "".join(f"{table},1,2,3\n{table},2,3,4\n" for table in names)
            (run / "profiles.csv").write_text("profile,position,computed,reference\n" + rows)
            (run / "summary.json").write_text(json.dumps(
                {"status": "done", "measures": {"front_late_martin_moyce_225": {"value": 0.25}}}))
            panels = dam_break.dam_break([Run(run)]).axes
            self.assertEqual(len(panels), len(names))
            if name == "tall":  # as measured, and if that was late
                as_measured = [list(line.get_xdata()) for line in panels[0].lines if line.get_marker() == "v"]
                self.assertEqual(as_measured, [[0.75, 1.75], [1, 2]])
            self.assert_draws(plot(run), run, "dam_break.png")

    def test_a_flow_curve_is_drawn_with_the_law_fitted_to_it(self):
        run = write_run(self.folder / "run", "falling", FALLING, more='[fluid]\nrheology = "bingham"\n')
        self.assertIsNone(Run(run).flow_curve)
        (run / "flow_curve.csv").write_text("shear_rate,stress,fit,as_run\n10,12,12,12\n0.1,2.1,2.2,2.2\n")
        stress, viscosity = rheology.flow_curve([Run(run)]).axes
        measured, law = stress.lines
        self.assertEqual(law.get_label(), "bingham")
        self.assertEqual(list(law.get_xdata()), [0.1, 10])  # in order, whatever that of the table
        self.assertEqual(list(measured.get_ydata()), [12, 2.1])
        numpy.testing.assert_allclose(viscosity.lines[1].get_ydata(), [22, 1.2])
        (run / "flow_curve.csv").write_text("shear_rate,stress,fit,as_run\n10,12,12,12\n0.1,2.1,2.2,1.9\n")
        self.assertEqual(len(rheology.flow_curve([Run(run)]).axes[0].lines), 3)  # the law as run differs
        self.assertIn("flow_curve.png", plot(run).stdout)
        (run / "flow_curve.csv").write_text("shear_rate,stress\n10,12\n")
        self.assert_complains(plot(run), "has no column 'fit'")

    def test_a_run_that_blows_up_does_not_flatten_what_was_before(self):
        energy = numpy.append(numpy.ones(98), [2e9, numpy.inf])
        columns = {"time": numpy.arange(100), "kinetic_energy": energy, "spacing_min": numpy.ones(100)}
        drawing = history.history([Run(write_run(self.folder / "run", "burst", columns))])
        low, high = drawing.axes[0].get_ylim()
        self.assertLess(abs(high / low), 100)

    def test_angular_momentum_is_left_out_where_a_force_changes_it(self):
        for k, (force, drawn) in enumerate({"gravity = [0.0, -9.81]": False, 'body_force = ["0", "x"]': False,
                                            'gravity = [0.0, 0.0]\nbody_force = ["0", "0"]': True}.items()):
            run = write_run(self.folder / str(k), "falling", FALLING, more=f"[fluid]\n{force}\n")
            self.assertEqual(Run(run).rotates, drawn, force)

    @mock.patch.object(pictures, "read_frame", particles)
    def test_the_last_picture_of_a_run_that_failed_says_when(self):
        run = write_run(self.folder / "run", "square-patch", FALLING, times=[0.0, 0.001])
        self.assertIsNone(Run(run).failed)
        message = "the run failed at t = 0.00123 s, step 4: the stable time step fell"
        (run / "summary.json").write_text(json.dumps({"status": "failed", "message": message}))
        drawing = pictures.particles([Run(run)])
        self.assertIn("failed at $t$ = 1.23 ms", drawing.axes[1].get_title())
        self.assertEqual(drawing._suptitle.get_text(), "square-patch, CPH, 317 particles")

    def test_a_particle_of_a_stretching_drop_is_as_long_as_the_flow_makes_it(self):
        run = Run(write_run(self.folder / "run", "drop-stretching", STRETCHING))
        numpy.testing.assert_allclose(run.cell(0.008), [0.05, 0.2, 0.1])

    def test_the_colours_of_a_drop_are_those_of_the_exact_pressure_however_noisy_a_run(self):
        run = Run(write_run(self.folder / "run", "drop-stretching", STRETCHING))
        noisy = Frame(0.008, numpy.zeros((2, 2)), numpy.array([-9e7, 9e7]), run.cell(0.008)[:2])
        scale = drop.exact_scale([run], [noisy])
        self.assertAlmostEqual(scale.norm.vmax, 1.15 * 1.1)
        self.assertEqual((scale.unit, scale.extend), ("MPa", "both"))

    def test_runs_of_one_method_are_told_apart_by_their_directories(self):
        runs = [Run(write_run(self.folder / name, "square-patch", PATCH)) for name in ("a", "b")]
        self.assertEqual(style.labels(runs), ["CPH (a)", "CPH (b)"])

    def test_a_prefix_brings_the_largest_value_between_one_and_a_thousand(self):
        self.assertEqual(style.prefixed([0, 5e6], "Pa"), (1e-6, "MPa"))
        self.assertEqual(style.prefixed([-2e3, 1.0], "Pa"), (1e-3, "kPa"))
        self.assertEqual(style.prefixed([0.02], "s"), (1e3, "ms"))
        self.assertEqual(style.prefixed([0.0], "s"), (1.0, "s"))

    def test_a_length_near_one_keeps_its_unit(self):
        self.assertEqual(style.length([1.2e-3]), (1e3, "mm"))
        self.assertEqual(style.length([0.9e-3]), (1e3, "mm"))
        self.assertEqual(style.length([-0.7, 0.5]), (1.0, "m"))

    @mock.patch.object(pictures, "read_frame", particles)
    @mock.patch.object(drop, "read_frame", particles)
    def test_pictures_are_drawn_of_any_number_of_frames_and_runs(self):
        times = [0.0, 0.004, 0.008, 0.016, 0.02]
        for count, together in ((1, 1), (2, 3), (5, 1)):
            run = Run(write_run(self.folder / str(count), "drop-stretching", STRETCHING, times=times[:count]))
            for draw in (pictures.particles, pictures.patch, drop.drop):
                draw(together * [run]).savefig(self.folder / "one.png", dpi=40)


if __name__ == "__main__":
    unittest.main()
