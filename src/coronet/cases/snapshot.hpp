// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What all probes look at in one sample: the time [s] and the particles, and what more than one of them needs, found
// when the first one asks and kept for the others.

#include <optional>

#include "coronet/cases/drop_outline.hpp"

namespace coronet {

template <int D>
class Snapshot {
public:
    /// Borrows the particles and the case.
    Snapshot(double at, Particles<D> const& of, Case const& c) : time(at), particles(of), case_(c) {}

    double const time;
    Particles<D> const& particles;

    DropOutline const& outline() const requires(D == 2) {
        if (!outline_) outline_ = drop_outline(particles, case_);
        return *outline_;
    }

private:
    Case const& case_;
    mutable std::optional<DropOutline> outline_;
};

}  // namespace coronet
