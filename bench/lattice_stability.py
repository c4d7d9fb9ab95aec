#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""/usr/bin/python3 bench/lattice_stability.py

Whether a square lattice stays where it is under an even pressure. With plain gradients the force of a pressure p is minus the derivative of the
energy p V^2 sum over pairs 2 W(r), so a wave exp(i k.x) of displacements obeys, with D(k) = sum_j V grad grad W(x_j) (1 - cos k.x_j),

    d^2 u/dt^2 = -(2 p/rho) D(k) u

beside the stiffness of sound, which waves across k do not feel. Prints, for kernels and supports H in spacings, the least eigenvalue of D over
all waves of the lattice, over k^2, and its wave: below 0 the wave grows as exp(k sqrt(2 p |eigenvalue|/rho) t), k in 1/m. Also the slope moment
sum V grad W (x_j - x_i), which is 1 for an exact gradient.
"""
import math

import numpy as np


def wendland_c2(q):
    """First and second derivative by q = r/H, times H^3 and H^4; support 1."""
    c = 7 / math.pi
    return c * -20 * q * (1 - q) ** 3, c * (-20 * (1 - q) ** 3 + 60 * q * (1 - q) ** 2)


def spline(knots, norm):
    """Of the derivative of sum a (b - s)^n, s = r/h."""
    def kernel(q):
        s, n = q * knots[0][1], len(knots) * 2 - 1
        first = sum(-n * a * np.maximum(b - s, 0) ** (n - 1) for a, b in knots)
        second = sum(n * (n - 1) * a * np.maximum(b - s, 0) ** (n - 2) for a, b in knots)
        return norm * knots[0][1] ** 3 * first, norm * knots[0][1] ** 4 * second
    return kernel


KERNELS = {"wendland-c2": wendland_c2,
           "quintic-spline": spline([(1, 3), (-6, 2), (15, 1)], 7 / (478 * math.pi)),
           "cubic-spline": spline([(1, 2), (-4, 1)], 5 / (14 * math.pi))}


def least_eigenvalue(kernel, support):
    """(least eigenvalue over k^2, its wave in units of pi/spacing, slope moment); spacing 1."""
    steps = np.arange(-6, 7)
    x, y = (c.ravel() for c in np.meshgrid(steps, steps))
    r = np.hypot(x, y)
    near = (r > 0) & (r < support)
    x, y, r = x[near], y[near], r[near]
    first, second = kernel(r / support)
    across, along = first / support ** 3 / r, second / support ** 4
    xx, yy, xy = (along * a * b / r ** 2 + across * (same - a * b / r ** 2)
                  for a, b, same in ((x, x, 1), (y, y, 1), (x, y, 0)))
    worst = (math.inf, (0, 0))
    waves = np.linspace(0, math.pi, 41)
    for kx in waves:
        for ky in waves:
            if kx == ky == 0:
                continue
            f = 1 - np.cos(kx * x + ky * y)
            matrix = [[np.sum(xx * f), np.sum(xy * f)], [np.sum(xy * f), np.sum(yy * f)]]
            worst = min(worst, (np.linalg.eigvalsh(matrix)[0] / (kx ** 2 + ky ** 2), (kx / math.pi, ky / math.pi)))
    return worst[0], worst[1], -np.sum(across * x * x)


def main():
    print("kernel            support  least/k^2     at k/pi         slope moment")
    for name, kernel in KERNELS.items():
        for support in np.arange(2, 4.01, 0.1):
            least, (kx, ky), moment = least_eigenvalue(kernel, support)
            print(f"{name:16s}  {support:7.1f}  {least:+.5f}  ({kx:5.3f}, {ky:5.3f})  {moment:12.4f}")


if __name__ == "__main__":
    main()
