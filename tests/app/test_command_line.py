# SPDX-License-Identifier: BSD-3-Clause
"""The program at its edge: commands, exit status, messages, and what a run leaves in its directory."""
import csv
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader

CORONET = str(Path(sys.argv.pop(1)).resolve())
DONE, WRONG_CASE, FAILED_RUN, INTERRUPTED = 0, 2, 3, 130

# Two drops: one tiny, a hundred steps of 81 particles; one large enough that threads share the work.
TINY = ["drop-stretching", "--set", "particles.spacing=0.2", "--set", "time.end=1e-4", "--set", "time.step=1e-6",
        "--set", "output.every=5e-5", "--set", "output.series_every=2e-5", "--threads", "1"]
LARGE = ["drop-stretching", "--set", "time.end=1e-5", "--set", "output.every=5e-6",
         "--set", "output.series_every=2.5e-6"]

COLUMNS = ["time", "step", "dt", "particles", "mass", "volume", "momentum_x", "momentum_y", "angular_momentum_z",
           "centre_x", "centre_y", "kinetic_energy", "spacing_min"]
COLUMNS_3D = ["time", "step", "dt", "particles", "mass", "volume", "momentum_x", "momentum_y", "momentum_z",
              "angular_momentum_z", "angular_momentum_x", "angular_momentum_y", "centre_x", "centre_y", "centre_z",
              "kinetic_energy", "spacing_min"]
PROBE_COLUMNS = ["semi_axis_x", "semi_axis_y", "centre_pressure",
                 "exact_semi_axis_x", "exact_semi_axis_y", "exact_centre_pressure"]
SUMMARY_KEYS = {"case", "version", "commit", "threads", "precision", "particles", "steps", "evaluations",
                "neighbours_mean", "wall_seconds", "seconds_per_phase", "particle_evaluations_per_second",
                "peak_rss_bytes", "bytes_per_particle", "status", "measures"}

# Threads that wait asleep: the tests may share the machine with others.
ENVIRONMENT = dict(os.environ, OMP_WAIT_POLICY="passive")


def read_series(run):
    with open(run / "series.csv", newline="") as file:
        return list(csv.DictReader(file))


def read_summary(run):
    return json.loads((run / "summary.json").read_text())


def listed_frames(run):
    return json.loads((run / "frames.vtkhdf.series").read_text())["files"]


def read_fields(frame):
    """The bytes of every field, by its name. The files themselves differ: HDF5 puts the clock's time into them."""
    reader = vtkHDFReader()
    reader.SetFileName(str(frame))
    reader.Update()
    grid = reader.GetOutput()
    fields = grid.GetPointData()
    arrays = [fields.GetArray(k) for k in range(fields.GetNumberOfArrays())]
    values = {array.GetName(): vtk_to_numpy(array).tobytes() for array in arrays}
    return dict(values, positions=vtk_to_numpy(grid.GetPoints().GetData()).tobytes())


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def coronet(self, *words, status=DONE, **how):
        done = subprocess.run([CORONET, *map(str, words)], cwd=self.folder, env=ENVIRONMENT, timeout=300,
                              capture_output=True, text=True, **how)
        self.assertEqual(done.returncode, status, f"{words}\n{done.stdout}{done.stderr}")
        return done

    def run_case(self, name, case=TINY, *words, **how):
        self.coronet("run", *case, "--out", name, "--quiet", *words, **how)
        return self.folder / name

    def refused(self, *words, status=WRONG_CASE):
        """What is said when nothing is done: on standard error alone."""
        done = self.coronet(*words, status=status)
        self.assertEqual(done.stdout, "")
        return done.stderr


