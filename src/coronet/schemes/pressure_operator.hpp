// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a projection needs of its discrete pressure: the equation A p = b, with A the divergence of the pressure force
// and b the divergence of the velocity before it, and the force itself. Row i is that of particle i times its volume,
// which makes A symmetric. Virtual calls happen a few times an iteration, never per pair.

#include <span>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"
#include "coronet/solvers/grid_multigrid.hpp"

namespace coronet {

template <int D>
class PressureOperator {
public:
    virtual ~PressureOperator() = default;

    /// Everything that depends on positions alone. The lists must be those of now; Position, Mass, Density and Volume
    /// must be set, and neither may change, nor the particles be re-ordered, until the next set_up. Particles and lists
    /// are borrowed.
    virtual void set_up(Particles<D>& particles, Neighbours<D> const& neighbours) = 0;

    /// b = -V div(v)/step [m^D/s^2] of the field Velocity, step in s.
    virtual void source(double step, std::span<double> b) = 0;
    /// to = V div(v), v of every particle.
    virtual void divergence(std::vector<Vector<double, D>> const& v, std::span<double> to) = 0;
    /// Ap = A p [m^D/s^2], p in Pa.
    virtual void apply(std::span<double const> p, std::span<double> Ap) = 0;
    /// Particles whose gradient fell back to the plain one at the last set_up.
    virtual std::size_t singular_matrices() const { return 0; }
    /// The diagonal of A.
    virtual std::span<double const> diagonal() = 0;
    /// What A does to smooth pressures, for a multigrid: a = V/rho.
    virtual SmoothEnergy smooth_energy() = 0;
    /// Sets the field Acceleration to that of the pressure p [Pa].
    virtual void accelerate(std::span<double const> p) = 0;
};

}  // namespace coronet
