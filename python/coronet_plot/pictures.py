# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the particles, coloured by pressure: discs of a spacing, equal axes, one colour scale."""
from dataclasses import dataclass

import numpy
from matplotlib.cm import ScalarMappable
from matplotlib.collections import EllipseCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from coronet_plot import style
from coronet_plot.frame import read_frame


@dataclass
class Scale:
    """One colour scale for all frames of a figure: a hundredth of the particles may lie beyond either end."""
    norm: Normalize
    unit: str
    factor: float
    extend: str

    @classmethod
    def over(cls, frames):
        pressure = numpy.concatenate([frame.pressure for frame in frames])
        pressure = pressure[numpy.isfinite(pressure)]
        pressure = pressure if pressure.size else numpy.zeros(1)
        low, high = numpy.percentile(pressure, [1, 99])
        if 0 < low < 0.25 * high:
            low = 0.0  # the free surface is at zero: let the scale begin there
        if high <= low:
            low, high = low - 1, high + 1
        factor, unit = style.prefixed([low, high], "Pa")
        margin = 0.02 * (high - low)
        below, above = pressure.min() < low - margin, pressure.max() > high + margin
        extend = "both" if below and above else "min" if below else "max" if above else "neither"
        return cls(Normalize(factor * low, factor * high), unit, factor, extend)

    def bar(self, drawing, **where):
        mappable = ScalarMappable(self.norm, style.PRESSURE_MAP)
        bar = drawing.colorbar(mappable, label=f"pressure ({self.unit})", extend=self.extend,
                               ticks=MaxNLocator(5), **where)
        bar.outline.set_visible(False)
        bar.ax.tick_params(length=2.5)
        return bar


def draw_particles(axes, frame, spacing, scale):
    size = numpy.full(len(frame.positions), 1.2 * spacing)
    axes.add_collection(EllipseCollection(
        size, size, 0 * size, units="xy", offsets=frame.positions, offset_transform=axes.transData,
        array=scale.factor * frame.pressure, norm=scale.norm, cmap=style.PRESSURE_MAP, linewidths=0))
    axes.set_aspect("equal")


def extent(frames, margin):
    """The corners of the box that holds the particles of all frames."""
    positions = numpy.concatenate([frame.positions for frame in frames])
    return positions.min(axis=0) - margin, positions.max(axis=0) + margin


def title_time(frames):
    """A function that writes the time of a frame, in the unit that suits the last of them."""
    factor, unit = style.prefixed([frame.time for frame in frames], "s")
    return lambda frame: f"$t$ = {factor * frame.time:.4g} {unit}"


def panels(frames, columns, spacings, titles, plane):
    """Frames side by side in rows of `columns`, all with the same limits and the same colours."""
    low, high = extent(frames, 1.5 * max(spacings))
    wide, tall = high - low
    rows = -(-len(frames) // columns)
    width = min(9.0 / columns, 3.6 * wide / tall)
    drawing = Figure(figsize=(width * columns + 1.4, (width * tall / wide + 0.35) * rows + 0.5),
                     layout="constrained")
    grid = drawing.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    scale = Scale.over(frames)
    for axes, frame, spacing, title in zip(grid.flat, frames, spacings, titles):
        draw_particles(axes, frame, spacing, scale)
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        axes.set_title(title)
    for axes in grid.flat[len(frames):]:
        axes.set_visible(False)
    for axes in grid[-1]:
        axes.set_xlabel("$x$ (m)")
    for axes in grid[:, 0]:
        axes.set_ylabel(f"${'xyz'[plane[1]]}$ (m)")
    scale.bar(drawing, ax=grid, pad=0.02, aspect=30 * rows, shrink=0.8, extendfrac=0.03)
    return drawing


def particles(runs):
    """The first frame of the first run, the last, and up to two between."""
    run = runs[0]
    chosen = sorted(set(numpy.linspace(0, len(run.frames) - 1, 4).round().astype(int)))
    frames = [read_frame(run, *run.frames[k]) for k in chosen]
    wide, tall = numpy.subtract(*extent(frames, 0.0)[::-1])
    columns = len(frames) if wide < 1.6 * tall else min(2, len(frames))
    time = title_time(frames)
    return panels(frames, columns, [run.spacing] * len(frames), [time(frame) for frame in frames], run.plane)


def patch(runs):
    """A row per run at the two instants of Fang et al. 2009, Figs. 6-8; of a shorter run its last frames."""
    frames, spacings, names = [], [], []
    for run, name in zip(runs, style.labels(runs)):
        times = numpy.array([time for time, _ in run.frames])
        chosen = [abs(times - wanted).argmin() for wanted in (0.015, 0.02)]
        if times[-1] < 0.015 or chosen[0] == chosen[1]:
            chosen = [max(len(times) - 2, 0), len(times) - 1]
        frames += [read_frame(run, *run.frames[k]) for k in chosen]
        spacings += 2 * [run.spacing]
        names += 2 * [name]
    time = title_time(frames)
    titles = [f"{name},  {time(frame)}" for name, frame in zip(names, frames)]
    return panels(frames, 2, spacings, titles, runs[0].plane)
