# SPDX-License-Identifier: BSD-3-Clause
"""Draws Figs 4.2 to 4.5 of Lobo (2011) again from what the program `convergence` writes, and prints the slopes.

    build/release/convergence runs/convergence && /usr/bin/python3 bench/convergence.py runs/convergence
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


def read(path):
    return np.genfromtxt(path, delimiter=",", names=True)


def slope(N, error):
    """Order in the spacing, from the three finest of the list."""
    return -np.polyfit(np.log(N[-3:]), np.log(error[-3:]), 1)[0]


def error_figure(data, column, noise, title, path):
    figure, axes = plt.subplots(figsize=(6, 4.4), layout="constrained")
    for k, colour in zip(np.unique(data["k"]), plt.cm.viridis(np.linspace(0, 0.85, 5))):
        rows = data[(data["k"] == k) & (data["noise"] == noise)]
        axes.loglog(rows["N"], rows[column], "o-", ms=4, color=colour, label=f"{k:.0f} particles in the radius")
    N = np.array([4e3, 6.4e4])
    base = np.nanmin(data[column][data["noise"] == noise]) if noise == 0 else None
    if base is not None:
        for order, style in ((1.5, "k--"), (2, "k:")):
            axes.loglog(N, 0.5 * base * (N / N[-1]) ** -order, style, lw=1, label=f"order {order:g}")
    axes.set_xlabel("particles N")
    axes.set_ylabel(title)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, fontsize=8)
    figure.savefig(path, dpi=150)
    plt.close(figure)


def scatter_figure(data, path):
    figure, axes = plt.subplots(2, 2, figsize=(9, 5.5), layout="constrained", sharex=True, sharey="row")
    for column, k in enumerate((2, 16)):
        rows = data[data["k"] == k]
        for row, (name, exact) in enumerate((("shepard", "exact"), ("axis_gradient", "exact_gradient"))):
            axes[row, column].plot(rows["x"], rows[exact], "k-", lw=0.8)
            axes[row, column].plot(rows["x"], rows[name], ".", ms=3, color="tab:blue")
            axes[row, column].spines[["top", "right"]].set_visible(False)
        axes[0, column].set_title(f"{k} particles in the radius, 1 % noise", fontsize=10)
        axes[1, column].set_xlabel("x")
    axes[0, 0].set_ylabel("f")
    axes[1, 0].set_ylabel("df/dx")
    figure.savefig(path, dpi=150)
    plt.close(figure)


def main():
    folder = Path(sys.argv[1])
    data = read(folder / "convergence.csv")
    clean = data[data["noise"] == 0]
    columns = {"shepard_error": "Shepard value (2.71)", "shepard_error_inside": "  the same, 0.1 < x < 0.9",
               "fpm_error": "FPM value", "axis_gradient_error": "axis gradient (2.72)", "fpm_gradient_error": "FPM gradient",
               "sph_error": "SPH value", "sph_gradient_error": "SPH gradient"}
    print("observed order in the spacing, N = 16000 to 64000, without noise")
    print(f"{'':28s}" + "".join(f"  k={k:<4.0f}" for k in np.unique(clean["k"])))
    for column, name in columns.items():
        orders = []
        for k in np.unique(clean["k"]):
            rows = clean[clean["k"] == k]
            orders.append(slope(rows["N"], rows[column]))
        print(f"{name:28s}" + "".join(f"  {order:6.2f}" for order in orders))

    print("\nradius with the least gradient error under 1 % noise")
    noisy = data[data["noise"] > 0]
    for N in np.unique(noisy["N"]):
        rows = noisy[noisy["N"] == N]
        best = rows[np.argmin(rows["axis_gradient_error"])]
        print(f"  N = {N:6.0f}: {best['k']:3.0f} particles, error {best['axis_gradient_error']:.3g}")

    error_figure(data, "shepard_error", 0, "L2 error of f", folder / "figure_4_2.png")
    error_figure(data, "axis_gradient_error", 0, "L2 error of df/dx", folder / "figure_4_3.png")
    scatter_figure(read(folder / "scatter.csv"), folder / "figure_4_4.png")
    error_figure(data, "axis_gradient_error", 0.01, "L2 error of df/dx, 1 % noise", folder / "figure_4_5.png")


main()
