# SPDX-License-Identifier: BSD-3-Clause
"""What surface tension does: where the energy of a liquid goes, and how the wave on a column grows beside theory."""
import numpy

from coronet_plot import curves, history, style

KINDS = [("kinetic_energy", "kinetic"), ("surface_energy", "surface"), ("compressive_energy", "compressive"),
         ("dissipated_energy", "dissipated")]


def changes(run):
    """Of each kind of energy that a run has, what it has changed by, and of all together."""
    parts = {name: run.series[column] - run.series[column][0] for column, name in KINDS if run.has(column)}
    return {**parts, "together": sum(parts.values())}


def energies(runs):
    """A panel for each run."""
    drawing, panels = curves.stacked(len(runs))
    unit = "J" if runs[0].case.get("dimension") == 3 else "J/m"
    for axes, run, label in zip(panels, runs, style.labels(runs)):
        factor, found = curves.time_axis(axes, runs), changes(run)
        scale, prefixed = style.prefixed(numpy.concatenate(list(found.values())), unit)
        for (name, change), colour in zip(found.items(), style.COLOURS):
            together = name == "together"
            axes.plot(factor * run.series["time"], scale * change, label=name, lw=1.4, zorder=3,
                      color=style.INK if together else colour, ls=(0, (3, 2)) if together else "-")
        axes.axhline(0, color=style.GREY, lw=0.6)
        axes.set_ylabel(f"change of energy ({prefixed})")
        if len(runs) > 1:
            axes.set_title(label, loc="left", fontsize=9)
    history.finish(drawing, panels, runs)
    panels[0].legend()
    return drawing


def column(runs):
    """The wave over its logarithm, with theory's slope through where the fit begins; below, the neck."""
    drawing, (wave, neck) = curves.stacked(2)
    factor = curves.time_axis(wave, runs)
    for run, colour, _, label in style.styles(runs):
        time, amplitude = run.series["time"], run.series["wave_amplitude"]
        wave.plot(factor * time, amplitude, color=colour, lw=1.4, label=label, zorder=3)
        neck.plot(factor * time, run.series["neck_radius"], color=colour, lw=1.4, zorder=3)
        rate = run.measures.get("growth_rate", {}).get("reference")
        if rate is not None:
            begin = numpy.argmax(amplitude >= 2 * amplitude[0])
            exact = amplitude[begin] * numpy.exp(rate * (time - time[begin]))
            wave.plot(factor * time[exact < 1], exact[exact < 1], color=style.INK, lw=0.9, ls=(0, (3, 2)), zorder=5,
                      label="theory, small amplitude" if run is runs[0] else None)
    wave.set_yscale("log")
    wave.set_ylabel("wave, over the radius")
    neck.set_ylabel("thinnest slice,\nover the radius")
    neck.set_ylim(bottom=0)
    curves.time_axis(neck, runs)
    history.finish(drawing, [wave, neck], runs)
    wave.legend()
    return drawing
