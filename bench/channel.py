#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plane Poiseuille flow of every liquid, and the start-up of Poiseuille and Couette flow: prints the tables of docs/validation.md.

    /usr/bin/python3 bench/channel.py [--keep]

Runs go to runs/channel/; with --keep those already there are not run again. The program is build/release/coronet, or what the
environment variable CORONET names.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
RUNS = ROOT / "runs" / "channel"
CORONET = os.environ.get("CORONET", str(ROOT / "build/release/coronet"))
keep = "--keep" in sys.argv

THINNING = {"zero_shear_viscosity": 1, "infinite_shear_viscosity": 0.1, "time_constant": 1}
LIQUIDS = {
    "newtonian": {"rheology": "newtonian"},
    "carreau-yasuda": {"rheology": "carreau-yasuda", **THINNING, "yasuda_exponent": 2, "power_index": 0.5},
    "cross": {"rheology": "cross", **THINNING, "cross_exponent": 0.5},
    "power-law, n 0.5": {"rheology": "power-law", "consistency": 1, "power_index": 0.5},
    "power-law, n 1.5": {"rheology": "power-law", "consistency": 1, "power_index": 1.5},
    "casson, yield stress 0.05": {"rheology": "casson", "plastic_viscosity": 1, "yield_stress": 0.05, "regularisation": 1e4},
    "casson, yield stress 0.25": {"rheology": "casson", "plastic_viscosity": 1, "yield_stress": 0.25, "regularisation": 1e4},
    "bingham, yield stress 0.3": {"rheology": "bingham", "plastic_viscosity": 1, "yield_stress": 0.3, "regularisation": 1e4},
    "herschel-bulkley, n 0.5, yield stress 0.3": {"rheology": "herschel-bulkley", "consistency": 1, "power_index": 0.5,
                                                  "yield_stress": 0.3, "regularisation": 1e4},
}
START = {"probes.0.flow": "from-rest", "time.settled": 0, "time.end": 1}
COUETTE = {"parameters.force": 0, "parameters.upper": 1, "fluid.sound_speed": 10}


def has_ended(directory):
    summary = directory / "summary.json"
    return summary.exists() and json.loads(summary.read_text())["status"] == "done"


def run(name, settings):
    """The directory of a run of the case channel with some keys changed."""
    directory = RUNS / name.replace(", ", "-").replace(" ", "-")
    if not (keep and has_ended(directory)):
        words = [CORONET, "run", "channel", "--quiet", "--out", str(directory), "--overwrite"]
        for key, value in settings.items():
            words += ["--set", f"{key}={value}"]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    return directory


print("| liquid | error | steps |\n|---|---|---|")
for name, liquid in LIQUIDS.items():
    settings = {f"fluid.{key}": value for key, value in liquid.items()}
    summary = json.loads((run(name, {"method.viscous_step": "implicit", **settings}) / "summary.json").read_text())
    print(f"| {name} | {100 * summary['measures']['velocity_error_rms']['error']:.2f} % | {summary['steps']} |", flush=True)

print("\n| from rest | 0.1 s | 0.2 s | 0.4 s | 0.8 s |\n|---|---|---|---|---|")
for name, settings in {"Poiseuille": START, "Couette": {**START, **COUETTE}}.items():
    series = np.genfromtxt(run(name, settings) / "series.csv", delimiter=",", names=True)
    found = (series["velocity_error"][int(np.argmin(np.abs(series["time"] - t)))] for t in (0.1, 0.2, 0.4, 0.8))
    print(f"| {name} | " + " | ".join(f"{100 * error:.2f} %" for error in found) + " |", flush=True)
