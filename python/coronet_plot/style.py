# SPDX-License-Identifier: BSD-3-Clause
"""How figures look: type, lines, colours, and the names of runs and units in them."""
import sys
from itertools import cycle

import matplotlib
import numpy
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.ticker import ScalarFormatter

matplotlib.use("Agg")

INK, GREY = "#1a1a1a", "#8a8a8a"
COLOURS = ["#1f6fb4", "#d1495b", "#2a9d6f", "#e09f3e", "#7b5ea7", "#5c6b73"]
MARKERS = ["o", "s", "^", "D", "v", "P"]
# Pale where the pressure is low, so that an outline along the free surface stands out from the particles.
PRESSURE_MAP = LinearSegmentedColormap.from_list(
    "water", ["#bfdfe6", "#86c9cf", "#3d9fb8", "#2a6ea6", "#2a3f86", "#241a52"])
# The same where the scale begins at zero pressure: what is in tension stands out.
TENSION_MAP = PRESSURE_MAP.with_extremes(under="#e8b4a0")


def use():
    matplotlib.rcParams.update({
        "font.family": "DejaVu Sans", "font.size": 9, "mathtext.fontset": "dejavusans",
        "axes.titlesize": 10, "axes.labelsize": 9, "xtick.labelsize": 8, "ytick.labelsize": 8,
        "legend.fontsize": 8.5, "legend.frameon": False, "legend.handlelength": 2.2,
        "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": "#555555",
        "xtick.color": "#555555", "ytick.color": "#555555", "xtick.labelcolor": INK, "ytick.labelcolor": INK,
        "axes.linewidth": 0.7, "xtick.major.width": 0.7, "ytick.major.width": 0.7,
        "xtick.major.size": 3, "ytick.major.size": 3, "xtick.direction": "out", "ytick.direction": "out",
        "axes.spines.top": False, "axes.spines.right": False, "axes.formatter.useoffset": False,
        "figure.dpi": 100, "savefig.dpi": 200, "savefig.bbox": "tight", "savefig.pad_inches": 0.08,
    })


def prefixed(values, unit, least=1.0):
    """The factor and the unit, such as 1e-6 and MPa, by which the largest value is between `least` and 1000 `least`."""
    sizes = numpy.abs(values)
    largest = numpy.max(sizes, initial=0.0, where=numpy.isfinite(sizes))
    power = 3 * int(numpy.floor(numpy.log10(largest / least) / 3)) if largest > 0 else 0
    power = min(max(power, -9), 9)
    return 10.0**-power, {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}[power] + unit


class Scaled(ScalarFormatter):
    """Writes ticks in another unit than that of the axis."""
    def __init__(self, factor):
        super().__init__(useOffset=False)
        self.set_scientific(False)
        self.factor = factor

    def set_locs(self, locs):
        super().set_locs(self.factor * numpy.asarray(locs))

    def __call__(self, value, pos=None):
        return super().__call__(self.factor * value, pos)


def length(values):
    """As `prefixed`, but half a metre stays in metres."""
    return prefixed(values, "m", least=0.1)


def length_axis(axis, name, values):
    """Labels an axis in metres with the unit that suits lengths like these."""
    factor, unit = length(values)
    axis.set_major_formatter(Scaled(factor))
    axis.set_label_text(f"{name} ({unit})")


def about(runs, *further):
    """What case a figure is of, and of how many particles."""
    names = sorted({run.name for run in runs})
    counts = sorted({int(run.series["particles"][0]) for run in runs if run.has("particles")})
    return ", ".join([*names, *further, *[" or ".join(map(str, counts)) + " particles"] * bool(counts)])


def labels(runs):
    """A run is called by its method; where two share it, by its directory too."""
    methods = [run.method for run in runs]
    return [method if methods.count(method) == 1 else f"{method} ({run.directory.resolve().name})"
            for method, run in zip(methods, runs)]


def styles(runs):
    """Colour, marker and label of each run: the same in all figures."""
    return zip(runs, cycle(COLOURS), cycle(MARKERS), labels(runs))


def complain(message):
    """Says it where messages go; returns the exit status of a mistake in the command line."""
    print(f"coronet plot: {message}", file=sys.stderr)
    return 2
