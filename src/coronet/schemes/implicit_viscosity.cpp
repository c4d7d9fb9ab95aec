// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/implicit_viscosity.hpp"

#include "coronet/solvers/jacobi.hpp"

namespace coronet {

/// The coefficients of all pairs, and their sum for each particle; an image stands for its original.
template <int D>
void ImplicitViscosity<D>::list(Particles<D> const& particles, Neighbours<D> const& neighbours) {
    std::size_t const n = particles.owned();
    auto const view = particles.view();
    double const H2 = kernel_.support * kernel_.support;
    begin_.assign(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i) begin_[i + 1] = begin_[i] + neighbours.row(i).size();
    links_.resize(begin_[n]);
    sum_.resize(n);
    for_each(n, [&](std::size_t i) {
        auto const x = view.template get<Position>(i);
        std::size_t next = begin_[i];
        sum_[i] = 0;
        for (Index const at : neighbours.row(i)) {
            auto const j = static_cast<std::size_t>(at);
            double const mu_i = viscosity_[i], mu_j = viscosity_[j];
            double const mean_viscosity = mu_i + mu_j > 0 ? 2 * mu_i * mu_j / (mu_i + mu_j) : 0;
            double const r2 = norm2(x - view.template get<Position>(j));
            double const c = r2 < H2 ? -view.template get<Volume>(i) * view.template get<Volume>(j) * 2 *
                                           mean_viscosity * kernel_(r2).F
                                     : 0;
            Role const role = particles.role(j);
            bool const is_liquid = role == Role::liquid || role == Role::liquid_image;
            links_[next++] = {is_liquid ? c : 0, is_liquid ? neighbours.images().original(particles, j) : i};
            sum_[i] += is_liquid ? c : 2 * c;
        }
    });
}

template <int D>
Solved ImplicitViscosity<D>::solve(Particles<D>& particles, Neighbours<D> const& neighbours, double step) {
    list(particles, neighbours);
    std::size_t const n = particles.owned();
    auto const view = particles.view();
    for (auto* numbers : {&diagonal_, &b_, &x_}) numbers->resize(D * n);
    for_each(n, [&](std::size_t i) {
        for (std::size_t k = 0; k < D; ++k) {
            std::size_t const at = D * i + k;
            double const m = view.template at<Mass>()[i];
            diagonal_[at] = m + step * sum_[i];
            b_[at] = m * view.template at<Acceleration>(static_cast<int>(k))[i];
            x_[at] = b_[at] / diagonal_[at];
        }
    });
    Solved const solved = gradients_.solve(
        [&](std::span<double const> in, std::span<double> out) {
            for_each(n, [&](std::size_t i) {
                Vector<double, D> pull;
                for (std::size_t at = begin_[i]; at < begin_[i + 1]; ++at)
                    for (std::size_t k = 0; k < D; ++k)
                        pull[static_cast<int>(k)] += links_[at].c * in[D * links_[at].j + k];
                for (std::size_t k = 0; k < D; ++k)
                    out[D * i + k] = diagonal_[D * i + k] * in[D * i + k] - step * pull[static_cast<int>(k)];
            });
        },
        Jacobi{diagonal_}, b_, x_, limits_);
    for_each(n, [&](std::size_t i) {
        for (std::size_t k = 0; k < D; ++k) view.template at<Acceleration>(static_cast<int>(k))[i] = x_[D * i + k];
    });
    return solved;
}

template class ImplicitViscosity<2>;
template class ImplicitViscosity<3>;

}  // namespace coronet
