// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Small bodies of liquid for statements about a whole scheme: an ellipse (ellipsoid), jittered, off-centre and turned,
// with a smooth velocity that is neither linear nor free of divergence and a density that varies.

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/cases/totals.hpp"

namespace coronet {

struct LiquidOptions {
    std::string gradient = "fpm";
    double viscosity = 0.5;
    double step = 1e-4;
    std::string velocity_2d = "'sin(2*y) - x*y + 1', 'cos(3*x) + 0.5*x'";
    std::string velocity_3d = "'sin(2*y) - x*z + 1', 'cos(3*x) + 0.5*z', 'x*y - z'";
    std::string more = "";  ///< further TOML, before [[shapes]]
};

template <int D>
Case liquid_case(LiquidOptions const& o) {
    return read_case(fmt::format("name = 'liquid'\ndimension = {}\n"
                                 "[particles]\nspacing = {}\njitter = 0.2\nrotation = 17\n"
                                 "[initial]\nvelocity = [{}]\npressure = '2 + sin(5*x) + y'\n"
                                 "[fluid]\ndensity = 1\nviscosity = {}\nsound_speed = 20\n"
                                 "[method]\ngradient = '{}'\nkernel = 'wendland-c2'\nsupport = {}\n"
                                 "[time]\nend = 0.1\nstep = {}\n{}\n"
                                 "[[shapes]]\nkind = 'ellipse'\ncentre = [{}]\nsemi_axes = [{}]\nrotation = 30\n",
                                 D, D == 2 ? 0.08 : 0.16, D == 2 ? o.velocity_2d : o.velocity_3d, o.viscosity,
                                 o.gradient, D == 2 ? 3.2 : 2.4, o.step, o.more, D == 2 ? "2, -1" : "2, -1, 3",
                                 D == 2 ? "1.0, 0.6" : "1.0, 0.6, 0.8"),
                     "liquid");
}

template <int D>
std::unique_ptr<Scheme<D>> liquid(LiquidOptions const& options = {}) {
    auto scheme = make_scheme<D>(liquid_case<D>(options));
    scheme->begin_step(0);
    return scheme;
}

/// Sums over particles of a quantity and of its size, the latter to judge round-off by.
template <class Part>
std::pair<double, double> sum_and_size(std::size_t count, Part const& part) {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < count; ++i) {
        double const p = part(i);
        sum += p;
        size += std::fabs(p);
    }
    return {sum, size};
}

}  // namespace coronet
