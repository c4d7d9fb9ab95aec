// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A step of any length under viscous stress and accelerations f that are given,
//     M dv/dt = M f - K v     (schemes/viscous_operator.hpp),
// by the two-stage, stiffly accurate, singly diagonal Runge-Kutta method of second order, L-stable, with gamma = 1 -
// 1/sqrt(2) (Alexander, SIAM J. Numer. Anal. 14 (1977) 1006, Theorem 5):
//     (M + gamma dt K) v_1 = M (v + gamma dt f),
//     (M + gamma dt K) v_2 = M (v + dt f) - (1 - gamma) dt K v_1,
//     v_new = v + dt f - dt M^-1 K v_mean,   v_mean = (1 - gamma) v_1 + gamma v_2.
// Both solves are by conjugate gradients with the diagonal as preconditioner, without a matrix. Up to what they leave
// v_new is v_2; formed from the forces it keeps momentum and angular momentum to round-off however far they went.
// Without f every mode of K shrinks, so energy only falls.
//
// Viscosity is that of the flow at the start of the step, and stays: K is then the same in both stages. f stands in the
// stages since a force and a stress that balance must do so for any step.

#include "coronet/schemes/viscous_operator.hpp"
#include "coronet/solvers/conjugate_gradients.hpp"

namespace coronet {

template <int D>
class ViscousStep {
public:
    ViscousStep(Kernel const& kernel, GeneralisedNewtonian const& liquid, SolveLimits const& limits)
        : operator_(kernel), liquid_(liquid), limits_(limits) {}

    /// Takes the field Velocity a step [s] further under the field Acceleration and viscosity. Position, Mass and
    /// Volume must be set, the lists those of now. In what it returns the iterations are of both solves together, the
    /// residual is the larger one.
    Solved advance(Particles<D>& particles, Neighbours<D> const& neighbours, double step);

    /// The viscous stress [Pa] whose force made the last step, that of v_mean.
    Symmetric<double, D> stress(std::size_t i) const { return operator_.stress(i, v_mean_); }
    /// As it was in the last step.
    ViscousOperator<D> const& viscous() const { return operator_; }

private:
    ViscousOperator<D> operator_;
    GeneralisedNewtonian liquid_;
    SolveLimits limits_;
    ConjugateGradients gradients_;
    std::vector<double> mass_, diagonal_, v_, f_, b_, x_, Kv_, v_mean_;
};

}  // namespace coronet
