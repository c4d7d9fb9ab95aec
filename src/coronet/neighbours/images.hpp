// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Periodic boundaries: what leaves the box on one side comes back on the other. Particles near a periodic face have
// images, copies one length of the box further on, so that who reads neighbours need not know of any box. Images are
// made anew when neighbours are listed; between that, what a sweep will read of them is copied by refresh(), field by
// field, so that they move with their originals.

#include <cmath>
#include <span>
#include <type_traits>
#include <vector>

#include "coronet/fields/particles.hpp"

namespace coronet {

/// Where the periodic boundaries are; lengths in m.
template <int D>
struct PeriodicBox {
    Vector<double, D> low, size;
    bool periodic[D] = {};

    bool any() const {
        bool some = false;
        for (bool const p : periodic) some = some || p;
        return some;
    }
    /// What to add to x to bring it into the box.
    Vector<double, D> shift_into(Vector<double, D> const& x) const {
        Vector<double, D> shift;
        for (int k = 0; k < D; ++k)
            if (periodic[k]) shift[k] = -size[k] * std::floor((x[k] - low[k]) / size[k]);
        return shift;
    }
    /// What to add to the way from one point to another to come to the nearest copy of that.
    Vector<double, D> shift_to_nearest(Vector<double, D> const& way) const {
        Vector<double, D> shift;
        for (int k = 0; k < D; ++k)
            if (periodic[k]) shift[k] = -size[k] * std::round(way[k] / size[k]);
        return shift;
    }
};

template <int D>
class Images {
public:
    explicit Images(PeriodicBox<D> const& box) : box_(box) {}

    /// Moves all particles into the box and makes the images of those within `reach` [m] of its periodic faces; of them
    /// only Position and Mass are set.
    void remake(Particles<D>& particles, double reach);
    /// Particles now stand where from[i] stood.
    void follow(Particles<D> const& particles, std::span<Index const> from);

    /// Copies fields of the originals to their images, Position beyond the box.
    template <class... F>
    void refresh(Particles<D>& particles, Fields<F...> = {}) const {
        if (source_.empty()) return;
        auto const view = particles.view();
        std::size_t const first = particles.begin(Role::liquid_image);
        for_each(source_.size(), [&](std::size_t k) {
            [[maybe_unused]] auto const copy = [&]<class G>(G) {
                auto value = view.template get<G>(source_[k]);
                if constexpr (std::is_same_v<G, Position>) value += shift_[k];
                view.template set<G>(first + k, value);
            };
            (copy(F{}), ...);
        });
    }
    PeriodicBox<D> const& box() const { return box_; }
    /// Whose image particle i is; i itself where it is none.
    std::size_t original(Particles<D> const& particles, std::size_t i) const {
        std::size_t const first = particles.begin(Role::liquid_image);
        return i < first ? i : source_[i - first];
    }

private:
    void wrap(Particles<D>& particles) const;

    PeriodicBox<D> box_;
    std::vector<std::size_t> source_;       // of each image
    std::vector<Vector<double, D>> shift_;  // from its original [m]
};

}  // namespace coronet
