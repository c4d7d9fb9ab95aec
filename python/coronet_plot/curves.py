# SPDX-License-Identifier: BSD-3-Clause
"""Curves against time: each run in its colour, the exact solution in black (Fang et al. 2009, Figs. 2-5)."""
import numpy
from matplotlib.figure import Figure

from coronet_plot import style

SIZE = (5.6, 3.6)


def figure():
    drawing = Figure(figsize=SIZE)
    return drawing, drawing.add_subplot()


def latest(runs):
    """The run that went furthest: its exact solution reaches as far as any."""
    return max(runs, key=lambda run: run.series["time"][-1])


def time_axis(axes, runs):
    end = latest(runs).series["time"][-1]
    factor, unit = style.prefixed(end, "s")
    axes.set_xlim(0, end * factor or 1)
    axes.set_xlabel(f"time ({unit})")
    return factor


def compare(axes, runs, column, factor, scale=1.0, named=True):
    """One column of every run over time, and under them the exact one of the run that went furthest."""
    furthest = latest(runs)
    if furthest.has("exact_" + column):
        axes.plot(factor * furthest.series["time"], scale * furthest.series["exact_" + column],
                  color=style.INK, lw=1.0, label="exact" if named else None, zorder=4)
    for k, (run, colour, marker, label) in enumerate(style.styles(runs)):
        time, values = factor * run.series["time"], scale * run.series[column]
        axes.plot(time, values, color=colour, lw=1.1, zorder=3)
        # A dozen markers each, which take turns along the curve so that none hides another.
        step = max(len(time) // 12, 1)
        some = slice(int(step * (k + 0.5) / len(runs)), None, step)
        axes.plot(time[some], values[some], marker, color=colour, ms=4.2, mfc="white", mew=1.2,
                  label=label if named else None, zorder=5)


def draw_semi_axes(axes, runs):
    factor = time_axis(axes, runs)
    shown = ["semi_axis_" + "xyz"[k] for k in runs[0].plane]
    for column in shown:
        compare(axes, runs, column, factor, named=column == shown[0])
        end = latest(runs).series["exact_" + column][-1]
        axes.annotate(f"$a_{column[-1]}$", (1, end), xycoords=("axes fraction", "data"), xytext=(6, 0),
                      textcoords="offset points", va="center", fontsize=10)
    axes.set_ylim(bottom=0)
    axes.set_ylabel("semi-axes (m)")


def draw_centre_pressure(axes, runs):
    factor = time_axis(axes, runs)
    exact = numpy.concatenate([run.series["exact_centre_pressure"] for run in runs])
    found = numpy.concatenate([run.series["centre_pressure"] for run in runs])
    scale, unit = style.prefixed(exact, "Pa")
    compare(axes, runs, "centre_pressure", factor, scale)
    # A few wild samples must not flatten the rest.
    low, high = numpy.nanpercentile(found, [1, 99])
    low, high = min(low, exact.min(), 0.0), max(high, exact.max())
    axes.set_ylim(scale * (low - 0.05 * (high - low) * (low < 0)), scale * (high + 0.08 * (high - low)))
    axes.set_ylabel(f"pressure at the centre ({unit})")


def semi_axes(runs):
    drawing, axes = figure()
    draw_semi_axes(axes, runs)
    axes.legend()
    return drawing


def centre_pressure(runs):
    drawing, axes = figure()
    draw_centre_pressure(axes, runs)
    axes.legend()
    return drawing


def angular_momentum(runs):
    drawing, axes = figure()
    factor = time_axis(axes, runs)
    for run, colour, _, label in style.styles(runs):
        start, *momentum = run.series["angular_momentum_z"]
        drift = abs(numpy.array(momentum) / start - 1)
        # Below the rounding of a double there is nothing to see, and a logarithm has no zero.
        axes.plot(factor * run.series["time"][1:], numpy.maximum(drift, 1e-16), color=colour, lw=1.4,
                  label=label)
    axes.set_yscale("log")
    axes.set_ylabel(r"drift of the angular momentum, $|L/L_0 - 1|$")
    axes.legend()
    return drawing


def corner_radius(runs):
    drawing, axes = figure()
    compare(axes, runs, "corner_radius", time_axis(axes, runs))
    axes.set_ylabel("distance of the corners from the centre (m)")
    axes.legend()
    return drawing
