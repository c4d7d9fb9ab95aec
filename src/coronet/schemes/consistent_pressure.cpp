// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/consistent_pressure.hpp"

namespace coronet {

template <int D>
void ConsistentPressure<D>::set_up(Particles<D>& particles, Neighbours<D> const& neighbours) {
    particles_ = &particles;
    particles.allocate(Fields<Velocity, Acceleration>{});
    gradients_.set_up(particles, neighbours, kernel_, kind_);
    diagonal_.clear();
    auto const view = particles.view();
    volume_per_density_.resize(particles.size());
    for_each(particles.size(), [&](std::size_t i) {
        volume_per_density_[i] = view.template at<Volume>()[i] / view.template at<Density>()[i];
    });
    if (compact_share_ == 0) return;
    of_constant_.resize(particles.size());
    force(std::vector<double>(particles.size(), 1.0), velocity_);
    divergence(1, velocity_, of_constant_);
}

/// V_i V_j (1/rho_i + 1/rho_j) W'/r, which for a uniform density is that of Lobo.
template <int D>
double ConsistentPressure<D>::compact(std::size_t i, typename KeptGradients<D>::Link const& link) const {
    double const* const V = particles_->view().template at<Volume>();
    auto const j = static_cast<std::size_t>(link.j);
    return -(V[i] * volume_per_density_[j] + volume_per_density_[i] * V[j]) * link.F;
}

template <int D>
void ConsistentPressure<D>::divergence(double factor, std::vector<Vector<double, D>> const& v,
                                       std::span<double> to) const {
    auto const view = particles_->view();
    for_each(to.size(), [&](std::size_t i) {
        auto const grad_v = gradients_.gradient(i, [&](std::size_t j) { return v[j]; });
        to[i] = factor * view.template at<Volume>()[i] * trace(grad_v);
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
    to.resize(p.size());
    gradients_.transposed(
        [&](std::size_t i) {
            Symmetric<double, D> stress;
            unrolled<D>([&](int a) { stress(a, a) = p[i]; });
            return stress;
        },
        [&](std::size_t i, Vector<double, D> const& sum) { to[i] = (-1 / view.template at<Density>()[i]) * sum; });
}

template <int D>
void ConsistentPressure<D>::apply(std::span<double const> p, std::span<double> Ap) {
    force(p, velocity_);
    divergence(1 - compact_share_, velocity_, Ap);
    if (compact_share_ == 0) return;
    for_each(p.size(), [&](std::size_t i) {
        double sum = 0;
        for (auto const& link : gradients_.row(i))
            sum += compact(i, link) * (p[i] - p[static_cast<std::size_t>(link.j)]);
        Ap[i] += compact_share_ * (sum + of_constant_[i] * p[i]);
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
        double sum = norm2(gradients_.correction(i).g) / view.template at<Mass>()[i], of_compact = 0;
        for (auto const& link : gradients_.row(i)) {
            auto const j = static_cast<std::size_t>(link.j);
            sum += view.template at<Volume>()[j] / view.template at<Density>()[j] * norm2(gradients_.weight(i, link));
            of_compact += compact(i, link);
        }
        double const V = view.template at<Volume>()[i];
        diagonal_[i] = (1 - compact_share_) * V * V * sum +
                       compact_share_ * (of_compact + (compact_share_ > 0 ? of_constant_[i] : 0));
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
