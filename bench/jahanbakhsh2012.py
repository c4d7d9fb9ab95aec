#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The rotating square patch of Jahanbakhsh et al. (2012), section VII.A, with every shifting and two artificial viscosities (the paper
does not say how much), put into tables.

    /usr/bin/python3 bench/jahanbakhsh2012.py [--keep]

Runs go to runs/jahanbakhsh2012/; with --keep those already there are not run again. The program is build/release/coronet,
or what the environment variable CORONET names. `coronet plot` of one with the others draws the picture.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
RUNS = ROOT / "runs" / "jahanbakhsh2012"
OMEGA, SIDE, DENSITY, WHOLE = 5.0, 1.0, 1000.0, 2.0  # the last is the omega t up to which theory is compared
keep = "--keep" in sys.argv
reference = np.genfromtxt(ROOT / "cases/reference/square_patch_history.csv", delimiter=",", names=True, skip_header=5)


def run(name, **settings):
    """The series and the summary of a run."""
    directory = RUNS / name
    if not (keep and (directory / "summary.json").exists()):
        words = [os.environ.get("CORONET", str(ROOT / "build/release/coronet")), "run", "square-patch-shifting", "--quiet",
                 "--out", str(directory), "--overwrite"]
        for key, value in settings.items():
            words += ["--set", f"{key.replace('__', '.')}={value}"]
        subprocess.run(words, stdout=subprocess.DEVNULL)
    summary = json.loads((directory / "summary.json").read_text())
    return np.genfromtxt(directory / "series.csv", delimiter=",", names=True), summary


def errors(series):
    """To omega t = 2: of the centre pressure, rms over |p(0)|; of corner and side radii and angular momentum, the largest."""
    shown = OMEGA * series["time"] <= WHOLE + 1e-9
    wt = OMEGA * series["time"][shown]
    scale = DENSITY * (OMEGA * SIDE) ** 2
    exact = {name: np.interp(wt, reference["wt"], reference[name]) for name in ("p_centre", "r_corner_exact", "r_min")}
    pressure = series["centre_pressure"][shown] / scale - exact["p_centre"]
    radii = [np.max(np.abs(series[column][shown] / exact[name] / SIDE - 1))
             for column, name in (("corner_radius", "r_corner_exact"), ("side_half_width", "r_min"))]
    L = series["angular_momentum_z"][shown]
    return np.sqrt(np.mean(pressure**2)) / abs(exact["p_centre"][0]), *radii, np.max(np.abs(L / L[0] - 1))


print(f"{'':20s}{'at 0.245 s':^26s}{'at 0.49 s':^26s}{'to omega t = 2: largest error':>36s}")
print(f"{'alpha':6s}{'shifting':14s}" + 2 * f"{'least':>8s}{'pieces':>8s}{'area':>9s} "
      + f"{'pressure':>10s}{'corner':>8s}{'side':>8s}{'torque':>10s}")
for alpha in (0.02, 0.1):
    for shifting in ("none", "xu", "jahanbakhsh", "sun"):
        series, summary = run(f"{shifting}_{alpha}", method__shifting=shifting, method__artificial_viscosity=alpha)
        line = f"{alpha:<6g}{shifting:14s}"
        for time in (0.245, 0.49):
            row = series[np.argmin(np.abs(series["time"] - time))]
            line += f"{row['spacing_min']:8.3f}{row['fragments']:8.0f}{100 * (row['area'] / series['area'][0] - 1):8.2f}% "
        pressure, corner, side, torque = errors(series)
        print(f"{line}{100 * pressure:9.2f}%{100 * corner:7.2f}%{100 * side:7.2f}%{100 * torque:9.3f}%"
              + ("" if summary["status"] == "done" else f"  {summary['status']} at {series['time'][-1]:.4f} s"), flush=True)
