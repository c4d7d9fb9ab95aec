# SPDX-License-Identifier: BSD-3-Clause
"""A column that collapses: its front, and the pressure at sensors, beside what was measured and computed elsewhere."""
import csv

import numpy
from matplotlib.figure import Figure

from coronet_plot import style

# Tables of cases/reference: label, marker, and how the measures of a run call it where its zero of time is not known.
FRONTS = {
    "dambreak_martin_moyce1952_a1125": ("Martin and Moyce (1952), 1.125 in", "^", "martin_moyce_1125"),
    "dambreak_martin_moyce1952_a225": ("Martin and Moyce (1952), 2.25 in", "v", "martin_moyce_225"),
    "dambreak_martin_moyce1952_square": ("Martin and Moyce (1952), 2.25 in", "v", "martin_moyce_square"),
    "dambreak_koshizuka_oka1996_front": ("Koshizuka and Oka (1996)", "D", "koshizuka"),
    "dambreak_lobovsky2014_front_H300": ("Lobovsky et al. (2014)", "o", None),
    "dambreak_lobovsky2014_front_H600": ("Lobovsky et al. (2014)", "o", None),
}
PRESSURES = {  # a line where it was computed
    **{f"dambreak_lobovsky2014_{at}": ("Lobovsky et al. (2014), measured", "o") for at in ("P1", "P3", "P4")},
    **{f"dambreak_decourcy2024_{at}": ("De Courcy et al. (2024), computed", "-") for at in ("P1", "P3", "P4")},
    "dambreak_buchner2002_pressure": ("Buchner (2002), measured", "s"),
}
# Height above the floor and width of the sensors of those tables, over H.
SENSORS = {"P1": (0.01, 0.014), "P3": (0.1, 0.014), "P4": (0.267, 0.014), "buchner": (0.267, 0.15)}


def number(run, text):
    """A formula that is a number or a parameter; cases of this kind have no others."""
    parameters = run.case.get("parameters", {})
    return float(parameters.get(text, text) if isinstance(text, str) else text)


def probes(run, kind):
    return [probe for probe in run.case["probes"] if probe["kind"] == kind]


def profiles(run):
    """The tables that a run was compared with: times and values of each."""
    tables = {}
    path = run.directory / "profiles.csv"
    if path.is_file():
        with path.open(newline="") as file:
            for row in csv.DictReader(file):
                tables.setdefault(row["profile"], []).append((float(row["position"]), float(row["reference"])))
    return {name: numpy.array(points).T for name, points in tables.items()}


def smoothed(time, values, width=0.2):
    """Means over a width of time."""
    return numpy.array([values[abs(time - t) <= width / 2].mean() for t in time])


def front(axes, runs, tables):
    probe = probes(runs[0], "dam-break")[0]
    height, width = number(runs[0], probe["depth"]), number(runs[0], probe["width"])
    g = -runs[0].case["fluid"]["gravity"][1]
    for run, colour, _, label in style.styles(runs):
        axes.plot(run.series["time"] * numpy.sqrt(2 * g / width), run.series["front"] / width, color=colour, lw=1.4,
                  label=f"{label}, {run.spacing:g} m")
    for table in [table for table in tables if table in FRONTS]:
        (time, values), (label, marker, name) = tables[table], FRONTS[table]
        late = runs[0].measures.get(f"front_late_{name}", {}).get("value")
        if late is not None:
            axes.plot(time - late, values, marker, color=style.GREY, ms=2, zorder=4)
            label += f"; small: if {late:.2f} late"
        axes.plot(time, values, marker, color=style.GREY, ms=4, mfc="white", label=label, zorder=5)
    axes.axvline(2.5 * numpy.sqrt(height / width), color=style.GREY, lw=0.7, ls=":")
    measured = [time[-1] for name, (time, _) in tables.items() if name in FRONTS]
    if measured: axes.set_xlim(0, 1.1 * max(measured))
    axes.set_xlabel(r"$t\,(2g/W)^{1/2}$")
    axes.set_ylabel("front over the width of the column")


def pressure(axes, runs, tables, probe, wanted):
    fluid, height = runs[0].case["fluid"], number(runs[0], probe["depth"])
    g = -fluid["gravity"][1]
    for run, colour, _, label in style.styles(runs):
        if not run.has(probe["name"]): continue
        time = run.series["time"] * numpy.sqrt(g / height)
        values = run.series[probe["name"]] / (float(fluid["density"]) * g * height)
        axes.plot(time, values, color=colour, lw=0.5, alpha=0.25)
        axes.plot(time, smoothed(time, values), color=colour, lw=1.4, label=f"{label}, {run.spacing:g} m, mean over 0.2")
    for table in [table for table in tables if table in PRESSURES and wanted in table]:
        (time, values), (label, marker) = tables[table], PRESSURES[table]
        colour = style.INK if marker == "-" else style.GREY
        axes.plot(time, values, marker, color=colour, lw=1.2, ms=4, mfc="white", label=label, zorder=5)
    axes.set_xlim(left=2)
    axes.set_ylim(-0.5, 3 if wanted == "P1" else 1.5)
    axes.set_xlabel(r"$t\,(g/H)^{1/2}$")
    axes.set_ylabel(rf"pressure over $\rho g H$, {probe['at'][1] / height:.3g} $H$ above the floor")


def sensor(run, probe):
    """Which of the sensors a probe is; None if it is another."""
    place = numpy.array([probe["at"][1], probe["sensor_width"]]) / number(run, probe["depth"])
    return next((name for name, known in SENSORS.items() if numpy.abs(place - known).max() < 0.005), None)


def dam_break(runs):
    """A panel for the front, and one for each sensor that has a table to stand beside."""
    tables = profiles(runs[0])
    panels = [lambda axes: front(axes, runs, tables)]
    for probe in probes(runs[0], "impact"):
        wanted = sensor(runs[0], probe)
        if wanted and any(name in PRESSURES and wanted in name for name in tables):
            panels.append(lambda axes, probe=probe, wanted=wanted: pressure(axes, runs, tables, probe, wanted))
    columns = min(2, len(panels))
    rows = -(-len(panels) // columns)
    drawing = Figure(figsize=(6.0 * columns, 3.8 * rows), layout="constrained")
    for k, panel in enumerate(panels):
        axes = drawing.add_subplot(rows, columns, k + 1)
        panel(axes)
        axes.legend()
    drawing.suptitle(style.about(runs), fontsize=10, weight="bold")
    return drawing
