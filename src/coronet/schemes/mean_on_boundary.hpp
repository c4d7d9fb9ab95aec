// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A pressure operator whose mean pressure acts on the boundary of the liquid. With B = V div of another operator, V the
// volumes, P p = p - V.p/sum V what p has above its mean, and G the derivative of the content of the boundary
// (surface/boundary.hpp),
//     B' = P^T B + V G^T/sum V,   M dv/dt = B'^T p = B^T (p - p_mean) + p_mean G,
// for each piece of liquid. B' v = 0 says that the liquid expands nowhere more than elsewhere, and that the content of
// its boundary does not change. Particles at the surface then feel no constant pressure through their truncated
// surroundings, whatever the arrangement, so they do not crowd there (surface/tension.hpp). Force and divergence stay
// dual, and momentum and angular momentum conserved, if they are in the other operator. Of its A,
//     A' p = P^T (A P p + c p_mean) + V (c.P p + G.M^-1 G p_mean)/sum V,   c = B M^-1 G.

#include <memory>
#include <vector>

#include "coronet/schemes/pressure_operator.hpp"
#include "coronet/surface/boundary.hpp"

namespace coronet {

template <int D>
class MeanOnBoundary : public PressureOperator<D> {
public:
    explicit MeanOnBoundary(std::unique_ptr<PressureOperator<D>> inner) : inner_(std::move(inner)) {}

    /// To be called before each set_up, with the particles as they are there; it is borrowed until the next.
    void set_boundary(Boundary<D> const& boundary) { boundary_ = &boundary; }

    void set_up(Particles<D>& particles, Neighbours<D> const& neighbours) override;
    void source(double step, std::span<double> b) override;
    void divergence(std::vector<Vector<double, D>> const& v, std::span<double> to) override;
    void apply(std::span<double const> p, std::span<double> Ap) override;
    std::size_t singular_matrices() const override { return inner_->singular_matrices(); }
    std::span<double const> diagonal() override { return inner_->diagonal(); }
    SmoothEnergy smooth_energy() override { return inner_->smooth_energy(); }
    void accelerate(std::span<double const> p) override;

private:
    void look_at_mean();
    void split(std::span<double const> p);
    void replace_sums(std::vector<double> const& sums, std::span<double> b) const;

    std::unique_ptr<PressureOperator<D>> inner_;
    Boundary<D> const* boundary_ = nullptr;
    Particles<D>* particles_ = nullptr;
    std::vector<double> volume_, stiffness_;    ///< of each piece: sum V, G.M^-1 G
    std::vector<std::vector<double>> of_mean_;  ///< c, of each piece; empty until it is asked for
    std::vector<double> mean_, above_;          ///< of the p at hand
};

}  // namespace coronet
