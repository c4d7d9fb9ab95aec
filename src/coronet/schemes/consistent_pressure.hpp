// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pressure operator whose force is the negative transpose of its divergence (Fang et al. 2009, Eqs 46 and 52), both
// from schemes/kept_gradients.hpp:
//     div_i(v) = trace grad_i(v),   m_i dv_i/dt = (grad^T V p I)_i.
// With B = V div and M the masses, M dv/dt = B^T p and A = B M^-1 B^T: symmetric, positive semi-definite, and v + dt
// M^-1 B^T p has no divergence left once A p = -B v/dt is solved, on any arrangement of particles. Momentum is
// conserved to round-off, angular momentum with the corrected gradient too (but where it falls back to the plain one),
// and the kinetic energy never grows. No boundary condition is imposed: that of the free surface, p = 0 about half a
// spacing outside of the outermost particles, is natural to B^T.
//
// Checkerboards. A pressure that alternates from particle to particle exerts almost no force, so A hardly sees it, and
// what little divergence there is at such short waves asks for a huge one: conjugate gradients then need hundreds of
// iterations, and the noise wrecks the arrangement of the particles. With a share d of the compact Laplacian C (Lobo
// 2011, Eq 3.61, free at the surface), which sees a checkerboard best,
//     ((1 - d) A + d C) p = -B v/dt
// is solved instead, where the diagonal of C has A 1 added to it: then A and C agree on constant pressures, too, also
// at the surface, where those push. (Without it a drop under pressure swells.)
// They agree on smooth pressures to the order of the scheme, so the divergence that is left, d (C - A) p, is that of
// short waves. The force stays the dual one: momentum is conserved as before. With d = 0 the projection is exact.

#include <vector>

#include "coronet/schemes/kept_gradients.hpp"
#include "coronet/schemes/pressure_operator.hpp"

namespace coronet {

template <int D>
class ConsistentPressure : public PressureOperator<D> {
public:
    ConsistentPressure(Kernel const& kernel, GradientKind kind, double compact_share = 0)
        : kernel_(kernel), kind_(kind), compact_share_(compact_share) {}

    void set_up(Particles<D>& particles, Neighbours<D> const& neighbours) override;
    void source(double step, std::span<double> b) override;
    void divergence(std::vector<Vector<double, D>> const& v, std::span<double> to) override;
    void apply(std::span<double const> p, std::span<double> Ap) override;
    std::span<double const> diagonal() override;
    SmoothEnergy smooth_energy() override;
    void accelerate(std::span<double const> p) override;

    std::size_t singular_matrices() const override { return gradients_.singular_matrices(); }

private:
    std::span<double const> compact_diagonal();
    void set_velocity(std::size_t i, Vector<double, D> const& v);
    double divergence(std::size_t i) const;

    Kernel kernel_;
    GradientKind kind_;
    double compact_share_;
    std::vector<double> inverse_mass_;  ///< [1/kg]
    Particles<D>* particles_ = nullptr;
    std::vector<double> share_per_density_;  ///< d/rho
    KeptGradients<D> gradients_;             ///< with the entries of d C for its slopes
    std::vector<double> compact_diagonal_;   ///< of d C; empty until it is asked for
    std::vector<double> velocity_[D];  ///< whose divergence is formed
    std::vector<double> diagonal_;     ///< empty until it is asked for
};

}  // namespace coronet
