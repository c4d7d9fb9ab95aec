// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/neighbours/images.hpp"

namespace coronet {

/// A step that has begun goes on from where it would have begun in the box.
template <int D>
void Images<D>::wrap(Particles<D>& particles) const {
    auto const view = particles.view();
    for_each(particles.end(Role::mirror), [&](std::size_t i) {
        auto const x = view.template get<Position>(i);
        auto const shift = box_.shift_into(x);
        view.template set<Position>(i, x + shift);
        if (particles.template has<PositionBefore>())
            view.template set<PositionBefore>(i, view.template get<PositionBefore>(i) + shift);
    });
}

template <int D>
void Images<D>::remake(Particles<D>& particles, double reach) {
    if (!box_.any()) return;
    wrap(particles);
    source_.clear();
    shift_.clear();
    auto const add_near = [&](Role role) {
        auto const view = particles.view();
        for (std::size_t i = particles.begin(role); i < particles.end(role); ++i) {
            auto const x = view.template get<Position>(i);
            // Every combination of one length up, none, and one down along the axes.
            int combinations = 1;
            for (int k = 0; k < D; ++k) combinations *= 3;
            for (int c = 1; c < combinations; ++c) {
                Vector<double, D> shift;
                bool near = true;
                for (int k = 0, digits = c; k < D; ++k, digits /= 3) {
                    int const step = digits % 3 == 2 ? -1 : digits % 3;
                    if (step == 0) continue;
                    shift[k] = step * box_.size[k];
                    double const from_low = x[k] - box_.low[k];
                    near = near && box_.periodic[k] && (step > 0 ? from_low < reach : box_.size[k] - from_low < reach);
                }
                if (!near) continue;
                source_.push_back(i);
                shift_.push_back(shift);
            }
        }
        return source_.size();
    };
    std::size_t const of_liquid = add_near(Role::liquid), all = add_near(Role::wall);
    particles.set_images(of_liquid, all - of_liquid);
    std::size_t const first = particles.begin(Role::liquid_image);
    for (std::size_t k = 0; k < all; ++k) particles.id[first + k] = particles.id[source_[k]];
    refresh(particles, Fields<Position>{});
    if (particles.template has<Mass>()) refresh(particles, Fields<Mass>{});
}

template <int D>
void Images<D>::follow(Particles<D> const& particles, std::span<Index const> from) {
    if (source_.empty()) return;
    std::size_t const first = particles.begin(Role::liquid_image);
    std::vector<std::size_t> now(first);
    for_each(first, [&](std::size_t i) { now[static_cast<std::size_t>(from[i])] = i; });
    auto const source = source_;
    auto const shift = shift_;
    for_each(source.size(), [&](std::size_t k) {
        auto const before = static_cast<std::size_t>(from[first + k]) - first;
        source_[k] = now[source[before]];
        shift_[k] = shift[before];
    });
}

template class Images<1>;
template class Images<2>;
template class Images<3>;

}  // namespace coronet
