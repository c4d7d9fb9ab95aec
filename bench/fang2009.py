#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tests of Fang et al. (2009) and their sister in 3D, run in full and put into tables.

    /usr/bin/python3 bench/fang2009.py [stretching] [rotating] [patch] [spheroid] [--keep]

Runs go to runs/fang2009/; with --keep those already there are not run again. The program is build/release/coronet,
or what the environment variable CORONET names.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "bench"), str(ROOT / "python")]
RUNS = ROOT / "runs" / "fang2009"
METHODS = ("sph", "cph", "fpm")
keep = "--keep" in sys.argv


class Run:
    """A run of a case with some keys changed: its summary, series and frames."""

    def __init__(self, name, case, **settings):
        self.directory = RUNS / name
        self.failed = False
        if not (keep and (self.directory / "summary.json").exists()):
            words = [os.environ.get("CORONET", str(ROOT / "build/release/coronet")), "run", str(case), "--quiet",
                     "--out", str(self.directory), "--overwrite"]
            for key, value in settings.items():
                words += ["--set", f"{key.replace('__', '.')}={value}"]
            self.failed = subprocess.run(words, stdout=subprocess.DEVNULL).returncode != 0
        self.summary = json.loads((self.directory / "summary.json").read_text())
        self.series = np.genfromtxt(self.directory / "series.csv", delimiter=",", names=True)

    def measure(self, name):
        return self.summary["measures"][name]["value"]

    def momentum_error(self):
        """Largest drift of linear momentum over half of sqrt(2 m E), which stands for the sum of m |v|."""
        drift = max(np.abs(self.series[f"momentum_{k}"] - self.series[f"momentum_{k}"][0]).max() for k in "xyz"
                    if f"momentum_{k}" in self.series.dtype.names)
        # sum m |v| is sqrt(2 m E) for equal speeds and less for others, but more than half of it in these smooth flows.
        return drift / (0.5 * np.sqrt(2 * self.series["mass"][0] * self.series["kinetic_energy"].min()))

    def frame(self, time):
        """Positions at the frame nearest to a time, ordered by identity."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOHDF import vtkHDFReader

        frames = json.loads((self.directory / "frames.vtkhdf.series").read_text())["files"]
        nearest = min(frames, key=lambda entry: abs(entry["time"] - time))
        reader = vtkHDFReader()
        reader.SetFileName(str(self.directory / nearest["name"]))
        reader.Update()
        grid = reader.GetOutput()
        points = vtk_to_numpy(grid.GetPoints().GetData())
        ids = vtk_to_numpy(grid.GetPointData().GetArray("id"))
        return points[np.argsort(ids)][:, :2].copy()


def stretching():
    print("drop-stretching to 0.01 s, step 1e-6 s: largest error of the semi-axes, rms error of the centre pressure")
    print(f"{'':24s}{'semi-axes':>12s}{'pressure':>12s}{'momentum':>12s}{'wall s':>10s}")
    rows = [(f"{m} 0.02", dict(method__gradient=m)) for m in METHODS]
    rows += [("fpm 0.04", dict(particles__spacing=0.04)), ("fpm 0.01", dict(particles__spacing=0.01)),
             ("fpm 0.02, twice c", dict(fluid__sound_speed=2800, time__step=5e-7))]
    for name, settings in rows:
        run = Run("stretching " + name, "drop-stretching", **settings)
        print(f"{name:24s}{100 * run.measure('semi_axis_error_max'):11.4f}%{100 * run.measure('centre_pressure_error_rms'):11.3f}%"
              f"{run.momentum_error():12.1e}{run.summary['wall_seconds']:10.1f}")


DISORDERED = """
name = "ellipse-rotating"
title = "an ellipse, jittered, off-centre and boosted, turns and flies"
dimension = 2
[[shapes]]
kind = "ellipse"
centre = [0.7, -0.4]
semi_axes = [1.0, 0.6]
rotation = 20.0
[particles]
spacing = 0.04
jitter = 0.2
[initial]
velocity = ["0.3 + 0.1*(y + 0.4)", "0.2 - 0.1*(x - 0.7)"]
[fluid]
density = 1000.0
viscosity = 500.0
sound_speed = 14.0
[time]
end = 0.1
step = 1e-4
[[probes]]
kind = "angular-momentum"
"""


def rotating():
    print("drift of angular momentum to 0.1 s, relative; of linear momentum over sum m |v|")
    print(f"{'':44s}{'angular':>12s}{'linear':>12s}")
    case = RUNS / "ellipse.toml"
    case.parent.mkdir(parents=True, exist_ok=True)
    case.write_text(DISORDERED)
    for title, path, more in (("drop-rotating, lattice, step 1e-5", "drop-rotating", {}),
                              ("the same as printed (midpoint velocity)", "drop-rotating",
                               dict(time__position_update="midpoint-velocity")),
                              ("ellipse, jittered, off-centre, step 1e-4", case, {})):
        for method in METHODS:
            run = Run(f"{title} {method}", path, method__gradient=method, output__frames="false", **more)
            drift = run.series["angular_momentum_drift"]
            growth = "grows" if np.all(np.diff(drift[::20]) > 0) else ""
            print(f"{title + ', ' + method:44s}{np.max(drift):12.1e}{run.momentum_error():12.1e}  {growth}")


def patch():
    from square_patch_exact import REACH, clumping, fragments, square_lattice

    print("square-patch: share of particles nearer than half the exact local spacing, fragments, least spacing, area error")
    print(f"{'':34s}{'clumped':>9s}{'clumped':>9s}{'fragments':>10s}{'fragments':>10s}{'spacing_min':>12s}{'spacing_min':>12s}"
          f"{'area':>9s}{'momentum':>10s}")
    print(f"{'t in s':34s}{0.015:9.3f}{0.02:9.3f}{0.015:10.3f}{0.02:10.3f}{0.015:12.3f}{0.02:12.3f}{0.02:9.3f}")
    for viscosity in (0, 0.1):
        for angle in (0, 20, 45):
            for method in METHODS:
                run = Run(f"patch {angle} {viscosity} {method}", "square-patch", method__gradient=method,
                          particles__rotation=angle, method__artificial_viscosity=viscosity)
                spacing, side = 0.04, 2.04
                start = run.frame(0) / side
                steps = square_lattice(np.radians(angle), REACH)
                values = [clumping(start, run.frame(t) / side, spacing / side, 100 * t, steps) for t in (0.015, 0.02)]
                pieces = [fragments(run.frame(t), 3 * spacing) for t in (0.015, 0.02)]
                at = [np.argmin(abs(run.series["time"] - t)) for t in (0.015, 0.02)]
                least = run.series["spacing_min"][at]
                name = f"{angle:2d} degrees, alpha {viscosity}, {method}"
                print(f"{name:34s}{values[0]:9.3f}{values[1]:9.3f}{pieces[0]:10d}{pieces[1]:10d}{least[0]:12.3f}"
                      f"{least[1]:12.3f}{run.measure('area_error'):9.4f}{run.momentum_error():10.1e}"
                      + (f"  failed at {run.series['time'][-1]:.4f} s" if run.failed else ""))


def spheroid():
    print("spheroid-stretching, fpm, until the long axis has doubled")
    print(f"{'':12s}{'particles':>10s}{'stretch':>9s}{'worst axis':>12s}{'pressure':>10s}{'momentum':>10s}{'wall s':>8s}")
    for B, end in ((-50, 0.0089), (50, 0.01345)):
        run = Run(f"spheroid {B}", "spheroid-stretching", parameters__B=B, time__end=end, output__frames="false")
        last = run.series[-1]
        stretch = max(last[f"exact_semi_axis_{k}"] / run.series[0][f"exact_semi_axis_{k}"] for k in "xyz")
        print(f"B = {B:4d}    {run.summary['particles']:10d}{stretch:9.3f}{100 * run.measure('semi_axis_error_max'):11.3f}%"
              f"{100 * run.measure('centre_pressure_error_rms'):9.3f}%{run.momentum_error():10.1e}{run.summary['wall_seconds']:8.1f}")


parts = [stretching, rotating, patch, spheroid]
chosen = [part for part in parts if part.__name__ in sys.argv[1:]] or parts
for part in chosen:
    part()
    print(flush=True)
