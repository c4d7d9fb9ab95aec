# SPDX-License-Identifier: BSD-3-Clause
"""The stretching drop at one glance: its particles at the end of every run in the exact outline, and over time
how far its semi-axes and its centre pressure are from theory."""
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse

from coronet_plot import curves, style
from coronet_plot.frame import read_frame
from coronet_plot.pictures import Scale, draw_particles, joined, title_time

# Lengths in inches.
LEFT, BOTTOM, TOP, GAP = 0.6, 0.55, 0.5, 0.3
CURVES = 3.9


def drop(runs):
    frames = [read_frame(run, *run.frames[-1]) for run in runs]
    outlines = [outline(run, frame.time) for run, frame in zip(runs, frames)]
    reach = [1.06 * max(max(abs(frame.positions[:, k]).max() for frame in frames),
                        max(axes[k] for axes in outlines)) for k in (0, 1)]
    return (upright if reach[1] > reach[0] else lying)(runs, frames, outlines, reach)


def outline(run, time):
    """The exact semi-axes in the plane shown."""
    return [run.at("exact_semi_axis_" + "xyz"[k], time) for k in run.plane]


def exact_scale(runs, frames):
    """The colours of the exact pressure, zero at the surface and the largest at the centre. A method whose pressures
    lie all over shows by the colours of the arrows; scaled by its noise, the good ones would show nothing."""
    centre = [float(run.at("exact_centre_pressure", frame.time)) for run, frame in zip(runs, frames)]
    low, high = min(0.0, *centre), max(0.0, *centre)
    margin = 0.15 * (high - low)
    return Scale.between(low - margin, high + margin, joined(frames), style.TENSION_MAP)


def upright(runs, frames, outlines, reach):
    """Tall drops stand side by side at the left, the curves one above the other at the right."""
    high = 4.3
    wide = max(high * reach[0] / reach[1], 0.85)
    bar = LEFT + len(runs) * (wide + GAP)
    right = bar + 1.35
    drawing = Figure(figsize=(right + CURVES + 0.3, BOTTOM + high + TOP))
    scale = exact_scale(runs, frames)
    drops = [place(drawing, LEFT + k * (wide + GAP), BOTTOM, wide, high) for k in range(len(runs))]
    draw_drops(drops, runs, frames, outlines, reach, scale)
    scale.bar(drawing, cax=place(drawing, bar, BOTTOM + 0.15 * high, 0.11, 0.7 * high))
    half = (high - 0.3) / 2
    above = place(drawing, right, BOTTOM + half + 0.3, CURVES, half)
    draw_curves([above, place(drawing, right, BOTTOM, CURVES, half)], runs)
    above.set_xlabel(None)
    above.tick_params(labelbottom=False)
    return drawing


def lying(runs, frames, outlines, reach):
    """Flat drops lie side by side at the top, the curves below them."""
    total = 2 * CURVES + 0.9
    wide = min((total - GAP * (len(runs) - 1)) / len(runs), 4.5)
    high = wide * reach[1] / reach[0]
    below = 2.7
    floor = BOTTOM + below + 0.95
    drawing = Figure(figsize=(LEFT + total + 1.0, floor + high + TOP))
    scale = exact_scale(runs, frames)
    drops = [place(drawing, LEFT + k * (wide + GAP), floor, wide, high) for k in range(len(runs))]
    draw_drops(drops, runs, frames, outlines, reach, scale)
    scale.bar(drawing, cax=place(drawing, LEFT + len(runs) * (wide + GAP), floor, 0.11, high))
    draw_curves([place(drawing, LEFT, BOTTOM, CURVES, below),
                 place(drawing, LEFT + CURVES + 0.9, BOTTOM, CURVES, below)], runs)
    return drawing


def place(drawing, x, y, wide, high):
    """Axes whose place and size are given in inches."""
    across, up = drawing.get_size_inches()
    return drawing.add_axes([x / across, y / up, wide / across, high / up])


def draw_drops(drops, runs, frames, outlines, reach, scale):
    time = title_time(frames)
    for axes, run, frame, (a, b), label in zip(drops, runs, frames, outlines, style.labels(runs)):
        draw_particles(axes, frame, scale, fill=1.42)
        axes.add_patch(Ellipse((0, 0), 2 * a, 2 * b, fill=False, ec=style.INK, lw=1.0, ls=(0, (4, 2.5)),
                               zorder=3))
        axes.set(xlim=(-reach[0], reach[0]), ylim=(-reach[1], reach[1]))
        style.length_axis(axes.xaxis, "$x$", reach)
        style.length_axis(axes.yaxis, f"${'xyz'[run.plane[1]]}$", reach)
        if axes is not drops[0]:
            axes.set_ylabel(None)
        axes.set_title(label, pad=19, weight="bold")
        axes.annotate(time(frame.time), (0.5, 1), xycoords="axes fraction", xytext=(0, 7),
                      textcoords="offset points", ha="center", fontsize=8.5, color=style.GREY)
        axes.spines[:].set_visible(False)
        axes.tick_params(left=axes is drops[0], labelleft=axes is drops[0])


def draw_curves(pair, runs):
    curves.draw_semi_axis_error(pair[0], runs)
    curves.draw_centre_pressure(pair[1], runs)
    above = {"xycoords": "axes fraction", "textcoords": "offset points"}
    pair[0].legend(*pair[1].get_legend_handles_labels(), ncol=4, loc="lower left", bbox_to_anchor=(-0.02, 1.0),
                   borderaxespad=0.2, columnspacing=1.6, handletextpad=0.5)
    pair[0].annotate(style.about(runs), (0, 1), xytext=(0, 24), fontsize=8.5, color=style.GREY, **above)
