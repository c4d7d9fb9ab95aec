// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Steps that viscosity does not limit. Accelerations a that hold viscous forces, those of walls and everything else are
// replaced by a' of
//     (M + dt K) a' = M a,
// the linearly implicit Euler method (Rosenbrock, Comput. J. 5 (1963) 329): of first order in the step, and exact where
// the flow is steady, for there a is 0. K is the viscous force between velocities (terms/morris_viscosity.hpp),
//     (K v)_i = sum_j c_ij (v_i - v_j),   c_ij = -V_i V_j 2 mu_ij x . grad W_ij/r^2 > 0,
// mu_ij the harmonic mean; symmetric, positive semi-definite and local. A wall particle's velocity goes against that of
// the liquid: it counts as 2 c_ij v_i, with which the step is stable at any length. Momentum within the liquid is kept
// to the solve's tolerance. Solved by conjugate gradients with the diagonal, for all components at once.

#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/neighbours.hpp"
#include "coronet/solvers/conjugate_gradients.hpp"

namespace coronet {

template <int D>
class ImplicitViscosity {
public:
    ImplicitViscosity(Kernel const& kernel, SolveLimits const& limits) : kernel_(kernel), limits_(limits) {}

    /// Replaces the field Acceleration for a step [s]. viscosity(i) [Pa s] of any particle; Position, Volume and Mass
    /// must be set, the lists those of now.
    template <class Viscosity>
    Solved apply(Particles<D>& particles, Neighbours<D> const& neighbours, double step, Viscosity const& viscosity) {
        viscosity_.resize(particles.size());
        for_each(particles.size(), [&](std::size_t i) { viscosity_[i] = viscosity(i); });
        return solve(particles, neighbours, step);
    }

private:
    struct Link {
        double c;
        std::size_t j;
    };
    void list(Particles<D> const& particles, Neighbours<D> const& neighbours);
    Solved solve(Particles<D>& particles, Neighbours<D> const& neighbours, double step);

    Kernel kernel_;
    SolveLimits limits_;
    ConjugateGradients gradients_;
    std::vector<double> viscosity_, sum_, diagonal_, b_, x_;
    std::vector<std::size_t> begin_;
    std::vector<Link> links_;
};

}  // namespace coronet
