#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reference solution of the rotating square patch of inviscid fluid.

At omega t = 0 an incompressible, inviscid fluid fills the square |x|, |y| <= L/2
and turns as a rigid body, v = (omega y, -omega x).  Its whole boundary is a free
surface with p = 0, and no force acts from outside.  The pressure inside is
negative, the corners fly off in straight lines, and the sides are drawn in: four
arms grow.  Particle methods answer to the negative pressure with clumps and tears,
and this module says how near neighbours may rightly be, and where.

Units throughout: L = omega = rho = 1, so time is omega t, pressure is in
rho omega^2 L^2, and a label `a` is a particle's position at the start.

Method.  The map X(a, t) and the velocity V = dX/dt live on an (N+1) x (N+1)
Chebyshev-Lobatto grid of labels.  With F = dX/da, derivatives in space are
derivatives in label times F^-1, and the motion is

    dX/dt = V,   dV/dt = -grad p,   lap p = -tr(grad v grad v),   p = 0 on the edge;

the last equation is what keeps div v = 0.  It is collocated at the interior nodes
and solved at each stage of a classical Runge-Kutta step.  The quarter turn
symmetry, p(R a) = p(a), leaves one unknown in four.

Limits.  No filter and no dealiasing is used: at N = 32 none is needed up to
omega t = 2, and exponential filters of order 8 to 16 lost more accuracy than they
gave.  The exact flow has two rough places, which set the accuracy:
 * at a corner lap p = 2 meets p = 0 on both sides, so p has a term r^2 log r and F
   a term log r: at the corner node itself F does not converge, and det F = 1 holds
   to a few per cent only; both heal within the outermost cell of the label grid;
 * the surface pulls on the fluid (Rayleigh-Taylor), so its short waves grow, the
   faster the finer the grid.  Finer grids break down sooner (N = 40 near omega t
   = 1.9), coarser ones are less accurate (and N = 16 breaks down at 1.9 too).