class ARun(CommandLine):
    def test_leaves_the_files_that_are_promised(self):
        run = self.run_case("run")
        found = sorted(str(path.relative_to(run)) for path in run.rglob("*") if path.is_file())
        frames = [f"frames/{k:06}.vtkhdf" for k in range(3)]
        others = ["case.toml", "frames.vtkhdf.series", "series.csv", "summary.json"]
        self.assertEqual(found, sorted([*others, *frames]))
        self.assertEqual([file["name"] for file in listed_frames(run)], frames)
        self.assertEqual([file["time"] for file in listed_frames(run)], [0, 5e-5, 1e-4])

    def test_shows_its_measures_at_the_end_beside_what_they_should_be(self):
        done = self.coronet("run", *TINY, "--out", "run")
        self.assertEqual(done.stdout, "run\n")
        measures = read_summary(self.folder / "run")["measures"]
        for name, measure in measures.items():
            self.assertRegex(done.stderr, rf"(?m)^{name} +" + re.escape(f"{measure['value']:.6g} "))
        self.assertRegex(done.stderr, r"(?m)^ +value +reference +error$")
        self.assertEqual(self.coronet("run", *TINY, "--out", "silent", "--quiet").stderr, "")
        done = self.coronet("run", "oscillating-drop", "--set", "time.end=0.01", "--set", "particles.spacing=0.001", "--out", "brief")
        self.assertRegex(done.stderr, r"(?m)^period +not fitted: the run has 0 periods after the first")

    def test_with_a_flow_curve_leaves_it_and_runs_again_without_the_table(self):
        (self.folder / "table.csv").write_text("shear_rate,stress\n1,2\n2,4.04\n4,7.92\n")
        (self.folder / "case.toml").write_text(
            'name = "measured"\ndimension = 2\nshapes = [{ kind = "disc", radius = 1.0 }]\nparticles.spacing = 0.2\n'
            'fluid = { density = 1000.0, sound_speed = 10.0, flow_curve = "table.csv" }\ntime.end = 1e-3\n')
        said = self.coronet("check", "case.toml").stdout
        self.assertIn("3 points of table.csv, 1 to 4 1/s: deviation 0.817 % rms, at most 1.01 % (at 4 1/s)", said)
        self.assertRegex(said, r"viscosity += 1.9999 Pa s \(fitted, \+- 0\.58 %\)")
        run = self.run_case("run", ["case.toml", "--threads", "1"])
        (self.folder / "table.csv").unlink()
        again = self.run_case("again", [run / "case.toml", "--threads", "1"])
        for file in ("case.toml", "flow_curve.csv", "series.csv"):
            self.assertEqual((again / file).read_bytes(), (run / file).read_bytes())

    def test_writes_the_series_that_is_promised(self):
        rows = read_series(self.run_case("run"))
        self.assertEqual(list(rows[0])[:len(COLUMNS)], COLUMNS)
        self.assertEqual(list(rows[0])[len(COLUMNS):], PROBE_COLUMNS + ["singular_matrices"])
        times = [float(row["time"]) for row in rows]
        self.assertEqual(len(times), 6)
        for k, sampled in enumerate(times):
            self.assertAlmostEqual(sampled, k * 2e-5, delta=1e-18)
        self.assertEqual([int(row["step"]) for row in rows], [0, 20, 40, 60, 80, 100])
        for row in rows:
            self.assertEqual(int(row["particles"]), 81)
            self.assertGreater(float(row["spacing_min"]), 0.9)
            self.assertAlmostEqual(float(row["mass"]), float(rows[0]["mass"]), delta=1e-9)

    def test_in_three_dimensions_writes_the_series_that_is_promised(self):
        run = self.run_case("run", ["spheroid-stretching", "--threads", "1"], "--set", "particles.spacing=0.3",
                            "--set", "time.end=1e-4", "--set", "output.every=1e-4")
        names = list(read_series(run)[0])
        self.assertEqual(names[:len(COLUMNS_3D)], COLUMNS_3D)
        self.assertEqual(names[len(COLUMNS_3D):][:4], ["semi_axis_x", "semi_axis_y", "semi_axis_z", "centre_pressure"])

    def test_writes_the_summary_that_is_promised(self):
        summary = read_summary(self.run_case("run"))
        self.assertEqual(SUMMARY_KEYS - set(summary), set())
        words = [summary[key] for key in ("case", "status", "precision")]
        self.assertEqual(words, ["drop-stretching", "done", "double"])
        self.assertEqual([summary[key] for key in ("particles", "steps", "threads")], [81, 100, 1])
        self.assertGreaterEqual(summary["evaluations"], 2 * summary["steps"])
        self.assertAlmostEqual(summary["bytes_per_particle"], summary["peak_rss_bytes"] / 81, delta=1)
        self.assertLessEqual(sum(summary["seconds_per_phase"].values()), summary["wall_seconds"])
        self.assertEqual(set(summary["measures"]), {"semi_axis_error_max", "centre_pressure_error_rms"})
        for measure in summary["measures"].values():
            self.assertEqual(measure["reference"], 0)
            self.assertEqual(measure["error"], measure["value"])
            self.assertIn("Fang", measure["source"])

    def test_without_frames_writes_none(self):
        run = self.run_case("run", TINY, "--set", "output.frames=false")
        self.assertEqual(list(run.glob("**/*.vtkhdf")), [])
        self.assertEqual(len(read_series(run)), 6)

    def test_of_the_case_it_wrote_gives_the_same_bits(self):
        first = self.run_case("first", TINY, "--set", "particles.jitter=0.2", "--set", "method.gradient=cph")
        second = self.run_case("second", [first / "case.toml", "--threads", "1"])
        self.assertEqual((first / "case.toml").read_text(), (second / "case.toml").read_text())
        self.assertEqual((first / "series.csv").read_bytes(), (second / "series.csv").read_bytes())
        other = self.run_case("other")
        self.assertNotEqual((first / "series.csv").read_bytes(), (other / "series.csv").read_bytes())

    def test_on_one_thread_and_on_two_gives_the_same_bits(self):
        one, two = [self.run_case(f"on_{n}", LARGE, "--threads", n) for n in (1, 2)]
        self.assertEqual([read_summary(run)["threads"] for run in (one, two)], [1, 2])
        self.assertEqual(len(read_series(one)), 5)
        self.assertEqual((one / "series.csv").read_bytes(), (two / "series.csv").read_bytes())
        for file in listed_frames(one):
            a, b = [read_fields(run / file["name"]) for run in (one, two)]
            self.assertLessEqual({"positions", "velocity", "pressure", "id"}, set(a))
            self.assertEqual(set(a), set(b))
            for field in a:
                self.assertEqual(a[field], b[field], f"{field} of {file['name']}")

    def test_goes_to_the_directory_runs_unless_told_otherwise(self):
        self.coronet("run", *TINY, "--quiet")
        self.assertEqual(read_summary(self.folder / "runs" / "drop-stretching")["status"], "done")

    def test_is_not_replaced_unless_told_so(self):
        run = self.run_case("run")
        before = (run / "series.csv").read_bytes()
        message = self.refused("run", *TINY, "--out", "run", "--set", "time.end=5e-5")
        self.assertRegex(message, "^run already holds a run: .*--overwrite")
        self.assertEqual((run / "series.csv").read_bytes(), before)

    def test_that_is_replaced_leaves_nothing_but_what_is_not_its_own(self):
        run = self.run_case("run")
        (run / "notes.txt").write_text("mine")
        self.run_case("run", TINY, "--overwrite", "--set", "time.end=5e-5")
        self.assertEqual(len(list(run.glob("frames/*"))), 2)
        self.assertEqual(len(listed_frames(run)), 2)
        self.assertEqual((run / "notes.txt").read_text(), "mine")

    def test_prints_its_directory_and_shows_progress_apart(self):
        done = self.coronet("run", *TINY, "--out", "run")
        self.assertEqual(done.stdout, "run\n")
        self.assertRegex(done.stderr, r"t = 0\.0001 s +100\.0 % .* steps/s .* particle-steps/s .*left\n +value")
        self.assertNotIn("\r", done.stderr)

    def test_says_that_its_step_is_longer_than_is_known_to_be_stable(self):
        notes = [line for line in self.coronet("run", *TINY, "--set", "time.step=5e-5", "--set", "output.series_every=1e-4",
                                                      "--set", "output.every=1e-4", "--out", "run").stderr.splitlines()
                 if line.startswith("note:")]
        self.assertEqual(len(notes), 1)
        self.assertRegex(notes[0], r"the step 5e-05 s \(time\.step\) is longer than the 4\.\S+e-05 s that sound would let")

    def test_that_is_quiet_shows_no_progress(self):
        done = self.coronet("run", *TINY, "--out", "run", "--quiet")
        self.assertEqual((done.stdout, done.stderr), ("run\n", ""))


