// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/kept_gradients.hpp"

#include "coronet/terms/gradient_correction.hpp"

namespace coronet {

/// The rows of neighbours inside the support, with the kernel between them.
template <int D>
void KeptGradients<D>::list(Particles<D> const& particles, Neighbours<D> const& neighbours, Kernel const& kernel) {
    std::size_t const n = particles.size();
    auto const view = particles.view();
    double const H2 = kernel.support * kernel.support;
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
            auto const [W, F] = kernel(r2);
            links_[next++] = {F * x, W, F, j};
        });
    });
}

template <int D>
void KeptGradients<D>::set_up(Particles<D> const& particles, Neighbours<D> const& neighbours, Kernel const& kernel,
                              GradientKind kind) {
    list(particles, neighbours, kernel);
    std::size_t const n = particles.size();
    auto const view = particles.view();
    volume_.assign(view.template at<Volume>(), view.template at<Volume>() + n);
    correction_.resize(n);
    double const W_at_zero = kernel.at_zero();
    singular_matrices_ = static_cast<std::size_t>(sum_over(n, 0.0, [&](std::size_t i) {
        double W0 = 0;
        Vector<double, D> W1, G0;
        Symmetric<double, D> G1;
        auto const x_i = view.template get<Position>(i);
        for (Link const& link : row(i)) {
            auto const j = static_cast<std::size_t>(link.j);
            double const V = volume_[j];
            auto const x = view.template get<Position>(j) - x_i;
            W0 += V * link.W;
            W1 += (V * link.W) * x;
            G0 += V * link.gradW;
            G1 += outer_of_parallels(V * link.gradW, x);
        }
        if (kind == GradientKind::plain) {
            correction_[i] = {identity<double, D>(), {}, G0};
            return 0.0;
        }
        GradientCorrection<double, D> const c(W0 + volume_[i] * W_at_zero, W1, G0, G1);
        correction_[i] = {c.L, c.q, c.L * G0 - W0 * c.q};
        return c.fell_back;
    }));
}

template class KeptGradients<2>;
template class KeptGradients<3>;

}  // namespace coronet