Run this file for the figures: they are printed in about ten seconds.
"""

from functools import lru_cache
from pathlib import Path

import numpy as np

RESOLUTION = 32  # N of the default reference
TIME_STEP = 0.02  # omega dt; half of it changes p at the centre by 2e-7 at omega t = 2
REACH = 6  # lattice steps searched for the nearest neighbour, see square_lattice()
MAX_TIME = 2.1  # latest omega t; N = 32 breaks down at 2.2


# --- Chebyshev tools on [-1/2, 1/2] ------------------------------------------------


def chebyshev(n):
    """Nodes, differentiation matrix and barycentric weights of the n+1 node grid."""
    k = np.arange(n + 1)
    weight = (-1.0) ** k
    weight[[0, -1]] /= 2
    # Differences of nodes by a product of sines: no cancellation near the ends.
    total, gap = np.add.outer(k, k), np.subtract.outer(k, k)
    difference = np.sin(np.pi * total / (2 * n)) * np.sin(np.pi * gap / (2 * n))
    np.fill_diagonal(difference, 1)
    d = np.divide.outer(1 / weight, 1 / weight) / difference
    np.fill_diagonal(d, 0)
    np.fill_diagonal(d, -d.sum(axis=1))
    return -np.cos(np.pi * k / n) / 2, d, weight


def quadrature(n):
    """Clenshaw-Curtis weights of the same grid, for even n."""
    k = np.arange(0, n + 1, 2)
    moment = 1 / (1.0 - k**2)
    moment[[0, -1]] /= 2
    w = 2 / n * np.cos(np.pi * np.outer(np.arange(n + 1), k) / n) @ moment
    w[[0, -1]] /= 2
    return w


def inverse(f):
    """Inverse and determinant of 2 x 2 matrices held in the first two axes."""
    (a, b), (c, d) = f
    det = a * d - b * c
    return np.array([[d, -b], [-c, a]]) / det, det


# --- the solver --------------------------------------------------------------------


class SquarePatch:
    """The reference on a label grid of N = n; states are kept as they are computed."""

    def __init__(self, n=RESOLUTION, dt=TIME_STEP):
        if n % 2:
            raise ValueError("n must be even, so that the centre is a node")
        self.n, self.dt = n, dt
        self.nodes, self.d, self.bary = chebyshev(n)
        self._poisson_operators()
        a = np.array(np.meshgrid(self.nodes, self.nodes, indexing="ij"))
        self._states = [np.array([a, [a[1], -a[0]]])]  # (X, V)[component, i, j]

    def _poisson_operators(self):
        """The five label derivatives that make up the Laplacian, on one quarter.

        `rows` are the interior nodes where the equation is collocated, one from
        each orbit of the quarter turn, and `orbit` spreads their values over the
        grid; a zero appended to those values serves all the nodes on the edge.
        """
        m = self.n + 1
        index = np.arange(m * m).reshape(m, m)
        first = np.minimum.reduce([np.rot90(index, q) for q in range(4)])
        inner = np.zeros((m, m), bool)
        inner[1:-1, 1:-1] = True
        self.rows = np.unique(first[inner])
        count = len(self.rows)
        self.orbit = np.where(inner, np.searchsorted(self.rows, first), count)
        spread = np.eye(count + 1)[self.orbit.ravel(), :count]
        i, j = np.divmod(self.rows, m)

        def operator(left, right):
            return np.einsum("ra,rb->rab", left[i], right[j]).reshape(count, -1) @ spread

        one, d, dd = np.eye(m), self.d, self.d @ self.d
        pairs = (dd, one), (d, d), (one, dd), (d, one), (one, d)
        self.operators = [operator(*pair) for pair in pairs]

    def gradient(self, f):
        """Derivatives by label of the fields f[..., i, j]: result[..., label, i, j]."""
        return np.stack([self.d @ f, f @ self.d.T], axis=-3)

    def pressure_and_acceleration(self, state):
        x, v = state
        b, det = inverse(self.gradient(x))  # b[k, j] = d a_k / d x_j
        velocity_gradient = np.einsum("ckxy,kjxy->cjxy", self.gradient(v), b)
        source = -np.einsum("ijxy,jixy->xy", velocity_gradient, velocity_gradient)
        # lap p = g^kl p,kl + (lap a_l) p,l with g = b b^T, all in labels
        g = np.einsum("kjxy,ljxy->klxy", b, b)
        first = [np.einsum("kkxy->xy", self.gradient(det * g[:, l])) / det for l in (0, 1)]
        coefficients = [g[0, 0], 2 * g[0, 1], g[1, 1], *first]
        laplacian = sum(
            c.ravel()[self.rows, None] * operator
            for c, operator in zip(coefficients, self.operators)
        )
        inner = np.linalg.solve(laplacian, source.ravel()[self.rows])
        p = np.append(inner, 0.0)[self.orbit]
        return p, -np.einsum("kxy,kjxy->jxy", self.gradient(p), b)

    def _rate(self, state):
        return np.array([state[1], self.pressure_and_acceleration(state)[1]])

    def _step(self, y, h):
        k1 = self._rate(y)
        k2 = self._rate(y + h / 2 * k1)
        k3 = self._rate(y + h / 2 * k2)
        k4 = self._rate(y + h * k3)
        y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        if not np.abs(y).max() < 10:
            raise FloatingPointError(f"N = {self.n} has broken down")
        return y

    def state(self, omega_t):
        """(X, V)[component, i, j] on the grid of labels at the time omega t."""
        if not 0 <= omega_t <= MAX_TIME:
            raise ValueError(f"omega_t must lie between 0 and {MAX_TIME}")
        whole = int(omega_t / self.dt + 1e-9)
        while len(self._states) <= whole:
            self._states.append(self._step(self._states[-1], self.dt))
        rest = omega_t - whole * self.dt
        return self._step(self._states[whole], rest) if rest > 1e-12 else self._states[whole]

    def interpolate(self, field, labels):
        """The polynomials field[..., i, j] at labels[m, 2]: result[m, ...]."""
        labels = np.asarray(labels, float).reshape(-1, 2)
        if not np.all(np.abs(labels) <= 0.5 + 1e-9):
            raise ValueError("a label lies outside the square |x|, |y| <= 1/2")
        out = np.empty((len(labels),) + field.shape[:-2])
        for begin in range(0, len(labels), 20000):
            part = slice(begin, begin + 20000)
            left, right = (self._cardinals(labels[part, k]) for k in (0, 1))
            for c in np.ndindex(field.shape[:-2]):
                out[(part, *c)] = np.einsum("mj,mj->m", left @ field[c], right)
        return out

    def _cardinals(self, s):
        """Barycentric Lagrange basis at the points s: result[m, node]."""
        gap = s[:, None] - self.nodes
        hit = np.abs(gap) < 1e-14
        basis = self.bary / np.where(hit, 1, gap)
        basis[hit.any(axis=1)] = 0
        basis[hit] = 1
        return basis / basis.sum(axis=1, keepdims=True)


@lru_cache(maxsize=None)
def reference(n=RESOLUTION, dt=TIME_STEP):
    """The solver for N = n, made once: later calls find its states ready."""
    return SquarePatch(n, dt)


def positions(labels, omega_t, n=RESOLUTION):
    """Exact positions X[m, 2] of the particles labels[m, 2]."""
    patch = reference(n)
    return patch.interpolate(patch.state(omega_t)[0], labels)


def velocities(labels, omega_t, n=RESOLUTION):
    """Exact velocities V[m, 2] of the particles labels[m, 2]."""
    patch = reference(n)
    return patch.interpolate(patch.state(omega_t)[1], labels)


def pressure(labels, omega_t, n=RESOLUTION):
    """Exact pressure p[m] at the particles labels[m, 2]."""
    patch = reference(n)
    return patch.interpolate(patch.pressure_and_acceleration(patch.state(omega_t))[0], labels)


def deformation(labels, omega_t, n=RESOLUTION):
    """Deformation gradient F[m, 2, 2] = dX/da at the particles labels[m, 2]."""
    patch = reference(n)
    return patch.interpolate(patch.gradient(patch.state(omega_t)[0]), labels)


def initial_pressure(labels):
    """Pressure at omega t = 0 by the single sum over odd modes, to 1e-9 or better."""
    x, y = np.asarray(labels, float).reshape(-1, 2).T[:, :, None]
    m = np.arange(1, 400, 2)
    # cosh(m pi y) / cosh(m pi / 2), written so that neither overflows
    ratio = np.exp(m * np.pi * (np.abs(y) - 0.5))
    ratio = ratio * (1 + np.exp(-2 * m * np.pi * np.abs(y))) / (1 + np.exp(-m * np.pi))
    sign = (-1.0) ** ((m - 1) // 2)
    total = (sign / m**3 * ratio * np.cos(m * np.pi * x)).sum(axis=1)
    return -2 * ((0.25 - x[:, 0] ** 2) / 2 - 4 / np.pi**3 * total)


# --- what a particle method is measured by -----------------------------------------


def square_lattice(angle=0.0, reach=1):
    """Steps e from a node of the unit square lattice, turned by `angle`, to others.

    reach = 1 gives the 8 neighbours, reach = r the (2r + 1)^2 - 1 nodes about it.
    Once the flow has sheared the lattice, the nearest neighbour of a particle is
    often none of those 8: at omega t = 1.5 for a fifth of the particles, whose
    spacing would be taken up to twice too large, at 2 for two fifths and thrice.
    reach = 3 is enough up to omega t = 1.5, reach = REACH up to 2.
    """
    k = np.arange(-reach, reach + 1)
    e = np.array([(i, j) for i in k for j in k if (i, j) != (0, 0)], float)
    c, s = np.cos(angle), np.sin(angle)
    return e @ np.array([[c, s], [-s, c]])


def local_spacing(labels, spacing, omega_t, lattice_directions=None, n=RESOLUTION):
    """Exact distance of each particle to its nearest neighbour, result[m].

    The particles start on a lattice of the given spacing, whose steps in units of
    that spacing are `lattice_directions` (square_lattice(0, REACH) where none are
    given), and near each of them the flow has laid that lattice out anew by F:
    the distance is spacing min |F e|.  Labels and spacing are in units of L.

    F is taken as uniform over the step.  At a spacing of 0.01 the nearest distances
    in the lattice carried along exactly differ from this by -5 to +16 % at
    omega t = 1.5 and by -20 to +32 % at 2; for all but 2 % of the particles by -4 to
    +3 % and -14 to +7 %.
    """
    if lattice_directions is None:
        lattice_directions = square_lattice(reach=REACH)
    f = deformation(labels, omega_t, n)
    nearest = np.full(len(f), np.inf)
    for e in np.atleast_2d(lattice_directions):
        nearest = np.minimum(nearest, np.hypot(*(f @ e).T))
    return spacing * nearest


def close_pairs(points, radius):
    """All pairs nearer than radius, by a grid of cells: indices i, j and distance."""
    points = np.asarray(points, float)
    if not np.isfinite(points).all():
        raise ValueError("a position is not a number")
    cell = np.floor((points - points.min(axis=0)) / radius).astype(np.int64)
    columns = cell[:, 1].max() + 3  # with an empty column, so that rows do not touch
    key = cell[:, 0] * columns + cell[:, 1] + 1
    order = np.argsort(key, kind="stable")
    sorted_key = key[order]
    found = []
    for step in (0, 1, columns - 1, columns, columns + 1):  # each two cells once
        begin = np.searchsorted(sorted_key, sorted_key + step, "left")
        end = np.searchsorted(sorted_key, sorted_key + step, "right")
        if step == 0:
            begin = np.arange(len(key)) + 1
        count = np.maximum(end - begin, 0)
        i = np.repeat(np.arange(len(key)), count)
        j = np.arange(count.sum()) + np.repeat(begin - np.cumsum(count) + count, count)
        i, j = order[i], order[j]
        distance = np.hypot(*(points[i] - points[j]).T)
        near = distance < radius
        found.append((i[near], j[near], distance[near]))
    return tuple(np.concatenate(part) for part in zip(*found))


def clumping(
    initial_positions, positions, spacing, omega_t, lattice_directions=None, fraction=0.5
):
    """The share of particles with a neighbour nearer than `fraction` of the exact spacing.

    `initial_positions` are the labels, in the same order as `positions`; all
    lengths are in units of L.
    """
    limit = fraction * local_spacing(initial_positions, spacing, omega_t, lattice_directions)
    i, j, distance = close_pairs(positions, limit.max())
    clumped = np.zeros(len(limit), bool)
    clumped[i[distance < limit[i]]] = True
    clumped[j[distance < limit[j]]] = True
    return clumped.mean()


def fragments(positions, radius):
    """Number of groups of particles linked by distances below radius (3 spacings)."""
    i, j, _ = close_pairs(positions, radius)
    root = np.arange(len(positions))
    while True:
        a, b = root[i], root[j]
        open_links = a != b
        if not open_links.any():
            return len(np.unique(root))
        i, j, a, b = i[open_links], j[open_links], a[open_links], b[open_links]
        np.minimum.at(root, np.maximum(a, b), np.minimum(a, b))
        while np.any(root != root[root]):
            root = root[root]


# --- verification ------------------------------------------------------------------


def side(s):
    """Labels (1/2, s) of the side that starts at x = 1/2."""
    return np.column_stack([np.full(np.shape(s), 0.5), s])


def lattice(count, angle=0.0):
    """A square lattice of count x count particles, half a spacing inside the edge.

    Turned by an angle, it is the part of that lattice which lies as far inside.
    """
    if angle == 0:
        s = (np.arange(count) + 0.5) / count - 0.5
        return np.array(np.meshgrid(s, s, indexing="ij")).reshape(2, -1).T
    k = np.arange(-count, count + 1)
    e = np.array(np.meshgrid(k, k)).reshape(2, -1).T / count
    c, s = np.cos(angle), np.sin(angle)
    e = e @ np.array([[c, s], [-s, c]])
    return e[np.abs(e).max(axis=1) <= 0.5 - 0.5 / count]


def read_table(name):
    path = Path(__file__).resolve().parent.parent / "cases" / "reference" / name
    with open(path) as lines:
        return np.genfromtxt([l for l in lines if l[0] != "#"], delimiter=",", names=True)


def verify():
    centre, corner, middle = [[0, 0]], [[0.5, 0.5]], [[0.5, 0]]
    patch = reference()
    labels = lattice(100)
    weights = np.multiply.outer(quadrature(patch.n), quadrature(patch.n))

    grid = np.linspace(-0.5, 0.5, 11)
    grid = np.array(np.meshgrid(grid, grid)).reshape(2, -1).T
    error = np.abs(pressure(grid, 0) - initial_pressure(grid)).max()
    print(f"Pressure at the start: largest error against the series {error:.1e}\n")

    history = read_table("square_patch_history.csv")
    surface = read_table("square_patch_surface.csv")
    print(f"N = {patch.n}, omega dt = {patch.dt}: errors against the tables, and conservation")
    print(f"  {'':6}{'p centre':>10}{'radius of':>10}{'smallest':>10}{'surface':>10}"
          f"{'energy':>10}{'|det F - 1|':>14}")
    print(f"  {'time':6}{'':10}{'corner':>10}{'radius':>10}{'points':>10}{'':10}"
          f"{'mean':>10}{'max':>8}")
    for t in (0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0):
        row = history[np.isclose(history["wt"], t)][0]
        edge = surface[np.isclose(surface["wt"], t)]
        s = np.linspace(-0.5, 0.5, 4001)
        miss = positions(side(edge["s"]), t) - np.column_stack([edge["x"], edge["y"]])
        points = f"{np.hypot(*miss.T).max():10.1e}" if len(edge) else f"{'-':>10}"
        energy = 6 * (weights * (patch.state(t)[1] ** 2).sum(axis=0)).sum()
        area = np.abs(np.linalg.det(deformation(labels, t)) - 1)
        print(
            f"  {t:<6.2f}{pressure(centre, t)[0] - row['p_centre']:10.1e}"
            f"{np.hypot(*positions(corner, t)[0]) - np.sqrt((1 + t * t) / 2):10.1e}"
            f"{np.hypot(*positions(side(s), t).T).min() - row['r_min']:10.1e}{points}"
            f"{energy - 1:10.1e}{area.mean():10.1e}{area.max():8.1e}"
        )

    print("\nConvergence. Stretch: largest singular value of F; dF: from N = 32, over a")
    print("lattice of 100 x 100 particles, as a share of the local stretch; ds: the same of the")
    print("local spacing of that lattice, as a share of itself")
    print(f"  {'time':6}{'N':>4}{'p centre':>13}{'stretch':>12}{'dF':>27}{'ds':>18}")
    print(f"  {'':6}{'':4}{'':13}{'mid-side':>12}{'corner':>9}{'largest':>9}"
          f"{'rms':>9}{'max':>9}{'rms':>9}{'max':>9}")
    for t in (1.0, 1.5, 2.0):
        exact, spacing = deformation(labels, t), local_spacing(labels, 0.01, t)
        for n in (16, 24, 28, 32):
            try:
                f = deformation(labels, t, n)
            except FloatingPointError as failure:
                print(f"  {t:<6.2f}{n:4}   {failure}")
                continue
            stretch = [np.linalg.norm(deformation(a, t, n), 2, axis=(1, 2))
                       for a in (middle, corner, side(np.linspace(-0.5, 0.5, 401)))]
            off = np.linalg.norm(f - exact, 2, axis=(1, 2))
            ds = np.abs(local_spacing(labels, 0.01, t, n=n) / spacing - 1)
            off /= np.linalg.norm(exact, 2, axis=(1, 2))
            print(
                f"  {t:<6.2f}{n:4}{pressure(centre, t, n)[0]:13.8f}{stretch[0][0]:12.4f}"
                f"{stretch[1][0]:9.4f}{stretch[2].max():9.4f}"
                f"{np.sqrt((off**2).mean()):9.1e}{off.max():9.1e}"
                f"{np.sqrt((ds**2).mean()):9.1e}{ds.max():9.1e}"
            )

    print("\nThe surface and a lattice of spacing 0.01 in the exact flow. Along: stretch of")
    print("the surface line; nearest: local spacing / 0.01, also in a lattice turned by 30 deg")
    print(f"  {'time':6}{'along, middle':>14}{'largest':>9}{'mean':>7}"
          f"{'nearest, least':>17}{'mean':>7}{'turned':>11}{'clumping':>10}{'groups':>8}")
    turned, angle = lattice(100, np.pi / 6), np.pi / 6
    for t in (0.5, 1.0, 1.5, 2.0):
        s = side(np.linspace(-0.5, 0.5, 2001))
        along = np.hypot(*deformation(s, t)[:, :, 1].T)
        near = local_spacing(labels, 0.01, t) / 0.01
        near_turned = local_spacing(turned, 0.01, t, square_lattice(angle, REACH)) / 0.01
        x = positions(labels, t)
        print(f"  {t:<6.2f}{along[1000]:14.3f}{along.max():9.3f}{along.mean():7.3f}"
              f"{near.min():17.3f}{near.mean():7.3f}{near_turned.min():11.3f}"
              f"{clumping(labels, x, 0.01, t):10.4f}{fragments(x, 0.03):8}")


if __name__ == "__main__":
    verify()
