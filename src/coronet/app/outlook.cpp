// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/app/outlook.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>

#include "coronet/cases/fill.hpp"
#include "coronet/cases/fluid.hpp"
#include "coronet/cases/wall_fill.hpp"

namespace coronet {

namespace {

template <int D>
std::string outlook_in(Case const& c) {
    auto const liquid = fill<D>(c);
    Vector<double, D> low, high;
    for (int k = 0; k < D; ++k) low[k] = INFINITY, high[k] = -INFINITY;
    for (auto const& x : liquid.position)
        for (int k = 0; k < D; ++k) low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
    auto const rounded = [](Vector<double, D> const& x) {
        std::vector<std::string> numbers;
        for (int k = 0; k < D; ++k) numbers.push_back(fmt::format("{:.4g}", x[k]));
        return fmt::format("({})", fmt::join(numbers, ", "));
    };
    double const volume = static_cast<double>(liquid.size()) * liquid.volume;
    std::string text = fmt::format("{} is a valid case: {}D, {} particles, {} s of simulated time\n", c.name, D,
                                   liquid.size(), c.time.end);
    text +=
        fmt::format("  liquid: {:.4g} {}, {:.4g} {}, its particles from {} to {} m\n", volume, D == 2 ? "m^2" : "m^3",
                    volume * c.fluid.density, D == 2 ? "kg/m" : "kg", rounded(low), rounded(high));
    if (!c.walls.empty()) text += fmt::format("  walls: {} particles\n", fill_walls<D>(c).size());

    auto const sticks = [](Wall const& wall) { return wall.slip != "free"; };
    if (std::ranges::any_of(c.walls, sticks) && rheology_of(c).largest_viscosity() == 0)
        text += "  note: fluid.viscosity is 0, so nothing sticks to the walls, which have slip = 'none'\n";
    double g2 = 0, fall = 0;
    auto const box = periodic_box<D>(c);
    for (int k = 0; k < D; ++k) {
        if (box.periodic[k]) continue;  // no height
        g2 += c.fluid.gravity[static_cast<std::size_t>(k)] * c.fluid.gravity[static_cast<std::size_t>(k)];
        fall += std::fabs(c.fluid.gravity[static_cast<std::size_t>(k)]) * (high[k] - low[k] + c.particles.spacing);
    }
    double const speed = std::sqrt(2 * fall);
    if (c.method.scheme == "weakly-compressible" && g2 > 0 && !c.walls.empty() && c.fluid.sound_speed < 9.5 * speed)
        text += fmt::format(
            "  note: fluid.sound_speed = {:g} m/s is less than ten times the {:.3g} m/s of a fall through the height "
            "of the liquid\n",
            c.fluid.sound_speed, speed);
    return text;
}

}  // namespace

std::string outlook(Case const& c) { return c.dimension == 2 ? outlook_in<2>(c) : outlook_in<3>(c); }

}  // namespace coronet
