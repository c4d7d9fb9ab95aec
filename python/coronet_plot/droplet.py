# SPDX-License-Identifier: BSD-3-Clause
"""A drop under surface tension: a row of its frames (Lobo 2011, Figs. 4.6-4.10), its mode beside the fit and theory, and how
round, large and even it is over time."""
import numpy

from coronet_plot import curves, history, pictures, style
from coronet_plot.frame import read_frame

SHOWN = 6  # frames in a row


def droplet(runs):
    """A row of frames for each run: from the start to the end, closer together at the start, where most happens."""
    rows = [pick(run) for run in runs]
    frames = [frame for row in rows for frame in row]
    time = pictures.title_time(frames)
    several = len(runs) > 1
    titles = [f"{name}\n{time(frame.time)}" if several and frame is row[0] else time(frame.time)
              for name, row in zip(style.labels(runs), rows) for frame in row]
    columns = max(map(len, rows))
    return pictures.panels(frames, pictures.Scale.of_calmest(frames), columns, titles, runs[0].plane,
                           style.about(runs), fill=0.95)


def pick(run):
    times = numpy.array([time for time, _ in run.frames])
    wanted = times[0] + (times[-1] - times[0]) * numpy.linspace(0, 1, SHOWN)**2
    chosen = sorted({int(abs(times - instant).argmin()) for instant in wanted})
    return [read_frame(run, *run.frames[k]) for k in chosen]


def mode(runs):
    drawing, axes = curves.figure()
    factor = curves.time_axis(axes, runs)
    for run, colour, _, label in style.styles(runs):
        time, found = run.series["time"], run.series["mode_amplitude"]
        axes.plot(factor * time, found, color=colour, lw=1.4, label=label, zorder=3)
        fitted = fit(run)
        if fitted is not None:
            axes.plot(factor * fitted[0], fitted[1], color=style.INK, lw=0.9, ls=(0, (3, 2)), zorder=5,
                      label="fit" if run is runs[0] else None)
        theory = exact(run)
        if theory is not None and run is runs[0]:
            axes.plot(factor * time, theory, color=style.GREY, lw=1.0, zorder=2, label="theory, small amplitude")
    axes.axhline(0, color=style.GREY, lw=0.6, zorder=1)
    n = next((probe["mode"] for probe in runs[0].case.get("probes", []) if probe.get("kind") == "mode"), "n")
    axes.set_ylabel(f"amplitude of mode {n}, over the radius")
    axes.legend()
    axes.set_title(style.about(runs), fontsize=10, weight="bold")
    return drawing


def pair(run, key):
    """Period and damping rate of the measures: their values, or their references. None if a run has none."""
    found = [run.measures.get(name, {}).get(key) for name in ("period", "damping_rate")]
    return None if None in found else found


def wave(time, period, damping):
    phase = 2 * numpy.pi * time / period
    return numpy.exp(-damping * time)[:, None] * numpy.column_stack([numpy.cos(phase), numpy.sin(phase)])


def fit(run):
    """Where the fit was made, the curve with its period and damping; the rest follows linearly."""
    values, theory = pair(run, "value"), pair(run, "reference")
    if values is None or theory is None:
        return None
    time = run.series["time"]
    inside = time >= time[0] + theory[0]
    time, found = time[inside], run.series["mode_amplitude"][inside]
    basis = numpy.column_stack([wave(time - time[0], *values), numpy.ones_like(time)])
    return time, basis @ numpy.linalg.lstsq(basis, found, rcond=None)[0]


def exact(run):
    """What theory makes of the first amplitude, at rest."""
    theory = pair(run, "reference")
    if theory is None:
        return None
    basis = wave(run.series["time"], *theory)
    tilt = theory[1] * theory[0] / (2 * numpy.pi)  # so that the velocity at the start is 0
    return run.series["mode_amplitude"][0] * (basis @ [1, tilt])


def droplet_history(runs):
    drawing, (area, round_, spacing) = curves.stacked(3)
    factor = curves.time_axis(area, runs)
    for k, (run, colour, marker, label) in enumerate(style.styles(runs)):
        time, turn = factor * run.series["time"], (k + 0.5) / len(runs)
        mass = run.series["mass"][0] / run.case["fluid"]["density"]
        curves.marked(area, time, 100 * (run.series["area"] / mass - 1), turn, colour, marker, label)
        curves.marked(round_, time, run.series["circularity"], turn, colour, marker, None)
        curves.marked(spacing, time, run.series["spacing_p01"], turn, colour, marker, None)
        spacing.plot(time, run.series["spacing_min"], color=colour, lw=0.8, ls=":", zorder=2)
    area.axhline(0, color=style.GREY, lw=0.6)
    area.set_ylabel("error of the area (%)")
    round_.set_ylabel("largest over\nsmallest radius")
    spacing.set_ylabel("distances over the spacing:\n1 % are below; least (dotted)")
    spacing.set_ylim(0, 1.05 * max(1.0, spacing.get_ylim()[1]))
    for axes in (round_, spacing):
        curves.time_axis(axes, runs)
    history.finish(drawing, [area, round_, spacing], runs)
    return drawing
