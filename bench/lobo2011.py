#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The square drop of Lobo (2011), section 4.3: his scheme made to hold, his three experiments against it (Figs 4.8 to 4.10), and his
scheme as printed; a table of how they go wrong, and a picture of all, runs/lobo2011/experiments.png.

    /usr/bin/python3 bench/lobo2011.py [--keep]

Runs go to runs/lobo2011/; with --keep those already there are not run again. The program is build/release/coronet, or what the
environment variable CORONET names.
"""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "python"))
from coronet_plot.frame import read_frame  # noqa: E402
from coronet_plot.pictures import Scale, draw_particles  # noqa: E402
from coronet_plot.run import Run  # noqa: E402
from coronet_plot.style import PRESSURE_MAP  # noqa: E402

RUNS = ROOT / "runs" / "lobo2011"
CORONET = os.environ.get("CORONET", str(ROOT / "build/release/coronet"))
keep = "--keep" in sys.argv

HELD = {"surface.tension_force": "curvature", "surface.coverage_radius": 1.2, "method.shifting": "none", "method.central_share": 0,
        "method.pressure_operator": "thesis", "method.lattice_diagonal": "true", "method.preconditioner": "jacobi",
        "method.tolerance": 1e-6, "method.artificial_viscosity": 1e-4, "method.artificial_viscosity_beta": 0,
        "fluid.sound_speed": 120, "time.step": "auto", "time.end": 0.3, "output.every": 0.02}
EXPERIMENTS = {
    "held": {},
    "1 zero pressure": {"surface.pressure": "zero", "time.end": 0.08},  # bursts, and then takes ever smaller steps
    "2 no viscosity": {"method.artificial_viscosity": 0},
    "3 w6": {"method.pressure_kernel": "w6"},
    "as printed": {"method.lattice_diagonal": "false", "method.artificial_viscosity": 1e-6, "surface.fit_weights": "none",
                   "time.end": 0.08},
}
SIDE, TENSION = 0.0102, 7.2e-3  # m, N/m
SHOWN = {"held": (0.1, 0.2, 0.3), "1 zero pressure": (0.02, 0.04, 0.06), "2 no viscosity": (0.1, 0.2, 0.3),
         "3 w6": (0.1, 0.2, 0.3), "as printed": (0.02, 0.04, 0.06)}  # s


def run(name, changes):
    """The series of a run."""
    directory = RUNS / name.replace(" ", "-")
    if not (keep and (directory / "summary.json").exists()):
        words = [CORONET, "run", "square-droplet", "--quiet", "--out", str(directory), "--overwrite"]
        for key, value in {**HELD, **changes}.items():
            words += ["--set", f"{key}={value}"]
        subprocess.run(words, stderr=subprocess.DEVNULL)
    return directory, np.genfromtxt(directory / "series.csv", delimiter=",", names=True)


print(f"{'':18s}{'least spacing':>14s}{'1 % below':>11s}{'most voids':>12s}{'area':>9s}{'kinetic energy (J/m)':>22s}  bursts at")
directories = []
for name, changes in EXPERIMENTS.items():
    directory, series = run(name, changes)
    directories.append(str(directory))
    # A drop at rest has its surface energy; with more than that in motion it has burst.
    burst = np.nonzero(series["kinetic_energy"] > 4 * SIDE * TENSION)[0]
    whole = series[: burst[0] + 1] if burst.size else series
    print(f"{name:18s}{whole['spacing_min'].min():14.3f}{whole['spacing_p01'].min():11.3f}{whole['voids'].max():12.0f}"
          f"{100 * (whole['area'][-1] / SIDE**2 - 1):8.1f}%{series['kinetic_energy'].max():22.2g}  "
          + (f"{series['time'][burst[0]]:.3f} s" if burst.size else f"not to {series['time'][-1]:.2f} s"), flush=True)
drawing = Figure(figsize=(7.5, 11), dpi=150, layout="constrained")
axes = drawing.subplots(len(SHOWN), 3)
scale = Scale.between(0, 3 * TENSION / SIDE, np.array([0.0, 3 * TENSION / SIDE]), PRESSURE_MAP)
for row, (name, times), directory in zip(axes, SHOWN.items(), directories):
    run_of = Run(directory)
    known = [time for time, _ in run_of.frames]
    for place, time in zip(row, times):
        frame = read_frame(run_of, *run_of.frames[int(np.argmin(np.abs(np.array(known) - time)))])
        draw_particles(place, frame, scale, 0.95)
        place.set(xlim=(-0.009, 0.009), ylim=(-0.008, 0.008), xticks=[], yticks=[], title=f"{name}, {1000 * frame.time:.0f} ms")
scale.bar(drawing, ax=axes, shrink=0.5)
drawing.savefig(RUNS / "experiments.png")
