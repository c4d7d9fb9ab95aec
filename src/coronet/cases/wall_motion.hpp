// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How a wall moves: as a rigid body, by its displacement d(t) and its turn phi(t) about its centre, given as formulas.
// A point that is r from the centre at t = 0 is at centre + d + R(phi) r; its velocity is d' + phi' x R r, its
// acceleration d'' + phi'' x R r - phi'^2 R r (across the axis). Derivatives are central differences over an interval
// that sound takes to cross a quarter of h: what changes faster is not resolved by the steps either.

#include <functional>

#include "coronet/cases/formula.hpp"
#include "coronet/cases/wall_fill.hpp"
#include "coronet/fields/particles.hpp"

namespace coronet {

/// Where a wall is, how fast and how it speeds up; angles in radians.
template <int D>
struct WallPose {
    Vector<double, D> displacement, velocity, acceleration;
    double turn = 0, spin = 0, spin_rate = 0;
};

template <int D>
class WallMotion {
public:
    WallMotion(Wall const& wall, Case const& c);

    WallPose<D> at(double time);

private:
    std::vector<Formula> displacement_;
    Formula turn_;
    double interval_;  // [s]
};

/// Puts wall particles, which are found by their identity, where they are at a time, with the velocity of the surface
/// (the wall's and, on top of it, `surface_velocity`), and takes their acceleration off the field Acceleration; empty
/// where nothing moves.
template <int D>
std::function<void(double, Particles<D>&)> wall_motion(Case const& c, WallSeeds<D> const& seeds);

}  // namespace coronet
