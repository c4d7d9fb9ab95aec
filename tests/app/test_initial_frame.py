# SPDX-License-Identifier: BSD-3-Clause
"""A run that starts from a frame of another one."""
import shutil
import unittest

from test_command_line import CommandLine, listed_frames, read_series


class AFrame(CommandLine):
    def test_of_a_coarser_run_gives_its_flow_and_is_kept_so_that_the_case_runs_again(self):
        vortices = ["taylor-green", "--threads", "1", "--set", "output.every=0.05", "--set", "output.frames=true"]
        coarse = self.run_case("coarse", [*vortices, "--set", "particles.spacing=0.04", "--set", "time.end=0.1"])
        frame = coarse.name + "/" + listed_frames(coarse)[-1]["name"]
        fine = [*vortices, "--set", "particles.spacing=0.02", "--set", "time.end=0.01", "--set", f"initial.from={frame}"]
        said = self.coronet("check", *fine[:1], *fine[3:]).stdout
        self.assertIn(f"are those of {frame}, not the case's formulas: its 625 particles at 0.1 s", said)
        run = self.run_case("fine", fine)
        end, start = read_series(coarse)[-1], read_series(run)[0]
        self.assertAlmostEqual(float(start["kinetic_energy"]) / float(end["kinetic_energy"]), 1, delta=0.01)
        self.assertEqual((start["time"], start["particles"]), ("0", "2500"))
        shutil.rmtree(coarse)
        again = self.run_case("again", [run / "case.toml", "--threads", "1"])
        for file in ("case.toml", "initial.vtkhdf", "series.csv"):
            self.assertEqual((again / file).read_bytes(), (run / file).read_bytes(), file)
        last = f"initial.from={run.name}/{listed_frames(run)[-1]['name']}"  # of the run that this one replaces
        self.run_case("fine", [*fine, "--set", last], "--overwrite")
        self.assertNotEqual((again / "initial.vtkhdf").read_bytes(), (run / "initial.vtkhdf").read_bytes())


if __name__ == "__main__":
    unittest.main()
