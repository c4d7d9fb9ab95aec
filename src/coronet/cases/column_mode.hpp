// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How fast a column of liquid breaks up: a wave r = R (1 + a cos k x) on a cylinder in a vacuum, a ~ exp(s t), of small
// amplitude. Without viscosity s^2 = k (1 - k^2) I_1(k)/I_0(k), for R = rho = sigma = 1 (Rayleigh 1879). Exactly, with
// a velocity of a potential and a rotational part, no tangential stress and a normal stress of sigma times the
// curvature (S. Chandrasekhar, Hydrodynamic and Hydromagnetic Stability, 1961, chapter XII; J. Eggers and E.
// Villermaux, Rep. Prog. Phys. 71 (2008) 036601), nu being the Ohnesorge number mu/sqrt(rho sigma R),
//     s^2 + 2 nu s q (g(k) - 2 k^2/(k^2 + l^2) g(l)) = (1 - k^2) q (l^2 - k^2)/(l^2 + k^2),
//     q = k I_1(k)/I_0(k),   g(z) = z I_1'(z)/I_1(z),   l^2 = k^2 + s/nu.

namespace coronet {

/// s [1/s] for a wave of k [1/m], 0 < k R < 1, with R [m], rho [kg/m^3], sigma [N/m] above 0 and mu [Pa s] from 0 on.
double column_growth_rate(double k, double R, double rho, double sigma, double mu);

}  // namespace coronet
