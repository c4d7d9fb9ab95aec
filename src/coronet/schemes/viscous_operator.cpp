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
    return gradients_.gradient(i, [&](std::size_t j) {
        Vector<double, D> v_j;
        unrolled<D>([&](int k) { v_j[k] = v[D * j + static_cast<std::size_t>(k)]; });
        return v_j;
    });
}

template <int D>
void ViscousOperator<D>::set_viscosity(GeneralisedNewtonian const& liquid, std::span<double const> v) {
    viscosity_.resize(gradients_.size());
    for_each(viscosity_.size(), [&](std::size_t i) {
        viscosity_[i] = liquid.is_newtonian() ? liquid.rheology.viscosity : liquid.viscosity(gradient(i, v));
    });
}

template <int D>
void ViscousOperator<D>::apply(std::span<double const> v, std::span<double> Kv) {
    gradients_.transposed(
        [&](std::size_t i) { return stress(i, v); },
        [&](std::size_t i, Vector<double, D> const& sum) {
            unrolled<D>([&](int k) { Kv[D * i + static_cast<std::size_t>(k)] = -volume_[i] * sum[k]; });
        });
}

/// A gradient v (x) c has 2 d : d = |v|^2 |c|^2 + (1 - 2/D) (v . c)^2. The velocity of i enters its own gradient with
/// c = -g_i and that of its neighbour j with c = V_i grad W~_ji.
template <int D>
void ViscousOperator<D>::diagonal(std::span<double> K) const {
    for_each(gradients_.size(), [&](std::size_t i) {
        Vector<double, D> sum;
        auto const add = [&](double Vmu, Vector<double, D> const& c) {
            double const c2 = norm2(c);
            unrolled<D>([&](int k) { sum[k] += Vmu * (c2 + (1 - 2.0 / D) * c[k] * c[k]); });
        };
        add(volume_[i] * viscosity_[i], gradients_.correction(i).g);
        for (auto const& link : gradients_.row(i)) {
            auto const j = static_cast<std::size_t>(link.j);
            add(volume_[j] * viscosity_[j], volume_[i] * gradients_.weight(j, {-link.gradW, link.W, link.F, link.j}));
        }
        unrolled<D>([&](int k) { K[D * i + static_cast<std::size_t>(k)] = sum[k]; });
    });
}

template class ViscousOperator<2>;
template class ViscousOperator<3>;

}  // namespace coronet
