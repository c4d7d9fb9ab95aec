// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pressure operator whose force is the negative transpose of its divergence (Fang et al. 2009, Eqs 46 and 52). With
// the corrected gradient grad W~_ij = L_i grad W_ij - q_i W_ij (terms/gradient_correction.hpp), C_ij = V_j grad W~_ij
// and g_i = sum_j C_ij over the neighbours,
//     div_i(v) = sum_j (V v)_j . grad W~_ij - v_i . g_i,
//     dv_i/dt  = -(1/rho_i) (p_i g_i + sum_j (V p)_j (L_j grad W_ij + q_j W_ij)).
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
// is solved instead. A and C agree on smooth pressures, so the divergence that is left, d (C - A) p, is that of short
// waves and, at the surface, of its outermost layers. The force stays the dual one: momentum is conserved as before,
// and the energy still never grows for d <= 1/2. With d = 0 the projection is exact.
//
// A solve applies A a hundred times to the same arrangement, so the kernel and its gradient are kept for every pair:
// an application is then two passes over them, a tenth of the time of two sweeps that evaluate the kernel.

#include <vector>

#include "coronet/kernels/kernel.hpp"
#include "coronet/schemes/pressure_operator.hpp"

namespace coronet {

/// Of pressure force and divergence: plain SPH, or exact for linear fields (the finite particle method).
enum class PressureGradientKind { plain, corrected };

template <int D>
class ConsistentPressure : public PressureOperator<D> {
public:
    ConsistentPressure(Kernel const& kernel, PressureGradientKind kind, double compact_share = 0)
        : kernel_(kernel), kind_(kind), compact_share_(compact_share) {}

    void set_up(Particles<D>& particles, Neighbours<D> const& neighbours) override;
    void source(double step, std::span<double> b) override;
    void apply(std::span<double const> p, std::span<double> Ap) override;
    std::span<double const> diagonal() override;
    SmoothEnergy<D> smooth_energy() override;
    void accelerate(std::span<double const> p) override;

    /// Particles whose corrected gradient fell back to the plain one at the last set_up.
    std::size_t singular_matrices() const { return singular_matrices_; }

private:
    struct Link {
        Vector<double, D> gradW;  ///< of i for its neighbour j [1/m^(D+1)]
        double W;                 ///< [1/m^D]
        double compact;           ///< minus the entry of the compact Laplacian
        Index j;
    };
    /// What a particle is to its own row and to those of its neighbours.
    struct Gradient {
        Matrix<double, D> L;
        Vector<double, D> q, g;  ///< [1/m]
    };

    void list(Particles<D> const& particles, Neighbours<D> const& neighbours);
    std::span<Link const> row(std::size_t i) const { return {&links_[begin_[i]], begin_[i + 1] - begin_[i]}; }
    /// dv/dt of all particles under p, to `to`.
    void force(std::span<double const> p, std::vector<Vector<double, D>>& to);
    /// to[i] = factor V_i div_i(v).
    void divergence(double factor, std::vector<Vector<double, D>> const& v, std::span<double> to) const;

    Kernel kernel_;
    PressureGradientKind kind_;
    double compact_share_;
    Particles<D>* particles_ = nullptr;
    std::vector<std::size_t> begin_;  ///< of the row of i in links_
    std::vector<Link> links_;
    std::vector<Gradient> gradient_;
    struct Push {
        Matrix<double, D> VpL;
        Vector<double, D> Vpq;
    };
    std::vector<Push> push_;
    std::vector<Vector<double, D>> velocity_;
    std::vector<double> diagonal_;  ///< empty until it is asked for
    std::size_t singular_matrices_ = 0;
};

}  // namespace coronet
