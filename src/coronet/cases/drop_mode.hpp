// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How a free drop oscillates about its round shape. In 2D: the normal mode r = R (1 + a cos n theta), a ~ exp(-b t)
// cos(w t), of small amplitude in a vacuum. Without viscosity w^2 = n (n^2 - 1) sigma/(rho R^3) (Rayleigh 1879); a
// little of it damps with b = 2 n (n - 1) nu/R^2 (the dissipation of the inviscid flow, as Lamb 1932, art. 355, does in
// 3D). Exactly, with a velocity of a potential and a rotational part (Bessel functions I_n), no tangential stress and a
// normal stress of sigma times the curvature, s = -b + i w solves, for R = rho = sigma = 1 and so nu the Ohnesorge
// number mu/sqrt(rho sigma R),
//     s^2 + 2 nu n s ((n - 1) + C (z K + n - 1)) + w0^2 (1 + C) = 0,
//     C = -2 n (n - 1)/(z^2 + 2 n (n - 1) - 2 z K),   z^2 = s/nu,   K = I_{n+1}(z)/I_n(z).
//
// In 3D, r = R (1 + a P_n(cos theta)) and w^2 = n (n - 1) (n + 2) sigma/(rho R^3), with a little viscosity
// b = (n - 1) (2n + 1) nu/R^2 (Lamb); exactly, in the same way (its equation is that of W. H. Reid, Q. Appl. Math. 18 (1960) 86),
//     s^2 + 2 nu s (n (n - 1) + n (n + 1) C (z K + n - 1)) + w0^2 (1 + (n + 1) C) = 0,
//     C = -2 (n - 1)/(z^2 + 2 (n^2 - 1) - 2 z K),   K = I_{n+3/2}/I_{n+1/2}.

#include <optional>

namespace coronet {

struct DropMode {
    double angular_frequency, damping;  ///< w and b [1/s]
};

/// The mode n >= 2 of a drop in 2 or 3 dimensions with R [m], rho [kg/m^3], sigma [N/m] above 0 and mu [Pa s] from 0
/// on; nothing where it does not oscillate.
std::optional<DropMode> drop_mode(int dimension, int n, double R, double rho, double sigma, double mu);

}  // namespace coronet
