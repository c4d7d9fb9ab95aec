// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/kernels/kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace coronet {

namespace {

struct Piece {
    double knot;
    double c[4];
};

struct Shape {
    std::string_view name;
    int knots;
    Piece piece[Kernel::most_knots];
    double norm[3];  // factor in 1, 2, 3 dimensions at H = 1: the integral of W over space is one
};

using std::numbers::pi;

// Truncated powers in s = r/H: (3 - q)^5 of the quintic spline, q = 3 s, is 3^5 (1 - s)^5, and so on.
constexpr std::array shapes{
    // Morris, Fox, Zhu, J. Comput. Phys. 136 (1997) 214; Fang et al. (2009) Eq 21, whose middle term lacks its power 5.
    Shape{"quintic-spline",
          3,
          {{1, {0, 0, 1, 0}}, {2. / 3, {0, 0, -6, 0}}, {1. / 3, {0, 0, 15, 0}}},
          {243. * 3 / 120, 243. * 9 * 7 / (478 * pi), 243. * 27 / (120 * pi)}},
    // Monaghan and Lattanzio, Astron. Astrophys. 149 (1985) 135.
    Shape{"cubic-spline",
          2,
          {{1, {1, 0, 0, 0}}, {0.5, {-4, 0, 0, 0}}},
          {8. * 2 / 6, 8. * 4 * 10 / (7 * pi) / 4, 8. * 8 / (4 * pi)}},
    // Wendland, Adv. Comput. Math. 4 (1995) 389: (1 - s)^4 (1 + 4 s); in one dimension (1 - s)^3 (1 + 3 s).
    Shape{"wendland-c2", 1, {{1, {0, 5, -4, 0}}}, {5. / 4, 7 / pi, 21 / (2 * pi)}},
    // Lobo (2011) Eq 2.18, (1 - s^2)^3; in one dimension the factor is 35/32, not 35/(32 pi) as printed there.
    Shape{"w6", 1, {{1, {8, -12, 6, -1}}}, {35. / 32, 4 / pi, 315 / (64 * pi)}},
    // Lobo (2011) Eq 2.19, (1 - s)^3, the spiky kernel.
    Shape{"w3", 1, {{1, {1, 0, 0, 0}}}, {2, 10 / pi, 15 / pi}},
};

constexpr Piece wendland_1d{1, {4, -3, 0, 0}};

/// -dW/ds at s = 0 of a kernel of one knot at 1.
constexpr double slope_at_zero(Piece const& piece) {
    return 3 * piece.c[0] + 4 * piece.c[1] + 5 * piece.c[2] + 6 * piece.c[3];
}
constexpr bool is_polynomial(Shape const& shape) { return shape.knots == 1 && slope_at_zero(shape.piece[0]) == 0; }

/// What Kernel takes for granted: a polynomial's knot is 1, and a spline has one power, u^3 or u^5.
constexpr bool is_of_either_kind(Shape const& shape) {
    if (is_polynomial(shape)) return shape.piece[0].knot == 1;
    for (Piece const& piece : shape.piece)
        for (int n = 0; n < 4; ++n)
            if (piece.c[n] != 0 && (n % 2 == 1 || shape.piece[0].c[n] == 0)) return false;
    return (shape.piece[0].c[0] == 0) != (shape.piece[0].c[2] == 0);
}
static_assert(std::ranges::all_of(shapes, is_of_either_kind) && slope_at_zero(wendland_1d) == 0);

constexpr auto names = [] {
    std::array<std::string_view, shapes.size()> list;
    for (std::size_t k = 0; k < shapes.size(); ++k) list[k] = shapes[k].name;
    return list;
}();

}  // namespace

std::span<std::string_view const> kernel_names() { return names; }

Kernel make_kernel(std::string_view name, int dimension, double support) {
    for (Shape const& shape : shapes) {
        if (shape.name != name) continue;
        Kernel kernel{support, 1 / support, is_polynomial(shape), 0, shape.knots, {}, {}, {}};
        double const factor = shape.norm[dimension - 1] / std::pow(support, dimension);
        for (int k = 0; k < shape.knots; ++k) {
            Piece const& piece = name == "wendland-c2" && dimension == 1 ? wendland_1d : shape.piece[k];
            kernel.knot[k] = piece.knot;
            for (int n = 0; n < 4; ++n) {
                kernel.c[k][n] = factor * piece.c[n];
                kernel.d[k][n] = -(n + 3) * kernel.c[k][n] / support;
            }
        }
        if (!kernel.is_polynomial) kernel.c_over_d = -support / (shape.piece[0].c[0] != 0 ? 3 : 5);
        // Without slope at r = 0 the sum of d_n u^n is (1 - u) times another, whose coefficients are its partial sums.
        if (kernel.is_polynomial) {
            double partial = 0;
            for (double& d : kernel.d[0]) {
                partial += d / support;
                d = partial;
            }
            kernel.d[0][3] = 0;
        }
        return kernel;
    }
    throw std::invalid_argument("no kernel is called '" + std::string(name) + "'");
}

}  // namespace coronet
