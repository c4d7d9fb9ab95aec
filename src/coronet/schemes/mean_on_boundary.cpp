// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/mean_on_boundary.hpp"

namespace coronet {

template <int D>
void MeanOnBoundary<D>::set_up(Particles<D>& particles, Neighbours<D> const& neighbours) {
    inner_->set_up(particles, neighbours);
    particles_ = &particles;
    auto const view = particles.view();
    double const* const V = view.template at<Volume>();
    double const* const m = view.template at<Mass>();
    volume_ = boundary_->sums([&](std::size_t i) { return V[i]; });
    stiffness_ = boundary_->sums([&](std::size_t i) { return norm2(boundary_->of_content[i]) / m[i]; });
    of_mean_.clear();
}

/// Finds c, if it is not known.
template <int D>
void MeanOnBoundary<D>::look_at_mean() {
    if (!of_mean_.empty()) return;
    double const* const m = particles_->view().template at<Mass>();
    std::size_t const n = particles_->size();
    of_mean_.assign(boundary_->pieces, std::vector<double>(n));
    std::vector<Vector<double, D>> push(n);
    for (std::size_t k = 0; k < boundary_->pieces; ++k) {
        for_each(n, [&](std::size_t i) {
            push[i] = boundary_->piece_of(i) == k ? (1 / m[i]) * boundary_->of_content[i] : Vector<double, D>{};
        });
        inner_->divergence(push, of_mean_[k]);
    }
}

/// b <- P^T b + V sums/sum V.
template <int D>
void MeanOnBoundary<D>::replace_sums(std::vector<double> const& sums, std::span<double> b) const {
    double const* const V = particles_->view().template at<Volume>();
    auto const before = boundary_->sums([&](std::size_t i) { return b[i]; });
    for_each(b.size(), [&](std::size_t i) {
        std::size_t const k = boundary_->piece_of(i);
        b[i] += V[i] / volume_[k] * (sums[k] - before[k]);
    });
}

template <int D>
void MeanOnBoundary<D>::source(double step, std::span<double> b) {
    inner_->source(step, b);
    auto const view = particles_->view();
    replace_sums(boundary_->sums([&](std::size_t i) {
        return -dot(boundary_->of_content[i], view.template get<Velocity>(i)) / step;
    }),
                 b);
}

template <int D>
void MeanOnBoundary<D>::divergence(std::vector<Vector<double, D>> const& v, std::span<double> to) {
    inner_->divergence(v, to);
    replace_sums(boundary_->sums([&](std::size_t i) { return dot(boundary_->of_content[i], v[i]); }), to);
}

template <int D>
void MeanOnBoundary<D>::split(std::span<double const> p) {
    double const* const V = particles_->view().template at<Volume>();
    mean_ = boundary_->sums([&](std::size_t i) { return V[i] * p[i]; });
    for (std::size_t k = 0; k < mean_.size(); ++k) mean_[k] /= volume_[k];
    above_.resize(p.size());
    for_each(p.size(), [&](std::size_t i) { above_[i] = p[i] - mean_[boundary_->piece_of(i)]; });
}

template <int D>
void MeanOnBoundary<D>::apply(std::span<double const> p, std::span<double> Ap) {
    look_at_mean();
    split(p);
    inner_->apply(above_, Ap);
    std::vector<double> sums(mean_.size());
    for (std::size_t k = 0; k < mean_.size(); ++k) {
        auto const& c = of_mean_[k];
        sums[k] = stiffness_[k] * mean_[k] + sum_over(p.size(), 0.0, [&](std::size_t i) { return c[i] * above_[i]; });
        for_each(p.size(), [&](std::size_t i) { Ap[i] += c[i] * mean_[k]; });
    }
    replace_sums(sums, Ap);
}

template <int D>
void MeanOnBoundary<D>::accelerate(std::span<double const> p) {
    split(p);
    inner_->accelerate(above_);
    auto const view = particles_->view();
    for_each(p.size(), [&](std::size_t i) {
        view.template set<Acceleration>(i, view.template get<Acceleration>(i) + mean_[boundary_->piece_of(i)] /
                                                                                    view.template at<Mass>()[i] *
                                                                                    boundary_->of_content[i]);
    });
}

template class MeanOnBoundary<2>;
template class MeanOnBoundary<3>;

}  // namespace coronet
