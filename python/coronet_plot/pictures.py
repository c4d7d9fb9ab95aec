# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the particles, coloured by pressure: each as wide as the liquid it stands for, in equal axes."""
from dataclasses import dataclass

import numpy
from matplotlib.cm import ScalarMappable
from matplotlib.collections import EllipseCollection
from matplotlib.colors import Colormap, Normalize
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from coronet_plot import style
from coronet_plot.frame import read_frame


@dataclass
class Scale:
    """One colour scale for all frames of a figure. What lies beyond an end has the colour of the bar's arrow there."""
    norm: Normalize
    unit: str
    factor: float
    extend: str
    colours: Colormap

    @classmethod
    def over(cls, frames):
        """From the pressures found: a hundredth of the particles may lie beyond either end."""
        pressure = joined(frames)
        low, high = numpy.percentile(pressure, [1, 99])
        if 0 < low < 0.25 * high:
            low = 0.0  # the free surface is at zero: let the scale begin there
        return cls.between(low, high, pressure, style.PRESSURE_MAP)

    @classmethod
    def of_calmest(cls, frames):
        """From the frame whose pressures spread least, so that a noisy run beside it does not drown it; one without any, as of
        a projection before its first step, does not count."""
        ranges = [numpy.percentile(joined([frame]), [1, 99]) for frame in frames if numpy.ptp(joined([frame])) > 0]
        low, high = min(ranges, key=lambda ends: ends[1] - ends[0], default=(0.0, 0.0))
        return cls.between(low, high, joined(frames), style.PRESSURE_MAP)

    @classmethod
    def between(cls, low, high, pressure, colours):
        if high <= low:
            low, high = low - 1, high + 1
        factor, unit = style.prefixed([low, high], "Pa")
        margin = 0.02 * (high - low)
        below, above = pressure.min() < low - margin, pressure.max() > high + margin
        extend = "both" if below and above else "min" if below else "max" if above else "neither"
        return cls(Normalize(factor * low, factor * high), unit, factor, extend, colours)

    def bar(self, drawing, **where):
        mappable = ScalarMappable(self.norm, self.colours)
        bar = drawing.colorbar(mappable, label=f"pressure ({self.unit})", extend=self.extend,
                               ticks=MaxNLocator(5), **where)
        bar.outline.set_visible(False)
        bar.ax.tick_params(length=2.5)
        return bar


def joined(frames):
    """The pressures of all frames; what is left where a run diverged."""
    pressure = numpy.concatenate([frame.pressure for frame in frames])
    pressure = pressure[numpy.isfinite(pressure)]
    return pressure if pressure.size else numpy.zeros(1)


def draw_particles(axes, frame, scale, fill):
    """Up to a `fill` of 1 particles can be told apart, from the root of 2 on they are one liquid."""
    across, up = (numpy.full(len(frame.positions), fill * size) for size in frame.cell)
    axes.add_collection(EllipseCollection(
        across, up, 0 * up, units="xy", offsets=frame.positions, offset_transform=axes.transData,
        array=scale.factor * frame.pressure, norm=scale.norm, cmap=scale.colours, linewidths=0))
    axes.set_aspect("equal")


def extent(frames, margin):
    """The corners of the box that holds the particles of all frames."""
    positions = numpy.concatenate([frame.positions for frame in frames])
    return positions.min(axis=0) - margin, positions.max(axis=0) + margin


def title_time(frames):
    """A function that writes a time, in the unit that suits the last of the frames."""
    factor, unit = style.prefixed([frame.time for frame in frames], "s")
    return lambda time: f"$t$ = {factor * time:.4g} {unit}"


def panels(frames, scale, columns, titles, plane, heading, fill=0.95):
    """Frames side by side in rows of `columns`, all with the same limits and the same colours."""
    low, high = extent(frames, 1.5 * max(frame.cell.max() for frame in frames))
    wide, tall = high - low
    rows = -(-len(frames) // columns)
    width = min(9.0 / columns, 3.6 * wide / tall)
    drawing = Figure(figsize=(width * columns + 1.4, (width * tall / wide + 0.35) * rows + 0.5),
                     layout="constrained")
    drawing.get_layout_engine().set(h_pad=0.07)
    grid = drawing.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes, frame, title in zip(grid.flat, frames, titles):
        draw_particles(axes, frame, scale, fill)
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        axes.set_title(title)
    for axes in grid.flat[len(frames):]:
        axes.set_visible(False)
    for axes in grid[-1]:
        style.length_axis(axes.xaxis, "$x$", (low, high))
    for axes in grid[:, 0]:
        style.length_axis(axes.yaxis, f"${'xyz'[plane[1]]}$", (low, high))
    drawing.suptitle(heading, fontsize=10, weight="bold")
    scale.bar(drawing, ax=grid, pad=0.02, aspect=30 * rows, shrink=0.8, extendfrac=0.03)
    return drawing


def particles(runs):
    """The first frame of the first run, the last, and up to two between; and where it failed, if it did."""
    run = runs[0]
    chosen = sorted(set(numpy.linspace(0, len(run.frames) - 1, 4).round().astype(int)))
    frames = [read_frame(run, *run.frames[k]) for k in chosen]
    wide, tall = numpy.subtract(*extent(frames, 0.0)[::-1])
    columns = len(frames) if wide < 1.6 * tall else min(2, len(frames))
    time = title_time(frames)
    titles = [time(frame.time) for frame in frames]
    if run.failed is not None:
        titles[-1] += f"\n(failed at {time(run.failed)})"
    heading = style.about([run], style.labels(runs)[0])
    return panels(frames, Scale.over(frames), columns, titles, run.plane, heading)


def patch(runs):
    """A column per run with the instants of Fang et al. 2009, Figs. 6-8, or of Jahanbakhsh et al. 2012, Figs. 3-5; one run
    has them side by side."""
    rows = list(zip(*map(instants, runs)))
    frames = [frame for row in rows for frame in row]
    time = title_time(frames)
    titles = [f"{name},  {time(frame.time)}" for row in rows for name, frame in zip(style.labels(runs), row)]
    columns = len(runs) if len(runs) > 1 else 2
    return panels(frames, Scale.of_calmest(frames), columns, titles, runs[0].plane, style.about(runs),
                  fill=1.3)  # arms are drawn out: smaller discs would not show their colours


def instants(run):
    """The frames at 15 and 20 ms, of the slower patch at 0.245 and 0.49 s; of a shorter run the last two."""
    times = numpy.array([time for time, _ in run.frames])
    instants = (0.245, 0.49) if run.name == "square-patch-shifting" else (0.015, 0.02)
    chosen = [abs(times - wanted).argmin() for wanted in instants]
    if times[-1] < instants[0] or chosen[0] == chosen[1]:
        chosen = [max(len(times) - 2, 0), len(times) - 1]
    return [read_frame(run, *run.frames[k]) for k in chosen]