class ARunThatEndsEarly(CommandLine):
    def interrupt(self, sent):
        run = self.folder / "run"
        case = ["drop-stretching", "--set", "output.series_every=2e-6", "--set", "output.every=1e-5"]
        process = subprocess.Popen([CORONET, "run", *case, "--out", str(run), "--quiet", "--threads", "1"],
                                   env=ENVIRONMENT, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        series = run / "series.csv"
        end = time.monotonic() + 60
        while not (series.exists() and series.read_text().count("\n") > 3):
            self.assertIsNone(process.poll(), "it ended by itself")
            self.assertLess(time.monotonic(), end, "no row was written")
            time.sleep(0.02)
        process.send_signal(sent)
        self.assertEqual(process.wait(60), INTERRUPTED)
        return run

    def test_by_an_interrupt_keeps_what_it_has(self):
        for sent in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(sent.name):
                run = self.interrupt(sent)
                summary, rows, frames = read_summary(run), read_series(run), listed_frames(run)
                self.assertEqual(summary["status"], "interrupted")
                self.assertLess(float(rows[-1]["time"]), 0.01)
                self.assertEqual(int(rows[-1]["step"]), summary["steps"])
                self.assertEqual(frames[-1]["time"], float(rows[-1]["time"]))
                for file in frames:
                    self.assertGreater((run / file["name"]).stat().st_size, 0)
                self.assertEqual(list(run.rglob("*.part")), [])
                (run / "case.toml").unlink()
                (run / "series.csv").unlink()

    def test_by_divergence_says_when_where_and_what_to_try(self):
        force = ["--set", 'fluid.body_force=["t > 2e-5 ? 1/0 : 0", 0]']
        for step, advice in (("1e-6", "smaller time.step"), ("auto", "smaller time.courant")):
            with self.subTest(step):
                setting = ["--set", f"time.step={step}", "--out", step, "--quiet"]
                message = self.refused("run", *TINY, *force, *setting, status=FAILED_RUN)
                when = re.search(r"t = (\S+) s, step (\d+)", message)
                self.assertIsNotNone(when, message)
                self.assertTrue(2e-5 <= float(when[1]) <= 1e-4, message)
                self.assertIn("particle ", message)
                self.assertIn(advice, message)
                run = self.folder / step
                self.assertEqual(read_summary(run)["status"], "failed")
                self.assertIn(read_summary(run)["message"], message)
                self.assertGreaterEqual(len(read_series(run)), 2)
                self.assertEqual(len(listed_frames(run)), 2)  # at the start and of the failure

    @unittest.skipIf("CORONET_NO_FILE_LIMIT" in os.environ, "the thread sanitizer itself needs a large file")
    def test_by_a_full_disk_says_so(self):
        """A limit on the size of files stands in for a full disk; frames are the first to meet it."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (300_000, 300_000))
        done = self.coronet("run", *TINY, "--set", "particles.spacing=0.04", "--out", "run", "--quiet",
                            status=FAILED_RUN, preexec_fn=limit)
        self.assertRegex(done.stderr, r"cannot write run/frames/000000\.vtkhdf")
        self.assertEqual(list((self.folder / "run").rglob("*.vtkhdf")), [])
        self.assertEqual(read_summary(self.folder / "run")["status"], "failed")

    def test_by_a_last_frame_that_cannot_be_written_is_not_done(self):
        """No later frame is due that could tell of it."""
        (self.folder / "run" / "frames" / "000001.vtkhdf").mkdir(parents=True)  # a file cannot take its place
        message = self.refused("run", *TINY, "--set", "output.every=1e-4", "--out", "run", "--quiet",
                               status=FAILED_RUN)
        self.assertRegex(message, r"t = 0\.0001 s, .*cannot write run/frames/000001\.vtkhdf: Is a directory")
        self.assertEqual(read_summary(self.folder / "run")["status"], "failed")
        self.assertEqual([file["time"] for file in listed_frames(self.folder / "run")], [0])

    def test_before_it_begins_where_it_cannot_write(self):
        (self.folder / "file").write_text("")
        self.assertRegex(self.refused("run", *TINY, "--out", "file"), "^file(/frames)? cannot be made: ")
        self.assertRegex(self.refused("run", *TINY, "--out", "file/run"),
                         "^file/run cannot be made: Not a directory")


class AWrongCommand(CommandLine):
    def test_names_what_is_there(self):
        self.assertRegex(self.refused("rnu", "drop-stretching"), r"no command 'rnu' \(did you mean run\?\).*check")
        self.assertRegex(self.refused("run", "drop-streching"), r"did you mean drop-stretching\?.*square-patch")
        self.assertRegex(self.refused("check", "missing.toml"), "no file 'missing.toml'")

    def test_names_the_option_that_is_not_there(self):
        self.assertIn("--fast", self.refused("run", *TINY, "--fast"))
        self.assertIn("--threads", self.refused("run", "drop-stretching", "--threads", "0"))
        self.assertIn("CASE", self.refused("run"))
        self.assertNotEqual(self.refused(), "")

    def test_names_the_setting_that_is_wrong(self):
        self.assertIn("--set particles.spacng: particles.spacng is no key here; did you mean particles.spacing?",
                      self.refused("run", "drop-stretching", "--set", "particles.spacng=0.1"))
        self.assertIn("--set time.end: must have the form path.to.key=value",
                      self.refused("run", "drop-stretching", "--set", "time.end"))
        self.assertIn("above 0", self.refused("check", "drop-stretching", "--set", "time.end=-1"))

    def test_writes_nothing(self):
        self.refused("run", "drop-stretching", "--set", "particles.spacng=0.1", "--out", "run")
        self.assertEqual(list(self.folder.iterdir()), [])


class WhatIsAskedFor(CommandLine):
    def test_the_cases_are_listed_a_line_each(self):
        done = self.coronet("cases")
        self.assertEqual(done.stderr, "")
        names = [line.split()[0] for line in done.stdout.splitlines()]
        promised = {"drop-stretching", "drop-rotating", "square-patch", "spheroid-stretching"}
        self.assertLessEqual(promised, set(names))
        self.assertEqual(len(set(names)), len(names))
        for line, name in zip(done.stdout.splitlines(), names):
            self.assertRegex(line, r"^\S+ +[23]D  \S")
            self.coronet("check", name)

    def test_a_valid_case_is_said_to_be_so(self):
        done = self.coronet("check", "drop-stretching", "--set", "particles.spacing=0.04")
        self.assertRegex(done.stdout, r"drop-stretching is a valid case: 2D, 1961 particles.*\n  liquid: 3\.1\d+ m\^2, 3\d+ kg/m, its particles from \(-1, -1\)")
        self.assertNotIn("note:", done.stdout)
        done = self.coronet("check", "dam-break", "--set", "walls.0.slip=none", "--set", "fluid.sound_speed=2")
        self.assertRegex(done.stdout, r"\n  walls: \d+ particles\n  note: fluid\.viscosity is 0.*\n  note: fluid\.sound_speed = 2 m/s is less than ten times the 2\.43 m/s")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_the_whole_cases_of_the_guide_are_valid(self):
        guide = (Path(__file__).resolve().parents[2] / "docs/guide.md").read_text()
        cases = [block for block in re.findall(r"```toml\n(.*?)```", guide, re.S) if block.startswith("name") and "\nfrom =" not in block]
        self.assertGreaterEqual(len(cases), 3)
        for number, text in enumerate(cases):
            (self.folder / f"{number}.toml").write_text(text)
            self.coronet("check", f"{number}.toml")

    def test_a_wrong_case_is_said_to_be_so_with_file_and_line(self):
        (self.folder / "drop.toml").write_text('name = "drop"\ndimension = 5\n')
        message = self.refused("check", "drop.toml")
        self.assertIn("drop.toml:2: dimension is 5, but must be a whole number, at least 2", message)
        self.assertIn("drop.toml: time.end is missing", message)

    def test_the_keys_help_and_version_are_printed(self):
        self.assertIn("| `particles.spacing` |", self.coronet("keys").stdout)
        self.assertIn("check", self.coronet("--help").stdout)
        self.assertIn("--overwrite", self.coronet("run", "--help").stdout)
        self.assertRegex(self.coronet("--version").stdout, r"^coronet \d+\.\d+\.\d+ \(.+\)\n$")


if __name__ == "__main__":
    unittest.main()
