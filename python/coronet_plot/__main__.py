# SPDX-License-Identifier: BSD-3-Clause
"""coronet plot DIR [--with DIR ...]: writes the figures of a run, next to other runs, into DIR/figures/."""
import argparse
import sys
from pathlib import Path

if not __package__:  # started by its path, as `coronet plot` does
    sys.path[0] = str(Path(__file__).resolve().parents[1])

from coronet_plot import curves, dam_break, drop, droplet, history, pictures, rheology, style, tension
from coronet_plot.run import Mistake, Run

# Every figure: its file, who draws it, and whether a run has what it shows. Curves stand first: where a frame
# cannot be read they are there already.
FIGURES = [
    ("semi_axes.png", curves.semi_axes, lambda run: run.stretches),
    ("centre_pressure.png", curves.centre_pressure, lambda run: run.has("exact_centre_pressure")),
    ("angular_momentum.png", curves.angular_momentum, lambda run: run.rotates),
    ("values.png", history.values, lambda run: run.value_probes),
    ("flow_curve.png", rheology.flow_curve, lambda run: run.flow_curve),
    ("history.png", history.history, lambda run: run.has("kinetic_energy", "spacing_min")),
    ("patch_history.png", curves.corner_radius, lambda run: run.has("corner_radius")),
    ("mode.png", droplet.mode, lambda run: run.has("mode_amplitude")),
    ("droplet_history.png", droplet.droplet_history, lambda run: run.has("circularity", "area", "spacing_p01")),
    ("energies.png", tension.energies, lambda run: run.has("surface_energy", "dissipated_energy")),
    ("column.png", tension.column, lambda run: run.has("wave_amplitude", "neck_radius")),
    ("dam_break.png", dam_break.dam_break, lambda run: run.has("front")),
    ("particles.png", pictures.particles, lambda run: run.frames),
    ("patch.png", pictures.patch, lambda run: run.has("corner_radius") and run.frames),
    ("droplet.png", droplet.droplet, lambda run: run.has("circularity", "area") and run.frames),
    ("drop.png", drop.drop, lambda run: run.stretches and run.frames),
]


def arguments():
    parser = argparse.ArgumentParser(prog="coronet plot", description=__doc__.split(": ")[1])
    parser.add_argument("run", metavar="DIR", help="the directory of a run; the figures go to DIR/figures/")
    parser.add_argument("--with", dest="others", metavar="DIR", nargs="+", default=[],
                        help="runs to compare with")
    return parser.parse_args()


def main():
    chosen = arguments()
    runs = [Run(directory) for directory in [chosen.run, *chosen.others]]
    first = runs[0]
    if not first.frames:
        print(f"{first.directory} has no frames: only curves are drawn.", file=sys.stderr)
    fitting = [figure for figure in FIGURES if figure[2](first)]
    if not fitting:
        raise Mistake(f"{first.directory} holds neither frames nor a series that there is a figure for.")

    style.use()
    folder = first.directory / "figures"
    folder.mkdir(exist_ok=True)
    for name, draw, fits in fitting:
        draw([run for run in runs if fits(run)]).savefig(folder / name)
        print(folder / name, flush=True)


if __name__ == "__main__":
    try:
        main()
    except Mistake as mistake:
        sys.exit(style.complain(mistake))
    except OSError as error:
        sys.exit(style.complain(f"The figures cannot be written: {error.strerror}: {error.filename}."))
