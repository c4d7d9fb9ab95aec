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
    end = end * factor or 1
    axes.set_xlim(-0.012 * end, 1.018 * end)  # room for a marker at either end
    axes.set_xlabel(f"time ({unit})")
    return factor


def compare(axes, runs, column, factor, scale=1.0, named=True):
    """A column of every run that has it over time, and under them the exact one of the run that went furthest."""
    furthest = latest(runs)
    if furthest.has("exact_" + column):
        axes.plot(factor * furthest.series["time"], scale * furthest.series["exact_" + column],
                  color=style.INK, lw=1.0, label="exact" if named else None, zorder=4)
    for k, (run, colour, marker, label) in enumerate(style.styles(runs)):
        if run.has(column):
            marked(axes, factor * run.series["time"], scale * run.series[column], (k + 0.5) / len(runs),
                   color=colour, marker=marker, label=label if named else None)


def marked(axes, time, values, turn, color, marker, label):
    """A curve with a dozen markers; those of several runs take turns along it so that none hides another."""
    step = max(len(time) // 12, 1)
    some = slice(int(step * turn), None, step)
    axes.plot(time, values, color=color, lw=1.1, zorder=3)
    axes.plot(time[some], values[some], marker, color=color, ms=4.2, mfc="white", mew=1.2, label=label, zorder=5)


def draw_semi_axes(axes, runs):
    factor = time_axis(axes, runs)
    shown = semi_axis_columns(runs)
    for column in shown:
        compare(axes, runs, column, factor, named=column == shown[0])
        end = latest(runs).series["exact_" + column][-1]
        axes.annotate(f"$a_{column[-1]}$", (1, end), xycoords=("axes fraction", "data"), xytext=(6, 0),
                      textcoords="offset points", va="center", fontsize=10)
    axes.set_ylim(bottom=0)
    style.length_axis(axes.yaxis, "semi-axes", axes.get_ylim())


def semi_axis_columns(runs):
    return ["semi_axis_" + "xyz"[k] for k in runs[0].plane]


def draw_semi_axis_error(axes, runs):
    """The worse of the two semi-axes. At the start they agree by definition, so a logarithm begins after it."""
    factor, largest = time_axis(axes, runs), 1e-6  # per cent; an error below is as good as none
    for k, (run, colour, marker, label) in enumerate(style.styles(runs)):
        errors = [abs(run.series[column] / run.series["exact_" + column] - 1) for column in semi_axis_columns(runs)]
        worst = 100 * numpy.max(errors, axis=0)
        marked(axes, factor * run.series["time"][1:], worst[1:], (k + 0.5) / len(runs),
               color=colour, marker=marker, label=label)
        largest = numpy.max(worst, initial=largest, where=numpy.isfinite(worst))
    axes.set_yscale("log", nonpositive="clip")
    axes.set_ylim(1e-4 * largest, 2 * largest)  # the rest is the climb from zero
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set_ylabel("error of the semi-axes (%)")


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


def stacked(count):
    """Panels above each other over one axis of time."""
    drawing = Figure(figsize=(SIZE[0], 0.6 + 2.4 * count), layout="constrained")
    panels = drawing.subplots(count, sharex=True, squeeze=False)[:, 0]
    drawing.align_ylabels()
    return drawing, panels


def semi_axes(runs):
    drawing, (above, below) = stacked(2)
    draw_semi_axes(above, runs)
    draw_semi_axis_error(below, runs)
    above.set_xlabel(None)
    above.legend()
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
    style.length_axis(axes.yaxis, "distance of the corners from the centre", axes.get_ylim())
    axes.legend()
    return drawing
