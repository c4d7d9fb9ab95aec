// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The interpolation operators side by side, applied to the field Sample: to study their order, and to test what the
// schemes are built on.

#include <vector>

#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

template <int D>
struct Interpolated {
    double sph = 0;                  ///< sum V f W                       Fang et al. (2009) Eq 17
    double shepard = 0;              ///< the same over sum V W           Lobo (2011) Eq 2.71
    double fpm = 0;                  ///< exact for linear functions      Fang et al. (2009) Eq 35
    Vector<double, D> sph_gradient;  ///< sum V (f_j - f_i) grad W        Fang et al. (2009) Eq 18
    /// The same with each component over its own moment: Lobo (2011) Eq 2.72. Exact for linear functions only where the
    /// off-diagonal moments vanish, so for study and not for physics.
    Vector<double, D> axis_gradient;
    Vector<double, D> fpm_gradient;  ///< exact for linear functions      Fang et al. (2009) Eqs 37, 38
    bool fell_back = false;          ///< fpm_gradient is the plain one: the small matrix is singular
};

/// Values and gradients of Sample at every particle, in the particles' order; Position, Volume and Sample must be set.
template <int D>
std::vector<Interpolated<D>> interpolate(Particles<D> const& particles, Neighbours<D> const& neighbours,
                                         Kernel const& kernel);

}  // namespace coronet
