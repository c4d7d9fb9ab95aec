// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What all probes look at in one sample: the time [s], the particles and what the scheme shows beside them, and what
// more than one of them needs, found when the first one asks and kept for the others.

#include <optional>
#include <type_traits>

#include "coronet/cases/drop_outline.hpp"
#include "coronet/cases/drop_surface.hpp"
#include "coronet/schemes/scheme.hpp"

namespace coronet {

template <int D>
class Snapshot {
public:
    /// Borrows the particles and the case.
    Snapshot(double at, Particles<D> const& of, Case const& c, std::vector<Reading> readings = {})
        : time(at), particles(of), case_(c), readings_(std::move(readings)) {}

    double const time;
    Particles<D> const& particles;

    /// Of a name; 0 where the scheme shows none.
    double reading(std::string_view name) const {
        for (Reading const& shown : readings_)
            if (shown.name == name) return shown.value;
        return 0;
    }

    /// In 3D its surface.
    auto const& outline() const {
        if constexpr (D == 2) {
            if (!outline_) outline_ = drop_outline(particles, case_);
        } else {
            if (!outline_) outline_ = drop_surface(particles, case_);
        }
        return *outline_;
    }

private:
    Case const& case_;
    std::vector<Reading> readings_;
    mutable std::optional<std::conditional_t<D == 2, DropOutline, DropSurface>> outline_;
};

}  // namespace coronet
