// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/viscous_step.hpp"

#include <algorithm>
#include <numbers>

#include "coronet/solvers/jacobi.hpp"

namespace coronet {

namespace {

constexpr double gamma_of_stage = 1 - std::numbers::sqrt2 / 2;

}  // namespace

template <int D>
Solved ViscousStep<D>::advance(Particles<D>& particles, Neighbours<D> const& neighbours, double step) {
    std::size_t const n = particles.size();
    auto const view = particles.view();
    auto const mean = [&]<class Field>(Field) {
        return (1 / static_cast<double>(n)) *
               sum_over(n, Vector<double, D>{}, [&](std::size_t i) { return view.template get<Field>(i); });
    };
    // What all particles have in common no stress sees; taken off first, it costs no digits.
    auto const v_common = mean(Velocity{}), f_common = mean(Acceleration{});
    for (auto* numbers : {&mass_, &diagonal_, &v_, &f_, &b_, &x_, &Kv_, &v_mean_}) numbers->resize(D * n);
    for_each(D * n, [&](std::size_t a) {
        std::size_t const i = a / D;
        int const k = static_cast<int>(a % D);
        mass_[a] = view.template at<Mass>()[i];
        v_[a] = view.template at<Velocity>(k)[i] - v_common[k];
        f_[a] = view.template at<Acceleration>(k)[i] - f_common[k];
    });
    operator_.set_up(particles, neighbours);
    operator_.set_viscosity(liquid_, v_);

    double const gamma = gamma_of_stage, stage = gamma * step;
    operator_.diagonal(diagonal_);
    for_each(D * n, [&](std::size_t a) {
        diagonal_[a] = mass_[a] + stage * diagonal_[a];
        x_[a] = v_[a] + stage * f_[a];
        b_[a] = mass_[a] * x_[a];
    });
    auto const solve = [&] {
        return gradients_.solve(
            [&](std::span<double const> in, std::span<double> out) {
                operator_.apply(in, out);
                for_each(D * n, [&](std::size_t a) { out[a] = mass_[a] * in[a] + stage * out[a]; });
            },
            Jacobi{diagonal_}, b_, x_, limits_);
    };
    Solved const first = solve();
    operator_.apply(x_, Kv_);
    for_each(D * n, [&](std::size_t a) {
        v_mean_[a] = (1 - gamma) * x_[a];
        b_[a] = mass_[a] * (v_[a] + step * f_[a]) - step * (1 - gamma) * Kv_[a];
    });
    Solved const second = solve();
    for_each(D * n, [&](std::size_t a) { v_mean_[a] += gamma * x_[a]; });
    operator_.apply(v_mean_, Kv_);
    for_each(n, [&](std::size_t i) {
        auto v = view.template get<Velocity>(i) + step * view.template get<Acceleration>(i);
        for (int k = 0; k < D; ++k) {
            std::size_t const a = D * i + static_cast<std::size_t>(k);
            v[k] -= step / mass_[a] * Kv_[a];
        }
        view.template set<Velocity>(i, v);
    });
    return {first.converged && second.converged, first.broke_down || second.broke_down,
            first.iterations + second.iterations, std::max(first.residual, second.residual)};
}

template class ViscousStep<2>;
template class ViscousStep<3>;

}  // namespace coronet
