// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/viscous_operator.hpp"

namespace coronet {

template <int D>
void ViscousOperator<D>::set_up(Particles<D> const& particles, Neighbours<D> const& neighbours) {
    gradients_.set_up(particles, neighbours, kernel_, GradientKind::corrected);
    auto const view = particles.view();
    volume_.assign(view.template at<Volume>(), view.template at<Volume>() + particles.size());
}

template <int D>
Matrix<double, D> ViscousOperator<D>::gradient(std::size_t i, std::span<double const> v) const {
    using R = typename KeptGradients<D>::Lanes;
    Matrix<R, D> slope;
    gradients_.for_gradients(i, [&](Index const* j, Vector<R, D> const& G) {
        Index place[pack_size<double>];
        for (int lane = 0; lane < pack_size<double>; ++lane) place[lane] = D * j[lane];
        Vector<R, D> v_j;
        unrolled<D>([&](int a) { v_j[a] = fetch_one(&v[static_cast<std::size_t>(a)], place); });
        slope += outer(v_j, G);
    });
    Matrix<double, D> grad;
    unrolled<D * D>([&](int ab) {
        grad[ab] =
            (sum(slope[ab]) + v[D * i + static_cast<std::size_t>(ab / D)] * gradients_.own(i)[ab % D]) / volume_[i];
    });
    return grad;
}

template <int D>
void ViscousOperator<D>::set_viscosity(GeneralisedNewtonian const& liquid, std::span<double const> v) {
    viscosity_.resize(gradients_.size());
    for_each(viscosity_.size(), [&](std::size_t i) {
        if (gradients_.fell_back(i)) viscosity_[i] = 0;
        else viscosity_[i] = liquid.is_newtonian() ? liquid.rheology.viscosity : liquid.viscosity(gradient(i, v));
    });
}

template <int D>
void ViscousOperator<D>::apply(std::span<double const> v, std::span<double> Kv) {
    using R = typename KeptGradients<D>::Lanes;
    constexpr int size = Symmetric<double, D>::size;
    std::size_t const n = gradients_.size();
    stress_.resize(size * n);
    for_each(n, [&](std::size_t i) {
        auto const S = stress(i, v);
        unrolled<size>([&](int m) { stress_[static_cast<std::size_t>(m) * n + i] = S[m]; });
    });
    for_each(n, [&](std::size_t i) {
        Vector<R, D> push;
        gradients_.for_pushes(i, [&](Index const* j, Vector<R, D> const& G) {
            Symmetric<R, D> S;
            unrolled<size>([&](int m) { S[m] = fetch_one(&stress_[static_cast<std::size_t>(m) * n], j); });
            push += S * G;
        });
        Symmetric<double, D> S;
        unrolled<size>([&](int m) { S[m] = stress_[static_cast<std::size_t>(m) * n + i]; });
        auto const own = S * gradients_.own(i);
        unrolled<D>([&](int k) { Kv[D * i + static_cast<std::size_t>(k)] = sum(push[k]) + own[k]; });
    });
}

/// A gradient v (x) c has 2 d : d = |v|^2 |c|^2 + (1 - 2/D) (v . c)^2. The velocity of i enters its own gradient with
/// c = G_ii/V_i and that of its neighbour j with c = G_ji/V_j.
template <int D>
void ViscousOperator<D>::diagonal(std::span<double> K) const {
    using R = typename KeptGradients<D>::Lanes;
    std::size_t const n = gradients_.size();
    std::vector<double> mu_per_volume(n);
    for_each(n, [&](std::size_t i) { mu_per_volume[i] = viscosity_[i] / volume_[i]; });
    for_each(n, [&](std::size_t i) {
        auto const add = []<class N>(N const& mu, Vector<N, D> const& G, Vector<N, D>& to) {
            N const G2 = norm2(G);
            unrolled<D>([&](int k) { to[k] += mu * (G2 + N(1 - 2.0 / D) * G[k] * G[k]); });
        };
        Vector<R, D> of_others;
        gradients_.for_pushes(
            i, [&](Index const* j, Vector<R, D> const& G) { add(fetch_one(mu_per_volume.data(), j), G, of_others); });
        Vector<double, D> total;
        add(mu_per_volume[i], gradients_.own(i), total);
        unrolled<D>([&](int k) { K[D * i + static_cast<std::size_t>(k)] = total[k] + sum(of_others[k]); });
    });
}

template class ViscousOperator<2>;
template class ViscousOperator<3>;

}  // namespace coronet
