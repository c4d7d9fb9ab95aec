# SPDX-License-Identifier: BSD-3-Clause
"""What every run and every `value` probe has to show over time: panels above each other, a column each."""
import numpy

from coronet_plot import curves, style

UNITS = {"pressure": "Pa", "density": "kg/m³", "speed": "m/s"}


def history(runs):
    """The two columns that tell a calm run from one that goes wrong."""
    drawing, (energy, spacing) = curves.stacked(2)
    unit = "J" if runs[0].case.get("dimension") == 3 else "J/m"
    scale = draw(energy, runs, "kinetic_energy", "kinetic energy", unit)
    draw(spacing, runs, "spacing_min", "smallest distance\nover the initial spacing")
    keep_small(energy, scale * column(runs, "kinetic_energy"))
    spacing.set_ylim(0, 1.05 * max(1.0, spacing.get_ylim()[1]))
    finish(drawing, [energy, spacing], runs)
    return drawing


def values(runs):
    """A panel for each probe of the first run; the others are in it where they have one of that name."""
    probes = runs[0].value_probes
    drawing, panels = curves.stacked(len(probes))
    for axes, probe in zip(panels, probes):
        draw(axes, runs, probe["name"], probe["field"], UNITS.get(probe["field"]))
        factor, unit = style.length(probe.get("at", []))
        place = ", ".join(f"{factor * x:.4g}" for x in probe.get("at", []))
        axes.set_title(f"{probe['name']}, at ({place}) {unit}", loc="left", fontsize=9)
    finish(drawing, panels, runs)
    return drawing


def column(runs, name):
    """The samples of all runs that have it."""
    return numpy.concatenate([run.series[name] for run in runs if run.has(name)])


def draw(axes, runs, name, label, unit=None):
    # A thousand kilograms are no "kkg".
    scale, unit = (1.0, unit) if unit in (None, "kg/m³") else style.prefixed(column(runs, name), unit)
    curves.compare(axes, runs, name, curves.time_axis(axes, runs), scale)
    axes.set_ylabel(f"{label} ({unit})" if unit else label)
    return scale


def keep_small(axes, found):
    """A run that blows up at its end must not flatten what was before."""
    found = found[numpy.isfinite(found)]
    usual = numpy.percentile(found, 98) if found.size else 0
    if 0 < 5 * usual < found.max():
        axes.set_ylim(-0.1 * usual, 2 * usual)


def finish(drawing, panels, runs):
    """The time is named once, below; so are the runs, above, where there is more than one to tell apart."""
    for axes in panels[:-1]:
        axes.set_xlabel(None)
    if len(runs) > 1:
        panels[0].legend()
    drawing.suptitle(style.about(runs), fontsize=10, weight="bold")
