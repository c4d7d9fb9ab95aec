// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The closed list of laws that the weakly compressible scheme sweeps: what a case chooses picks one of them, once per
// sweep. Each costs a pair loop per dimension to compile; a test holds their number to a budget.

#include <algorithm>
#include <limits>

#include "coronet/schemes/pair_terms.hpp"
#include "coronet/terms/continuity.hpp"
#include "coronet/terms/moments.hpp"
#include "coronet/terms/morris_viscosity.hpp"
#include "coronet/terms/pressure_gradient.hpp"
#include "coronet/terms/stress_divergence.hpp"
#include "coronet/terms/velocity_gradient.hpp"

namespace coronet {

using PlainGradients = Sum<VelocitySlopes>;
using PlainGradientsAndSums = Sum<KernelSums, VelocitySlopes>;
using CorrectedGradients = Sum<Moments, VelocitySlopes, VelocityJumps>;
using PlainForces = Sum<StressDivergence>;
using CorrectedForces = Sum<CorrectedStressDivergence>;
using PlainForcesAndPairTerms = Sum<StressDivergence, PairTerms>;
using CorrectedForcesAndPairTerms = Sum<CorrectedStressDivergence, PairTerms>;

// Plain gradients and a viscosity that needs no velocity gradient: everything in one sweep.
using PlainSweep = Sum<PressureGradient, MorrisViscosity, Continuity>;
using PlainSweepAndPairTerms = Sum<PressureGradient, MorrisViscosity, Continuity, PairTerms>;

/// Whether any of the case's pair terms does something: a term may say active() = false, without coefficients set.
template <class... Terms>
bool any_active(Sum<Terms...> const& sum) {
    [[maybe_unused]] auto const active = []<class T>(T const& term) {
        if constexpr (requires { term.active(); }) return term.active();
        return true;
    };
    return (active(static_cast<Terms const&>(sum)) || ...);
}

/// The longest step the case's pair terms allow: a term may say step_limit(h, c), in s, for smoothing length h [m] and
/// sound speed c [m/s]; infinity where none does.
template <class... Terms>
double step_limit(Sum<Terms...> const& sum, double h, double c) {
    double step = std::numeric_limits<double>::infinity();
    [[maybe_unused]] auto const vote = [&]<class T>(T const& term) {
        if constexpr (requires { term.step_limit(h, c); }) step = std::min(step, term.step_limit(h, c));
    };
    (vote(static_cast<Terms const&>(sum)), ...);
    return step;
}

}  // namespace coronet
