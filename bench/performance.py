#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""bench/performance.py [ratio] [fang] [threads] [growth] [memory]

Prints the figures of docs/performance.md that `coronet bench` alone does not: each part is run a few times, alternating
between what it compares, and medians are printed. Nothing else should run meanwhile. The environment variable CORONET
names the program (default build/release/coronet).
  ratio    cost of cph and fpm over sph on drop-stretching at spacing 0.005, sum of the phases without output, one thread
  fang     wall time of the run of Fang et al. (2009): 1961 particles, 10,000 steps, two threads, outputs included
  threads  two threads over one, 1e5 particles
  growth   time per particle evaluation from 1e5 to 4e6 particles, one thread
  memory   peak memory per particle between 1e5 and 1e6 particles, 3D, 75 neighbours
"""
import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

PROGRAM = os.environ.get("CORONET", str(Path(__file__).resolve().parents[1] / "build" / "release" / "coronet"))
REPEAT = 5
OUTPUT = {"samples", "frames"}


def run(case, threads, *settings):
    with tempfile.TemporaryDirectory() as folder:
        command = ["taskset", "-c", "0" if threads == 1 else "0,1", PROGRAM, "run", case, "--quiet", "--overwrite",
                   "--threads", str(threads), "--out", folder]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return json.loads((Path(folder) / "summary.json").read_text())


def bench(threads, particles, steps, dimension, gradient="sph", precision="double"):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "bench.json"
        subprocess.run(["taskset", "-c", "0" if threads == 1 else "0,1", PROGRAM, "bench", "--threads", str(threads),
                        "--particles", str(particles), "--steps", str(steps), "--dimension", str(dimension),
                        "--gradient", gradient, "--precision", precision, "--json", str(out)],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return json.loads(out.read_text())["rows"][0]


def interleaved(kinds, measure, repeat=REPEAT):
    """Measures every kind in turn, several times; the median of each."""
    values = {kind: [] for kind in kinds}
    for _ in range(repeat):
        for kind in kinds:
            values[kind].append(measure(kind))
    return {kind: statistics.median(found) for kind, found in values.items()}


def ratio():
    def seconds(gradient):
        phases = run("drop-stretching", 1, "particles.spacing=0.005", f"method.gradient={gradient}", "time.end=5e-5",
                     "output.frames=false", "output.series_every=5e-5")["seconds_per_phase"]
        return sum(value for name, value in phases.items() if name not in OUTPUT)

    cost = interleaved(["sph", "cph", "fpm"], seconds)
    print("gradient  seconds  over sph")
    for gradient, value in cost.items():
        print(f"{gradient:8}  {value:7.2f}  {value / cost['sph']:8.3f}")


def fang():
    wall = interleaved(["sph", "cph", "fpm"], lambda gradient: run(
        "drop-stretching", 2, "particles.spacing=0.04", f"method.gradient={gradient}")["wall_seconds"])
    print("gradient  wall seconds")
    for gradient, value in wall.items():
        print(f"{gradient:8}  {value:12.2f}")


def threads():
    print("dimension  gradient  one thread  two threads  ratio   (million evaluations/s)")
    for dimension in (2, 3):
        for gradient in ("sph", "fpm"):
            rate = interleaved([1, 2], lambda count: bench(count, 1e5, 20, dimension, gradient)["particle_evaluations_per_second"],
                               3)
            print(f"{dimension:9}  {gradient:8}  {rate[1] / 1e6:10.2f}  {rate[2] / 1e6:11.2f}  {rate[2] / rate[1]:5.2f}")


def growth():
    print("particles  neighbours  ns per evaluation")
    for particles in (1e4, 1e5, 1e6, 4e6):
        row = bench(1, particles, 30 if particles > 2e6 else 60, 3)
        print(f"{row['particles']:9}  {row['neighbours']:10.1f}  {1e9 / row['evaluations_per_second']:17.1f}")


def memory():
    small, large = (bench(1, particles, 30, 3) for particles in (1e5, 1e6))
    total = [row["particles"] * row["bytes_per_particle"] for row in (small, large)]
    print(f"bytes per particle: {small['bytes_per_particle']:.0f} at {small['particles']}, "
          f"{large['bytes_per_particle']:.0f} at {large['particles']}; "
          f"each further one {(total[1] - total[0]) / (large['particles'] - small['particles']):.0f}")


PARTS = {part.__name__: part for part in (ratio, fang, threads, growth, memory)}

if __name__ == "__main__":
    unknown = [name for name in sys.argv[1:] if name not in PARTS]
    if unknown:
        sys.exit(f"{unknown[0]} is none of {', '.join(PARTS)}\n\n{__doc__}")
    for name in sys.argv[1:] or PARTS:
        PARTS[name]()
