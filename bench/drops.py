#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Drops that oscillate, fly and rest, by projection and weakly compressible in either kind of steps: the tables of docs/validation.md.

    /usr/bin/python3 bench/drops.py [oscillating] [flying] [large] [resting] [space] [creeping] [--finest N] [--keep]

oscillating: period and damping of modes 2 to 4 in 2D, particles jittered and the axis turned by 17 degrees; flying: what offset and
boost leave of momentum and angular momentum over 10 periods; large: amplitude 30 % over 10 periods; resting: pressure and
spurious speeds; space: mode 2 in 3D; creeping: drops at rest in 3D, and how their spurious speeds fall in time. None of these words is all of them. N is the largest number of particles per radius (default 40).
Runs go to runs/drops/, each on one thread; with --keep those already there are not run again. The program is build/release/coronet,
or what the environment variable CORONET names.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
RUNS = ROOT / "runs" / "drops"
CORONET = os.environ.get("CORONET", str(ROOT / "build/release/coronet"))
keep = "--keep" in sys.argv
finest = int(sys.argv[sys.argv.index("--finest") + 1]) if "--finest" in sys.argv else 40

RADIUS, DENSITY, TENSION = 5.7547e-3, 1000, 7.2e-3  # of the case oscillating-drop: m, kg/m^3, N/m
SPEED = (TENSION / (DENSITY * RADIUS)) ** 0.5
TIME = RADIUS / SPEED
PERIODS = {2: 2.59 * TIME, 3: 1.31 * TIME, 4: 0.835 * TIME}  # at the Ohnesorge number 0.05
SYMPLECTIC = {"time.stepping": "symplectic-euler", "time.courant": 0.6}
COMPRESSIBLE = {"method.scheme": "weakly-compressible", "initial.pressure": TENSION / RADIUS, "fluid.sound_speed": 15 * SPEED}
SCHEMES = {"projection": {}, "weakly compressible": COMPRESSIBLE, "weakly compressible, symplectic": {**COMPRESSIBLE, **SYMPLECTIC}}


def has_ended(directory):
    summary = directory / "summary.json"
    return summary.exists() and json.loads(summary.read_text())["status"] == "done"


class Run:
    def __init__(self, name, case, settings):
        self.directory = RUNS / name.replace(",", "").replace(" ", "-")
        if not (keep and has_ended(self.directory)):
            words = [CORONET, "run", case, "--quiet", "--threads", "1", "--out", str(self.directory), "--overwrite"]
            for key, value in settings.items():
                words += ["--set", f"{key}={value}"]
            subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        self.summary = json.loads((self.directory / "summary.json").read_text())
        self.series = np.genfromtxt(self.directory / "series.csv", delimiter=",", names=True)

    def error(self, measure):
        return f"{100 * self.summary['measures'][measure]['error']:+.2f} %"

    def value(self, measure):
        return f"{self.summary['measures'][measure]['value']:.1e}"

    def angular_drift(self):
        """Largest change of the angular momentum, over mass times radius times the capillary speed."""
        L = self.series["angular_momentum_z"]
        return f"{np.abs(L - L[0]).max() / (self.series['mass'][0] * RADIUS * SPEED):.1e}"


def flat(scheme, per_radius, ohnesorge=0.05, **changes):
    """Settings of the case oscillating-drop."""
    return {**SCHEMES[scheme], "particles.spacing": RADIUS / per_radius,
            "fluid.viscosity": ohnesorge * (DENSITY * TENSION * RADIUS) ** 0.5, "output.frames": "false",
            **{key.replace("__", "."): value for key, value in changes.items()}}


def oscillating():
    print("| scheme | Ohnesorge number | mode | particles per radius | period | damping rate | steps |\n" + "|---" * 7 + "|")
    for scheme in SCHEMES:
        for mode in PERIODS:
            for ohnesorge in (0.05, 0.01):
                for n in {(2, 0.05): (20, 40), (2, 0.01): (20, 40, 80)}.get((mode, ohnesorge), (40,)):
                    if n > finest or scheme == "weakly compressible" and n > 40:  # left out: hours
                        continue
                    run = Run(f"{scheme} Oh {ohnesorge} mode {mode} {n}", "oscillating-drop",
                              flat(scheme, n, ohnesorge, drop__mode=mode, probes__1__mode=mode, particles__jitter=0.1,
                                   shapes__0__rotation=17, time__end=3.1 * PERIODS[mode], output__series_every=PERIODS[mode] / 100))
                    print(f"| {scheme} | {ohnesorge} | {mode} | {n} | {run.error('period')} | {run.error('damping_rate')} "
                          f"| {run.summary['steps']} |", flush=True)


