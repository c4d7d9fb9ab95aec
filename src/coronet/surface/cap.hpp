// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the ball of a neighbour covers of the sphere (in 2D: what its disc covers of the circle) around particle i. A
// point x_i + R_i u, u a unit vector, lies in the closed ball of radius R_j around x_j where
//     u . x >= a,   x = x_j - x_i,   a = (|x|^2 + R_i^2 - R_j^2)/(2 R_i):
// a cap around the direction of the neighbour, cut off by a plane. It is Lobo (2011), 3.22-3.34, without angles, so
// that nothing falls between cases at 0 or 2 pi (his 3.31 and 3.33 leave out an angle of 0). Contained balls need no
// case of their own: the cap is everything for a <= -|x| and nothing for a >= |x|.
//
// What touches, closes: neighbours' balls are taken `closing` larger than they are. So arcs that only meet, as on
// lattices at certain radii, leave no gap, whatever rounding does to them. Two particles nearer than `apart` radii,
// with radii as near to each other, have one ball between them: neither covers the other, for both would be gone from
// the surface that they form.

#include <cmath>

#include "coronet/core/tensor.hpp"

namespace coronet {

template <int D>
struct Cap {
    /// Of neighbours' radii: above the rounding of positions up to 10^5 spacings away from the origin.
    static constexpr double closing = 1e-10;
    /// Of the radius. Balls that are so far apart cover half of each other's surface, to 1 part in 1000, in spite of
    /// `closing`; a gap that is narrower than that may be overlooked.
    static constexpr double apart = 1e-7;

    Vector<double, D> x;  ///< of the length that it happens to have
    double a = 1;         ///< in units of x; by itself 1 on x = 0: nothing

    Cap(Vector<double, D> const& direction, double least) : x(direction), a(least) {}
    /// x = x_j - x_i, R_i and R_j in one unit of length.
    Cap(Vector<double, D> const& x_ij, double R_i, double R_j) : x(x_ij) {
        double const limit = apart * R_i;
        if (norm2(x) <= limit * limit && std::fabs(R_i - R_j) <= limit) {
            x = {};
            return;
        }
        double const larger = R_j * (1 + closing);
        a = (norm2(x) + (R_i - larger) * (R_i + larger)) / (2 * R_i);
    }

    bool everything() const { return a <= 0 && a * a >= norm2(x); }
    bool nothing() const { return a > 0 && a * a >= norm2(x); }
};

}  // namespace coronet
