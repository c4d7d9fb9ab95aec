# SPDX-License-Identifier: BSD-3-Clause
"""The stretching drop at one glance: its particles at the end of every run in the exact outline; and
the semi-axes and the centre pressure over time against theory."""
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse

from coronet_plot import curves, style
from coronet_plot.frame import read_frame
from coronet_plot.pictures import Scale, draw_particles, title_time

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


def upright(runs, frames, outlines, reach):
    """Tall drops stand side by side at the left, the curves one above the other at the right."""
    high = 4.3
    wide = max(high * reach[0] / reach[1], 0.85)
    bar = LEFT + len(runs) * (wide + GAP)
    right = bar + 1.3
    drawing = Figure(figsize=(right + CURVES + 0.3, BOTTOM + high + TOP))
    scale = Scale.over(frames)
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
    floor = BOTTOM + below + 0.75
    drawing = Figure(figsize=(LEFT + total + 1.0, floor + high + TOP))
    scale = Scale.over(frames)
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
        draw_particles(axes, frame, run.spacing, scale)
        axes.add_patch(Ellipse((0, 0), 2 * a, 2 * b, fill=False, ec=style.INK, lw=1.0, ls=(0, (4, 2.5)),
                               zorder=3))
        axes.set(xlim=(-reach[0], reach[0]), ylim=(-reach[1], reach[1]), xlabel="$x$ (m)")
        axes.set_title(label, pad=19, weight="bold")
        axes.annotate(time(frame), (0.5, 1), xycoords="axes fraction", xytext=(0, 7),
                      textcoords="offset points", ha="center", fontsize=8.5, color=style.GREY)
        axes.spines[:].set_visible(False)
        axes.tick_params(left=axes is drops[0], labelleft=axes is drops[0])
    drops[0].set_ylabel(f"${'xyz'[runs[0].plane[1]]}$ (m)")


def draw_curves(pair, runs):
    curves.draw_semi_axes(pair[0], runs)
    curves.draw_centre_pressure(pair[1], runs)
    pair[0].legend(ncol=2)
