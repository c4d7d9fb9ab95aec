// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pressure operator whose force is the negative transpose of its divergence (Fang et al. 2009, Eqs 46 and 52;
// terms/dual_operators.hpp). With B = V div and M the masses, M dv/dt = B^T p and A = B M^-1 B^T: symmetric, positive
// semi-definite, and v + dt M^-1 B^T p has no divergence left once A p = -B v/dt is solved, on any arrangement of
// particles. Momentum is conserved to round-off, angular momentum with the corrected gradient too (but where it falls
// back to the plain one), and the kinetic energy never grows. No boundary condition is imposed: that of the free
// surface, p = 0 about half a spacing outside of the outermost particles, is natural to B^T.
//
// A is applied by two sweeps, the force and its divergence; no matrix is formed.

#include <vector>

#include "coronet/kernels/kernel.hpp"
#include "coronet/schemes/pressure_operator.hpp"

namespace coronet {

/// Of pressure force and divergence: plain SPH, or exact for linear fields (the finite particle method).
enum class PressureGradientKind { plain, corrected };

template <int D>
class ConsistentPressure : public PressureOperator<D> {
public:
    ConsistentPressure(Kernel const& kernel, PressureGradientKind kind) : kernel_(kernel), kind_(kind) {}

    void set_up(Particles<D>& particles, Neighbours<D> const& neighbours) override;
    void source(double step, std::span<double> b) override;
    void apply(std::span<double const> p, std::span<double> Ap) override;
    std::span<double const> diagonal() override;
    SmoothEnergy<D> smooth_energy() override;
    void accelerate(std::span<double const> p) override;

    /// Particles whose corrected gradient fell back to the plain one at the last set_up.
    std::size_t singular_matrices() const { return singular_matrices_; }

private:
    /// to[i] = factor V_i div_i, from WeightedVelocity and v(i).
    template <class Velocities>
    void divergence(double factor, std::span<double> to, Velocities const& v);
    template <class Close>
    void force(std::span<double const> p, Close const& close);

    Kernel kernel_;
    PressureGradientKind kind_;
    Particles<D>* particles_ = nullptr;
    Neighbours<D> const* neighbours_ = nullptr;
    std::vector<Vector<double, D>> weight_;  ///< g_i = sum_j C_ij over the neighbours [1/m]
    std::vector<double> diagonal_;           ///< empty until it is asked for
    std::size_t singular_matrices_ = 0;
};

}  // namespace coronet
