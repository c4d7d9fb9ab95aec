#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Midlines of lid-driven cavities beside tabulated ones, as a table and a picture.

    /usr/bin/python3 bench/cavity.py PICTURE.png RUN...

Each RUN is a directory of `coronet run cavity`. Printed are the errors at the end and the mean and largest over the last fifth of the run: particles
that move past the stations make them fluctuate.
"""
import csv
import json
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "python"))
from coronet_plot import style  # noqa: E402

import matplotlib.pyplot as plt  # noqa: E402

style.use()
figure, (left, right) = plt.subplots(1, 2, figsize=(7.2, 3.4))
print(f"{'run':24s}{'time':>8s}{'steps':>9s}{'u':>9s}{'v':>9s}   {'mean u':>9s}{'mean v':>9s}{'most u':>9s}{'most v':>9s}")
for colour, name in zip(style.COLOURS, sys.argv[2:]):
    run = Path(name)
    summary = json.loads((run / "summary.json").read_text())
    series = np.genfromtxt(run / "series.csv", delimiter=",", names=True)
    late = series[series["time"] >= 0.8 * series["time"][-1]]
    u, v = (late[c] for c in ("u_error", "v_error"))
    print(f"{run.name:24s}{series['time'][-1]:8.1f}{summary['steps']:9d}{u[-1]:9.4f}{v[-1]:9.4f}   "
          f"{u.mean():9.4f}{v.mean():9.4f}{u.max():9.4f}{v.max():9.4f}")
    with open(run / "profiles.csv") as file:
        rows = list(csv.DictReader(file))
    for axes, which in ((left, "u"), (right, "v")):
        x, found, known = (np.array([float(row[c]) for row in rows if row["profile"] == which])
                           for c in ("position", "computed", "reference"))
        order = np.argsort(x)
        axes.plot(x[order], found[order], color=colour, lw=1.2, label=run.name)
        axes.plot(x, known, "o", color=colour, ms=2.5, mfc="none", mew=0.6)
left.set(xlabel="y / side", ylabel="u / speed of the lid, on the vertical midline")
right.set(xlabel="x / side", ylabel="v / speed of the lid, on the horizontal midline")
left.legend(title="lines: runs; circles: tables")
figure.tight_layout()
figure.savefig(sys.argv[1])
