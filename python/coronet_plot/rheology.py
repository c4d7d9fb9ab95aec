# SPDX-License-Identifier: BSD-3-Clause
"""The flow curve that a case names, beside the law that was fitted to it: stress and viscosity over shear rate."""
import numpy
from matplotlib.figure import Figure

from coronet_plot import style

SHOWN = 1e-3  # the law as run, with its bounds, is drawn where it differs by more than that from the law itself


def flow_curve(runs):
    drawing = Figure(figsize=(8.4, 3.6))
    stress, viscosity = drawing.subplots(1, 2)
    for run, colour, marker, label in style.styles(runs):
        table = run.flow_curve
        rate, order = table["shear_rate"], numpy.argsort(table["shear_rate"])
        name = f", {label}" if len(runs) > 1 else ""
        bounded = numpy.any(abs(table["as_run"] / table["fit"] - 1) > SHOWN)
        for axes, per in ((stress, numpy.ones_like(rate)), (viscosity, rate)):
            axes.plot(rate, table["stress"] / per, marker, color=colour, ms=4.2, mfc="white", mew=1.0,
                      label="measured" + name, zorder=4)
            axes.plot(rate[order], (table["fit"] / per)[order], color=style.INK, lw=1.2, zorder=5,
                      label=run.case["fluid"]["rheology"] + name)
            if bounded:
                axes.plot(rate[order], (table["as_run"] / per)[order], "--", color=style.GREY, lw=1.0, zorder=3,
                          label="as run, with its bounds" + name)
    for axes, quantity in ((stress, "shear stress (Pa)"), (viscosity, "viscosity (Pa s)")):
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel("shear rate (1/s)")
        axes.set_ylabel(quantity)
    stress.legend()
    drawing.suptitle(style.about(runs), fontsize=10, weight="bold")
    drawing.tight_layout()
    return drawing
