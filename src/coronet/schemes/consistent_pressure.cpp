// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/consistent_pressure.hpp"

#include "coronet/terms/gradient_correction.hpp"

namespace coronet {

/// The rows of neighbours inside the support, with the kernel between them.
template <int D>
void ConsistentPressure<D>::list(Particles<D> const& particles, Neighbours<D> const& neighbours) {
    std::size_t const n = particles.size();
    auto const view = particles.view();
    double const H2 = kernel_.support * kernel_.support;
    auto const for_near = [&](std::size_t i, auto const& act) {
        auto const x_i = view.template get<Position>(i);
        for (Index const j : neighbours.row(i)) {
            auto const x = x_i - view.template get<Position>(static_cast<std::size_t>(j));
            double const r2 = norm2(x);
            if (r2 < H2) act(j, x, r2);
        }
    };
    begin_.assign(n + 1, 0);
    for_each(n, [&](std::size_t i) { for_near(i, [&](auto const&...) { ++begin_[i + 1]; }); });
    for (std::size_t i = 0; i < n; ++i) begin_[i + 1] += begin_[i];
    links_.resize(begin_[n] + 1);
    for_each(n, [&](std::size_t i) {
        std::size_t next = begin_[i];
        for_near(i, [&](Index j, Vector<double, D> const& x, double r2) {
            auto const [W, F] = kernel_(r2);
            auto const k = static_cast<std::size_t>(j);
            double const weight = 4 * view.template at<Volume>()[i] * view.template at<Volume>()[k] /
                                  (view.template at<Density>()[i] + view.template at<Density>()[k]);
            links_[next++] = {F * x, W, -weight * F, j};
        });
    });
}

template <int D>
void ConsistentPressure<D>::set_up(Particles<D>& particles, Neighbours<D> const& neighbours) {
    particles_ = &particles;
    particles.allocate(Fields<Velocity, Acceleration>{});
    list(particles, neighbours);
    std::size_t const n = particles.size();
    auto const view = particles.view();
    gradient_.resize(n);
    diagonal_.clear();
    double const W_at_zero = kernel_.at_zero();
    singular_matrices_ = static_cast<std::size_t>(sum_over(n, 0.0, [&](std::size_t i) {
        double W0 = 0;
        Vector<double, D> W1, G0;
        Symmetric<double, D> G1;
        auto const x_i = view.template get<Position>(i);
        for (Link const& link : row(i)) {
            auto const j = static_cast<std::size_t>(link.j);
            double const V = view.template at<Volume>()[j];
            auto const x = view.template get<Position>(j) - x_i;
            W0 += V * link.W;
            W1 += (V * link.W) * x;
            G0 += V * link.gradW;
            G1 += outer_of_parallels(V * link.gradW, x);
        }
        if (kind_ == PressureGradientKind::plain) {
            gradient_[i] = {identity<double, D>(), {}, G0};
            return 0.0;
        }
        GradientCorrection<double, D> const c(W0 + view.template at<Volume>()[i] * W_at_zero, W1, G0, G1);
        gradient_[i] = {c.L, c.q, c.L * G0 - W0 * c.q};
        return c.fell_back;
    }));
}

template <int D>
void ConsistentPressure<D>::divergence(double factor, std::vector<Vector<double, D>> const& v,
                                       std::span<double> to) const {
    auto const view = particles_->view();
    double const* const V = view.template at<Volume>();
    for_each(to.size(), [&](std::size_t i) {
        Matrix<double, D> slope;
        Vector<double, D> jump;
        for (Link const& link : row(i)) {
            auto const j = static_cast<std::size_t>(link.j);
            Vector<double, D> const Vv = V[j] * v[j];
            slope += outer(Vv, link.gradW);
            jump += link.W * Vv;
        }
        Gradient const& at = gradient_[i];
        double div = -dot(jump, at.q) - dot(v[i], at.g);
        unrolled<D * D>([&](int ab) { div += at.L[ab] * slope[ab]; });
        to[i] = factor * V[i] * div;
    });
}

template <int D>
void ConsistentPressure<D>::source(double step, std::span<double> b) {
    auto const view = particles_->view();
    std::size_t const n = particles_->size();
    // A common translation has no divergence; taken off first, it costs no digits.
    Vector<double, D> const mean = (1 / static_cast<double>(n)) * sum_over(n, Vector<double, D>{}, [&](std::size_t i) {
                                       return view.template get<Velocity>(i);
                                   });
    velocity_.resize(n);
    for_each(n, [&](std::size_t i) { velocity_[i] = view.template get<Velocity>(i) - mean; });
    divergence(-1 / step, velocity_, b);
}

template <int D>
void ConsistentPressure<D>::force(std::span<double const> p, std::vector<Vector<double, D>>& to) {
    auto const view = particles_->view();
    std::size_t const n = p.size();
    push_.resize(n);
    to.resize(n);
    for_each(n, [&](std::size_t i) {
        double const Vp = view.template at<Volume>()[i] * p[i];
        push_[i] = {Vp * gradient_[i].L, Vp * gradient_[i].q};
    });
    for_each(n, [&](std::size_t i) {
        Vector<double, D> sum = p[i] * gradient_[i].g;
        for (Link const& link : row(i)) {
            Push const& push = push_[static_cast<std::size_t>(link.j)];
            sum += push.VpL * link.gradW + link.W * push.Vpq;
        }
        to[i] = (-1 / view.template at<Density>()[i]) * sum;
    });
}

template <int D>
void ConsistentPressure<D>::apply(std::span<double const> p, std::span<double> Ap) {
    force(p, velocity_);
    divergence(1 - compact_share_, velocity_, Ap);
    if (compact_share_ == 0) return;
    for_each(p.size(), [&](std::size_t i) {
        double sum = 0;
        for (Link const& link : row(i)) sum += link.compact * (p[i] - p[static_cast<std::size_t>(link.j)]);
        Ap[i] += compact_share_ * sum;
    });
}

template <int D>
void ConsistentPressure<D>::accelerate(std::span<double const> p) {
    auto const view = particles_->view();
    force(p, velocity_);
    for_each(p.size(), [&](std::size_t i) { view.template set<Acceleration>(i, velocity_[i]); });
}

/// B_ij = V_i C_ij off the diagonal and -V_i g_i on it, so that of A is sum_j |B_ij|^2/m_j.
template <int D>
std::span<double const> ConsistentPressure<D>::diagonal() {
    if (!diagonal_.empty()) return diagonal_;
    diagonal_.resize(particles_->size());
    auto const view = particles_->view();
    for_each(diagonal_.size(), [&](std::size_t i) {
        Gradient const& at = gradient_[i];
        double sum = norm2(at.g) / view.template at<Mass>()[i], compact = 0;
        for (Link const& link : row(i)) {
            auto const j = static_cast<std::size_t>(link.j);
            sum += view.template at<Volume>()[j] / view.template at<Density>()[j] *
                   norm2(at.L * link.gradW - link.W * at.q);
            compact += link.compact;
        }
        double const V = view.template at<Volume>()[i];
        diagonal_[i] = (1 - compact_share_) * V * V * sum + compact_share_ * compact;
    });
    return diagonal_;
}

/// p^T A p = sum_i m_i |dv_i(p)|^2, and the force of a smooth p is that of grad p and of the local value.
template <int D>
SmoothEnergy<D> ConsistentPressure<D>::smooth_energy() {
    auto const view = particles_->view();
    std::size_t const n = particles_->size();
    SmoothEnergy<D> energy{std::vector<double>(n), std::vector<Vector<double, D>>(n), std::vector<double>(n)};
    force(std::vector<double>(n, 1.0), energy.w);
    for_each(n, [&](std::size_t i) {
        double const rho = view.template at<Density>()[i];
        energy.a[i] = view.template at<Volume>()[i] / rho;
        energy.w[i] = -rho * energy.w[i];
    });
    return energy;
}

template class ConsistentPressure<2>;
template class ConsistentPressure<3>;

}  // namespace coronet
