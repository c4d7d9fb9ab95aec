// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/consistent_pressure.hpp"

#include "coronet/pairs/sweep.hpp"
#include "coronet/schemes/laws.hpp"
#include "coronet/terms/dual_operators.hpp"
#include "coronet/terms/gradient_correction.hpp"

namespace coronet {

template <int D>
void ConsistentPressure<D>::set_up(Particles<D>& particles, Neighbours<D> const& neighbours) {
    particles_ = &particles;
    neighbours_ = &neighbours;
    particles.allocate(Fields<Velocity, Acceleration, GradientMatrix, GradientOffset, WeightedVelocity>{});
    if (kind_ == PressureGradientKind::plain) particles.allocate(Fields<WeightedPressure>{});
    else particles.allocate(Fields<CorrectedStress, StressOffset, FellBack>{});
    std::size_t const n = particles.size();
    weight_.resize(n);
    diagonal_.clear();
    auto const view = particles.view();

    // The laws that a scheme sweeps for its velocity gradients sum the moments, too.
    if (kind_ == PressureGradientKind::plain) {
        auto const close = [&](std::size_t i, auto const& sums) {
            weight_[i] = sums.G0;
            view.template set<GradientMatrix>(i, identity<double, D>());
        };
        sweep(particles, neighbours, kernel_, Precision::full,
              Part{neighbours.all(), PlainGradientsAndSums{}, OneByOne{close}});
        return;
    }
    double const kernel_at_zero = kernel_.at_zero();
    auto const close = [&](std::size_t i, auto const& sums) {
        GradientCorrection<double, D> const correction(sums.W0 + view.template at<Volume>()[i] * kernel_at_zero,
                                                       sums.W1, sums.G0, sums.G1);
        weight_[i] = correction.L * sums.G0 - sums.W0 * correction.q;
        view.template set<GradientMatrix>(i, correction.L);
        view.template set<GradientOffset>(i, correction.q);
        view.template at<FellBack>()[i] = correction.fell_back;
    };
    sweep(particles, neighbours, kernel_, Precision::full,
          Part{neighbours.all(), CorrectedGradients{}, OneByOne{close}});
    singular_matrices_ =
        static_cast<std::size_t>(sum_over(n, 0.0, [&](std::size_t i) { return view.template at<FellBack>()[i]; }));
}

template <int D>
template <class Velocities>
void ConsistentPressure<D>::divergence(double factor, std::span<double> to, Velocities const& v) {
    auto const view = particles_->view();
    auto const close = [&](std::size_t i, auto const& sums) {
        to[i] = factor * view.template at<Volume>()[i] * (sums.div - dot(v(i), weight_[i]));
    };
    auto const run = [&](auto const& law) {
        sweep(*particles_, *neighbours_, kernel_, Precision::full, Part{neighbours_->all(), law, OneByOne{close}});
    };
    if (kind_ == PressureGradientKind::plain) run(Sum<PlainDivergence>{});
    else run(Sum<CorrectedDivergence>{});
}

template <int D>
void ConsistentPressure<D>::source(double step, std::span<double> b) {
    auto const view = particles_->view();
    std::size_t const n = particles_->size();
    // A common translation has no divergence; taken off first, it costs no digits.
    Vector<double, D> const mean = (1 / static_cast<double>(n)) * sum_over(n, Vector<double, D>{}, [&](std::size_t i) {
                                       return view.template get<Velocity>(i);
                                   });
    auto const v = [&](std::size_t i) { return view.template get<Velocity>(i) - mean; };
    for_each(n, [&](std::size_t i) { view.template set<WeightedVelocity>(i, view.template at<Volume>()[i] * v(i)); });
    divergence(-1 / step, b, v);
}

template <int D>
template <class Close>
void ConsistentPressure<D>::force(std::span<double const> p, Close const& close) {
    auto const view = particles_->view();
    auto const own = [&](std::size_t i) { return (-p[i] / view.template at<Density>()[i]) * weight_[i]; };
    auto const run = [&](auto const& law) {
        sweep(*particles_, *neighbours_, kernel_, Precision::full,
              Part{neighbours_->all(), law,
                   OneByOne{[&](std::size_t i, auto const& sums) { close(i, sums.dv + own(i)); }}});
    };
    if (kind_ == PressureGradientKind::plain) {
        for_each(p.size(), [&](std::size_t i) {
            view.template at<WeightedPressure>()[i] = view.template at<Volume>()[i] * p[i];
        });
        run(Sum<PressurePush>{});
        return;
    }
    for_each(p.size(), [&](std::size_t i) {
        double const minus_Vp = -view.template at<Volume>()[i] * p[i];
        view.template set<CorrectedStress>(i, minus_Vp * view.template get<GradientMatrix>(i));
        view.template set<StressOffset>(i, minus_Vp * view.template get<GradientOffset>(i));
    });
    run(CorrectedForces{});
}

template <int D>
void ConsistentPressure<D>::apply(std::span<double const> p, std::span<double> Ap) {
    auto const view = particles_->view();
    force(p, [&](std::size_t i, Vector<double, D> const& dv) {
        view.template set<WeightedVelocity>(i, view.template at<Volume>()[i] * dv);
    });
    divergence(1, Ap, [&](std::size_t i) {
        return (1 / view.template at<Volume>()[i]) * view.template get<WeightedVelocity>(i);
    });
}

template <int D>
void ConsistentPressure<D>::accelerate(std::span<double const> p) {
    auto const view = particles_->view();
    force(p, [&](std::size_t i, Vector<double, D> const& dv) { view.template set<Acceleration>(i, dv); });
}

/// B_ij = V_i C_ij off the diagonal and -V_i g_i on it, so A_ii = sum_j |B_ij|^2/m_j.
template <int D>
std::span<double const> ConsistentPressure<D>::diagonal() {
    if (!diagonal_.empty()) return diagonal_;
    diagonal_.resize(particles_->size());
    auto const view = particles_->view();
    auto const close = [&](std::size_t i, auto const& sums) {
        double const V = view.template at<Volume>()[i];
        diagonal_[i] = V * V * (sums.square + norm2(weight_[i]) / view.template at<Mass>()[i]);
    };
    sweep(*particles_, *neighbours_, kernel_, Precision::full,
          Part{neighbours_->all(), Sum<GradientSquares>{}, OneByOne{close}});
    return diagonal_;
}

/// p^T A p = sum_i m_i |dv_i(p)|^2, and the force of a smooth p is that of grad p and of the local value.
template <int D>
SmoothEnergy<D> ConsistentPressure<D>::smooth_energy() {
    auto const view = particles_->view();
    std::size_t const n = particles_->size();
    SmoothEnergy<D> energy{std::vector<double>(n), std::vector<Vector<double, D>>(n), std::vector<double>(n)};
    force(std::vector<double>(n, 1.0), [&](std::size_t i, Vector<double, D> const& dv) {
        double const rho = view.template at<Density>()[i];
        energy.a[i] = view.template at<Volume>()[i] / rho;
        energy.w[i] = -rho * dv;
    });
    return energy;
}

template class ConsistentPressure<2>;
template class ConsistentPressure<3>;

}  // namespace coronet
