// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/check.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coronet/cases/fill.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/core/error.hpp"

namespace coronet {

namespace {

constexpr double most_particles = 5e8;

template <int D>
void check(Case const& c, std::vector<std::string>& errors) {
    double const expected = expected_particles<D>(c);
    if (!(expected < most_particles)) {
        errors.push_back(fmt::format("particles.spacing = {} m would make about {:.1e} particles; at most {:.0e} are allowed: "
                                     "use a spacing above {:.2g} m",
                                     c.particles.spacing, expected, most_particles,
                                     c.particles.spacing * std::pow(expected / most_particles, 1.0 / D)));
        return;
    }
    for (std::size_t k = 0; k < c.shapes.size(); ++k)
        for (Cut const& cut : c.shapes[k].cuts) {
            double length = 0;
            for (double const n : cut.normal) length += n * n;
            if (length == 0) errors.push_back(fmt::format("shapes.{}.cuts has a normal of length zero: it cuts nowhere", k));
        }
    if (!errors.empty()) return;

    auto const seeds = fill<D>(c);
    if (seeds.size() == 0) {
        errors.push_back(fmt::format("the shapes hold no particle at particles.spacing = {} m: use a smaller spacing",
                                     c.particles.spacing));
        return;
    }
    auto const state = initial_state(c, seeds);
    double const fastest = std::sqrt(state.fastest2);
    if (!std::isfinite(fastest))
        errors.push_back(fmt::format("initial.velocity = [{}] is not finite at every particle",
                                     fmt::join(c.initial.velocity, ", ")));
    else if (fastest >= c.fluid.sound_speed)
        errors.push_back(fmt::format("fluid.sound_speed = {} m/s, but initial.velocity reaches {:.4g} m/s: the flow must stay "
                                     "below the sound speed, at best a tenth of it; use {:.4g} m/s",
                                     c.fluid.sound_speed, fastest, 10 * fastest));
    if (!state.density_is_possible)
        errors.push_back(fmt::format("initial.pressure = {} leaves no positive finite density at every particle with "
                                     "fluid.sound_speed = {} m/s: use a larger sound speed",
                                     c.initial.pressure, c.fluid.sound_speed));
    double const h = c.method.support * c.particles.spacing / 3;
    if (c.time.step > h / c.fluid.sound_speed)
        errors.push_back(fmt::format("time.step = {} s is beyond the largest stable step, h/c = {:.3g} s (h, a third of the "
                                     "kernel's radius, is {:.3g} m): use 'auto' or at most {:.3g} s",
                                     c.time.step, h / c.fluid.sound_speed, h, 0.25 * h / c.fluid.sound_speed));
    if (c.output.every > c.time.end || c.output.series_every > c.time.end)
        errors.push_back(fmt::format("output.every = {} s and output.series_every = {} s must not exceed time.end = {} s",
                                     c.output.every, c.output.series_every, c.time.end));
}

}  // namespace

void check_physics(Case const& c, std::string const& file) {
    std::vector<std::string> errors;
    if (c.dimension == 2) check<2>(c, errors);
    else check<3>(c, errors);
    if (errors.empty()) return;
    for (std::string& error : errors) error = file + ": " + error;
    throw CaseError(fmt::format("{}", fmt::join(errors, "\n")));
}

}  // namespace coronet