def flying():
    print("| scheme | centre, off its straight line | momentum | angular momentum |\n" + "|---" * 4 + "|")
    for scheme in SCHEMES:
        run = Run(f"{scheme} flying", "oscillating-drop",
                  flat(scheme, 20, particles__jitter=0.1, shapes__0__rotation=17, shapes__0__centre=[RADIUS, 2 * RADIUS],
                       initial__velocity=[SPEED, -SPEED / 2], time__end=10 * PERIODS[2]))
        print(f"| {scheme} | {run.value('centre_drift')} | {run.value('momentum_drift')} | {run.angular_drift()} |", flush=True)


def large():
    print("| scheme | area, at most | amplitude, of the start, in the last period | energy drift |\n" + "|---" * 4 + "|")
    for scheme in SCHEMES:
        run = Run(f"{scheme} large", "oscillating-drop",
                  flat(scheme, 20, drop__amplitude=0.3, particles__jitter=0.1, shapes__0__rotation=17, time__end=10 * PERIODS[2]))
        last = run.series["time"] > 9 * PERIODS[2]
        left = np.abs(run.series["mode_amplitude"][last]).max() / run.series["mode_amplitude"][0]
        print(f"| {scheme} | {run.error('area_error_max')} | {left:.4f} | {run.value('energy_drift')} |", flush=True)


def resting():
    print("| | particles per radius | mean pressure | spurious capillary number, second half | circularity | centre |\n" + "|---" * 6 + "|")
    jittered = {"particles.jitter": 0.1, "method.shifting": "conserving", "method.shift_range": 0.8}
    projection = {**jittered, "method.scheme": "projection", "initial.pressure": 0, "method.compact_share": 0.02}
    starts = {"shells": {}, "jittered": jittered, "jittered, symplectic": {**jittered, **SYMPLECTIC}, "jittered, projection": projection}
    for n, start, changes in [(n, *start) for n in (20, 40) for start in starts.items()]:
        if n > finest or start == "jittered" and n > 20:  # left out: more than an hour
            continue
        run = Run(f"resting 2D {n} {start}", "static-drop",
                  {"dimension": 2, "initial.pressure": 70, "particles.spacing": 1e-3 / n, "time.end": 0.378, "output.frames": "false",
                   "output.series_every": 1e-3, **changes})
        print(f"| 2D, {start} | {n} | {run.error('laplace_pressure')} | {run.value('spurious_capillary_number')} "
              f"| {run.error('circularity_final')} | {run.value('centre_drift')} |", flush=True)


def space():
    projection = {"method.scheme": "projection", "initial.pressure": 0, "method.compact_share": 0.02, "time.end": 0.0262}
    print("| scheme, 3D | particles per radius | period | damping rate | centre | momentum | steps |\n" + "|---" * 7 + "|")
    compressible = {"time.end": 0.027}
    for scheme, changes in {"projection": projection, "weakly compressible": compressible,
                            "weakly compressible, symplectic": {**compressible, **SYMPLECTIC}}.items():
        for n in (10, 14, 20):
            if n > finest:
                continue
            run = Run(f"{scheme} 3D {n}", "oscillating-drop-3d", {**changes, "particles.spacing": 1e-3 / n, "output.frames": "false"})
            print(f"| {scheme} | {n} | {run.error('period')} | {run.error('damping_rate')} | {run.value('centre_drift')} "
                  f"| {run.value('momentum_drift')} | {run.summary['steps']} |", flush=True)


def creeping():
    projection = {"method.scheme": "projection", "initial.pressure": 0, "method.compact_share": 0.02}
    time = (1000 * 1e-9 / 0.07) ** 0.5  # sqrt(rho R^3/sigma) of the case static-drop [s]
    spans = (0.5, 2.6), (2.6, 5), (5, 10), (10, 20), (20, 30), (30, 50), (50, 101)
    print("| 3D, at rest | particles per radius | mean pressure | spurious capillary number, second half | circularity | centre "
          + "".join(f"| mean from {a:g} to {min(b, 100):g} " for a, b in spans) + "|\n" + "|---" * 13 + "|")
    for n, scheme, changes in ((7, "projection", projection), (8, "projection", projection), (10, "projection", projection),
                               (10, "weakly compressible", {}), (20, "projection", projection), (20, "weakly compressible, symplectic", SYMPLECTIC)):
        if n > finest:
            continue
        run = Run(f"resting 3D {n} {scheme}", "static-drop", {"particles.spacing": 1e-3 / n, "time.end": 0.378, "output.series_every": 1e-3, **changes})
        t, number = run.series["time"] / time, 0.0264575 / 0.07 * run.series["spurious_speed"]
        means = "".join(f"| {number[(t >= a) & (t < b)].mean():.1e} " for a, b in spans)
        print(f"| {scheme} | {n} | {run.error('laplace_pressure')} | {run.value('spurious_capillary_number')} "
              f"| {run.error('circularity_final')} | {run.value('centre_drift')} {means}|", flush=True)


TABLES = {table.__name__: table for table in (oscillating, flying, large, resting, space, creeping)}
for name in [word for word in sys.argv[1:] if word in TABLES] or TABLES:
    TABLES[name]()
