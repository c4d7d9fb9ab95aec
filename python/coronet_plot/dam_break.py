# SPDX-License-Identifier: BSD-3-Clause
"""A column that collapses: its front, or the pressure at a sensor, beside what was measured and computed elsewhere."""
import csv

import numpy
from matplotlib.figure import Figure

from coronet_plot import style

TABLES = {  # of cases/reference: label and marker; a line where it was computed
    "dambreak_martin_moyce1952_a1125": ("Martin and Moyce (1952), 1.125 in", "^"),
    "dambreak_martin_moyce1952_a225": ("Martin and Moyce (1952), 2.25 in", "v"),
    "dambreak_koshizuka_oka1996_front": ("Koshizuka and Oka (1996)", "D"),
    "dambreak_lobovsky2014_P1": ("Lobovsky et al. (2014), measured", "o"),
    "dambreak_decourcy2024_P1": ("De Courcy et al. (2024), computed", "-"),
}


def number(run, text):
    """A formula that is a number or a parameter; cases of this kind have no others."""
    parameters = run.case.get("parameters", {})
    return float(parameters.get(text, text) if isinstance(text, str) else text)


def profiles(run):
    tables = {}
    path = run.directory / "profiles.csv"
    if path.is_file():
        with path.open(newline="") as file:
            for row in csv.DictReader(file):
                tables.setdefault(row["profile"], []).append((float(row["position"]), float(row["reference"])))
    return {name: numpy.array(points).T for name, points in tables.items() if name in TABLES}


def smoothed(time, values, width=0.2):
    """Means over a width of time."""
    return numpy.array([values[abs(time - t) <= width / 2].mean() for t in time])


def dam_break(runs):
    first = runs[0]
    probe = next(probe for probe in first.case["probes"] if probe["kind"] == "dam-break")
    height, width = number(first, probe["depth"]), number(first, probe["width"])
    g = -first.case["fluid"]["gravity"][1]
    tall = height > width
    drawing = Figure(figsize=(6.0, 3.8))
    axes = drawing.add_subplot()
    for run, colour, _, label in style.styles(runs):
        time = run.series["time"]
        if tall:
            axes.plot(time * numpy.sqrt(2 * g / width), run.series["front"] / width, color=colour, lw=1.4,
                      label=f"{label}, {run.spacing:g} m")
        else:
            pressure = run.series["sensor_pressure"] / (float(first.case["fluid"]["density"]) * g * height)
            time = time * numpy.sqrt(g / height)
            axes.plot(time, pressure, color=colour, lw=0.5, alpha=0.25)
            axes.plot(time, smoothed(time, pressure), color=colour, lw=1.4,
                      label=f"{label}, {run.spacing:g} m, mean over 0.2")
    for name, (time, values) in profiles(first).items():
        label, marker = TABLES[name]
        if marker == "-":
            axes.plot(time, values, color=style.INK, lw=1.2, label=label, zorder=5)
        else:
            axes.plot(time, values, marker, color=style.GREY, ms=4, mfc="white", label=label, zorder=4)
    if tall:
        axes.axvline(2.5 * numpy.sqrt(height / width), color=style.GREY, lw=0.7, ls=":")
        axes.set_xlabel(r"$t\,(2g/W)^{1/2}$")
        axes.set_ylabel("front over the width of the column")
    else:
        axes.set_xlim(left=2)
        axes.set_ylim(-0.5, 4)
        axes.set_xlabel(r"$t\,(g/H)^{1/2}$")
        axes.set_ylabel(r"pressure at the sensor over $\rho g H$")
    axes.legend()
    drawing.suptitle(style.about(runs), fontsize=10, weight="bold")
    return drawing
