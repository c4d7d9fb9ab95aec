// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Normal and curvature of the free surface at its particles, from a quadratic fitted to the surface particles around
// each one in a frame (t, n), with n outward and up: Lobo (2011), 3.36-3.50, in 2D
//     y = a x^2 + b x + c,   normal (-b, 1)/sqrt(1 + b^2),   kappa = -2 a/(1 + b^2)^(3/2),
// and in 3D with the basis {1, x, y, x^2, xy, y^2}
//     z = f(x, y),           normal (-f_x, -f_y, 1)/sqrt(1 + f_x^2 + f_y^2),
//     kappa = -((1 + f_y^2) f_xx - 2 f_x f_y f_xy + (1 + f_x^2) f_yy)/(1 + f_x^2 + f_y^2)^(3/2),
// which is the sum of both principal curvatures. The normal points out of the liquid and kappa is positive on a drop,
// so that sigma kappa is the pressure jump of Laplace. (3.46-3.48 as printed have the powers of 1 + b wrong and an
// inward normal in a left-handed frame.)
//
// The frame first points away from the mean of the neighbours (3.36), then along the normal that this gave: the second
// fit has no slope left, and so no error from where the neighbours happened to be.
//
// The share of the surface that belongs to a particle is the inverse of their number per area there,
//     1/A = sum_j w(r_ij), itself included, w = (1 - (r/width)^2)^3 normalised over the line or plane,
// so that particles that crowd do not count for more surface than there is.
//
// Weights. A fit that counts all points alike, as printed, amplifies waves of three spacings: over three neighbours on
// each side of a straight row, f = cos(q s/dx) has f'' = (-4 - 6 cos q + 10 cos 3q)/(42 dx^2), which is positive at q =
// 2 pi/3. Weights (1 - (r/w)^2)^3 that vanish at w = 2.5 dx give -0.849 + 0.465 cos q + 0.384 cos 2q over dx^2, never
// positive: the tension that follows flattens every wave.

#include <cmath>
#include <span>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

enum class FitWeights {
    compact,  ///< (1 - (r/w)^2)^3
    none      ///< as printed: all within w alike
};

struct SurfaceFit {
    double width;  ///< w [m]: 2.5 spacings are recommended
    FitWeights weights = FitWeights::compact;

    /// Of something at the squared distance r2 [m^2]: 0 from w on.
    double weight(double r2) const {
        double const u = 1 - r2 / (width * width);
        return u <= 0 ? 0 : weights == FitWeights::none ? 1 : u * u * u;
    }
};

/// The curvature of the graph of f over a line, or over a plane, below which the liquid lies.
inline double curvature_of_graph(double fx, double fxx) {
    double const g = 1 + fx * fx;
    return -fxx / (g * std::sqrt(g));
}
inline double curvature_of_graph(double fx, double fy, double fxx, double fxy, double fyy) {
    double const g = 1 + fx * fx + fy * fy;
    return -((1 + fy * fy) * fxx - 2 * fx * fy * fxy + (1 + fx * fx) * fyy) / (g * std::sqrt(g));
}

template <int D>
struct LocalSurface {
    Vector<double, D> normal;  ///< outward, of length 1
    double curvature = 0;      ///< [1/m]
    bool fitted = false;       ///< or else: the normal is the direction that was given, the curvature unknown and 0
};

/// The surface at a particle. `points` are the surface particles around it, from it and without it [m]; `outward` is a
/// unit vector less than a right angle from the normal. There is no fit where fewer points than coefficients lie within
/// the width, or where they do not span a quadratic (in 2D, are all within 3 % of the width).
template <int D>
LocalSurface<D> fit_surface(std::span<Vector<double, D> const> points, Vector<double, D> const& outward,
                            SurfaceFit const& fit);

/// Sets SurfaceNormal, Curvature, SurfaceArea and SurfaceFitted at the particles that Surface marks, to 0 elsewhere. Surface
/// particles that face the other way, across a thin sheet or a gap, are left out of the fit. Where it fails the normal
/// points away from the neighbours' mean; it is 0 where these do not say which side is out, as for a lone particle.
/// Throws CaseError if the width is beyond the neighbours' lists.
template <int D>
void reconstruct_surface(Particles<D>& particles, Neighbours<D> const& neighbours, SurfaceFit const& fit);

}  // namespace coronet
