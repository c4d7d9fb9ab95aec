// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/consistent_pressure.hpp"

namespace coronet {

namespace {

using Lanes = Pack<double>;

}  // namespace

template <int D>
void ConsistentPressure<D>::set_up(Particles<D>& particles, Neighbours<D> const& neighbours) {
    particles_ = &particles;
    particles.allocate(Fields<Velocity, Acceleration>{});
    diagonal_.clear();
    compact_diagonal_.clear();
    auto const view = particles.view();
    std::size_t const n = particles.size();
    inverse_mass_.resize(n);
    share_per_density_.resize(compact_share_ > 0 ? n : 0);
    for (auto& component : velocity_) component.resize(n);
    for_each(n, [&](std::size_t i) {
        inverse_mass_[i] = 1 / view.template at<Mass>()[i];
        if (compact_share_ > 0) share_per_density_[i] = compact_share_ / view.template at<Density>()[i];
    });
    gradients_.set_up(particles, neighbours, kernel_, kind_, share_per_density_);
}

/// C has V_i V_j (1/rho_i + 1/rho_j) W'/r off the diagonal, which for a uniform density is that of Lobo, and minus
/// their sum and A 1 on it.
template <int D>
std::span<double const> ConsistentPressure<D>::compact_diagonal() {
    if (compact_share_ == 0 || !compact_diagonal_.empty()) return compact_diagonal_;
    compact_diagonal_.resize(gradients_.size());
    for_each(compact_diagonal_.size(),
             [&](std::size_t i) { set_velocity(i, inverse_mass_[i] * gradients_.push_of_constant(i)); });
    for_each(compact_diagonal_.size(), [&](std::size_t i) {
        compact_diagonal_[i] = compact_share_ * divergence(i) - gradients_.sum_of_slopes(i);
    });
    return compact_diagonal_;
}

template <int D>
void ConsistentPressure<D>::set_velocity(std::size_t i, Vector<double, D> const& v) {
    unrolled<D>([&](int a) { velocity_[a][i] = v[a]; });
}

/// V_i div_i of the velocity.
template <int D>
double ConsistentPressure<D>::divergence(std::size_t i) const {
    Vector<Lanes, D> total;
    gradients_.for_gradients(i, [&](Index const* j, Vector<Lanes, D> const& G) {
        unrolled<D>([&](int a) { total[a] += G[a] * fetch_one(velocity_[a].data(), j); });
    });
    double own = 0;
    unrolled<D>([&](int a) { own += gradients_.own(i)[a] * velocity_[a][i]; });
    unrolled<D - 1>([&](int a) { total[0] += total[a + 1]; });
    return sum(total[0]) + own;
}

template <int D>
void ConsistentPressure<D>::source(double step, std::span<double> b) {
    auto const view = particles_->view();
    std::size_t const n = particles_->size();
    // A common translation has no divergence; taken off first, it costs no digits.
    Vector<double, D> const mean = (1 / static_cast<double>(n)) * sum_over(n, Vector<double, D>{}, [&](std::size_t i) {
                                       return view.template get<Velocity>(i);
                                   });
    for_each(n, [&](std::size_t i) { set_velocity(i, view.template get<Velocity>(i) - mean); });
    for_each(n, [&](std::size_t i) { b[i] = -divergence(i) / step; });
}

template <int D>
void ConsistentPressure<D>::divergence(std::vector<Vector<double, D>> const& v, std::span<double> to) {
    for_each(to.size(), [&](std::size_t i) { set_velocity(i, v[i]); });
    for_each(to.size(), [&](std::size_t i) { to[i] = divergence(i); });
}

/// B^T p and what C adds share a pass: both want the pressures of the neighbours.
template <int D>
void ConsistentPressure<D>::apply(std::span<double const> p, std::span<double> Ap) {
    bool const compact = compact_share_ > 0;
    auto const own = compact_diagonal();
    for_each(p.size(), [&](std::size_t i) {
        Vector<Lanes, D> push;
        Lanes of_compact(0.0);
        if (compact)
            gradients_.for_pushes_and_slopes(i, [&](Index const* j, Vector<Lanes, D> const& G, Lanes const& entry) {
                Lanes const p_j = fetch_one(p.data(), j);
                push += p_j * G;
                of_compact += p_j * entry;
            });
        else
            gradients_.for_pushes(
                i, [&](Index const* j, Vector<Lanes, D> const& G) { push += fetch_one(p.data(), j) * G; });
        Vector<double, D> force = p[i] * gradients_.own(i);
        unrolled<D>([&](int a) { force[a] += sum(push[a]); });
        set_velocity(i, inverse_mass_[i] * force);
        if (compact) Ap[i] = own[i] * p[i] + sum(of_compact);
    });
    for_each(p.size(),
             [&](std::size_t i) { Ap[i] = compact ? Ap[i] + (1 - compact_share_) * divergence(i) : divergence(i); });
}

template <int D>
void ConsistentPressure<D>::accelerate(std::span<double const> p) {
    auto const view = particles_->view();
    for_each(p.size(), [&](std::size_t i) {
        Vector<Lanes, D> push;
        gradients_.for_pushes(i,
                              [&](Index const* j, Vector<Lanes, D> const& G) { push += fetch_one(p.data(), j) * G; });
        Vector<double, D> force = p[i] * gradients_.own(i);
        unrolled<D>([&](int a) { force[a] += sum(push[a]); });
        view.template set<Acceleration>(i, inverse_mass_[i] * force);
    });
}

/// That of A is sum_j |G_ij|^2/m_j.
template <int D>
std::span<double const> ConsistentPressure<D>::diagonal() {
    if (!diagonal_.empty()) return diagonal_;
    auto const of_C = compact_diagonal();
    diagonal_.resize(particles_->size());
    for_each(diagonal_.size(), [&](std::size_t i) {
        Lanes of_others(0.0);
        gradients_.for_gradients(i, [&](Index const* j, Vector<Lanes, D> const& G) {
            of_others += fetch_one(inverse_mass_.data(), j) * norm2(G);
        });
        double const of_A = sum(of_others) + inverse_mass_[i] * norm2(gradients_.own(i));
        diagonal_[i] = (1 - compact_share_) * of_A + (of_C.empty() ? 0 : of_C[i]);
    });
    return diagonal_;
}

/// p^T A p = sum_i m_i |dv_i(p)|^2, and the force of a smooth p is that of grad p and of the local value. The square of
/// their sum is at most twice the sum of their squares, which is taken: the sum itself vanishes for p that grow
/// outwards at the surface by e in about a spacing, and a grid that believes in it gives them all they ask for.
template <int D>
SmoothEnergy ConsistentPressure<D>::smooth_energy() {
    auto const view = particles_->view();
    std::size_t const n = particles_->size();
    SmoothEnergy energy{std::vector<double>(n), std::vector<double>(n)};
    for_each(n, [&](std::size_t i) {
        double const V = view.template at<Volume>()[i];
        energy.a[i] = V / view.template at<Density>()[i];
        energy.e[i] = energy.a[i] * norm2(gradients_.push_of_constant(i)) / (V * V);
    });
    return energy;
}

template class ConsistentPressure<2>;
template class ConsistentPressure<3>;

}  // namespace coronet
