// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The closed list of laws that the schemes sweep: what a case chooses picks one of them, once per
// sweep. Each costs a pair loop per dimension to compile; a test holds their number to a budget.

#include "coronet/schemes/pair_terms.hpp"
#include "coronet/terms/central_viscosity.hpp"
#include "coronet/terms/continuity.hpp"
#include "coronet/terms/corrected_pressure_gradient.hpp"
#include "coronet/terms/density_slopes.hpp"
#include "coronet/terms/moments.hpp"
#include "coronet/terms/morris_viscosity.hpp"
#include "coronet/terms/pressure_gradient.hpp"
#include "coronet/terms/pressure_jump.hpp"
#include "coronet/terms/stress_divergence.hpp"
#include "coronet/terms/velocity_gradient.hpp"
#include "coronet/terms/wall_contact.hpp"
#include "coronet/terms/wall_continuity.hpp"

namespace coronet {

using PlainGradients = Sum<VelocitySlopes>;
using PlainGradientsAndSums = Sum<KernelSums, VelocitySlopes>;
using CorrectedGradients = Sum<Moments, VelocitySlopes, VelocityJumps>;
using MirrorSums = Sum<Moments, VelocitySlopes, VelocityJumps, PressureJumps>;
using WallCorrections = Sum<WallContinuity, WallContact>;
using PlainForces = Sum<StressDivergence>;
using CorrectedForces = Sum<CorrectedStressDivergence>;
using BetweenParticles = Sum<CentralViscosity, PairTerms>;  // either may be idle
using PlainForcesAndPairTerms = Sum<StressDivergence, PairTerms>;

// Either of the two may be idle.
using CorrectedForcesAndPairTerms = Sum<CorrectedStressDivergence, CentralViscosity, PairTerms>;

// Plain gradients and a viscosity that needs no velocity gradient: everything in one sweep.
using PlainSweep = Sum<PressureGradient, MorrisViscosity, Continuity>;
using PlainSweepAndPairTerms = Sum<PressureGradient, MorrisViscosity, Continuity, PairTerms>;

// The same with a viscosity that the shear rate has set before; pair terms may be idle.
using PressureAndVariableMorris = Sum<PressureGradient, VariableMorrisViscosity, PairTerms>;

// Corrected gradients and a viscosity between velocities; pair terms may be idle.
using CorrectedPressureAndMorris = Sum<CorrectedPressureGradient, CorrectedMorrisViscosity, PairTerms>;

// The gradients that the scheme takes, with what shifting wants to know: its vector, and the gradient of density.
template <class Vector>
using GradientsAndShift = Sum<Moments, VelocitySlopes, VelocityJumps, DensitySlopes, Vector>;

}  // namespace coronet
