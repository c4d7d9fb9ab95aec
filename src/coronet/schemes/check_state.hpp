// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A run that has blown up is stopped at the first step that shows it, whatever the scheme: every particle needs a
// finite density above 0 [kg/m^3], a finite velocity [m/s] and acceleration [m/s^2].

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coronet/core/error.hpp"
#include "coronet/core/parallel.hpp"
#include "coronet/fields/particles.hpp"

namespace coronet {

/// Throws RunError about the first particle that has no possible state.
template <int D>
void check_state(Particles<D> const& particles) {
    auto const view = particles.view();
    double const none = static_cast<double>(particles.owned());
    double const first = min_over(particles.owned(), none, [&](std::size_t i) {
        double const rho = view.template get<Density>(i);
        double const others = norm2(view.template get<Velocity>(i)) + norm2(view.template get<Acceleration>(i));
        return rho > 0 && std::isfinite(rho) && std::isfinite(others) ? none : static_cast<double>(i);
    });
    if (first == none) return;
    auto const i = static_cast<std::size_t>(first);
    auto const x = view.template get<Position>(i);
    throw RunError(fmt::format(
        "the flow has blown up: particle {} at ({:.4g}) m has density {:.4g} kg/m^3, speed {:.4g} m/s and "
        "acceleration {:.4g} m/s^2",
        particles.id[i], fmt::join(x.c, x.c + D, ", "), view.template get<Density>(i),
        std::sqrt(norm2(view.template get<Velocity>(i))), std::sqrt(norm2(view.template get<Acceleration>(i)))));
}

}  // namespace coronet
