// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From a checked case to what runs: particles with their initial state, and the scheme that advances them.

#include <memory>

#include "coronet/cases/fill.hpp"
#include "coronet/cases/wall_fill.hpp"
#include "coronet/materials/equation_of_state.hpp"
#include "coronet/schemes/scheme.hpp"

namespace coronet {

EquationOfState equation_of_state(Case const& c);

template <int D>
struct InitialState {
    Particles<D> particles;
    double fastest2 = 0;              ///< largest squared speed relative to the mean [m^2/s^2]; infinite if not finite
    bool density_is_possible = true;  ///< finite and positive everywhere
    std::size_t beyond = 0;           ///< particles too far from the liquid of the case's frame to see it
};

/// Particles with position, velocity, density from the initial pressure, mass (density times lattice volume), surface;
/// and walls. Velocity and pressure are those of the case's formulas or, where it has one, of its frame.
template <int D>
InitialState<D> initial_state(Case const& c, Seeds<D> const& seeds, WallSeeds<D> const& walls);

template <int D>
std::unique_ptr<Scheme<D>> make_scheme(Case const& c);

}  // namespace coronet
