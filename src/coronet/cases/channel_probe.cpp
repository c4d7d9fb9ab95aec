// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/channel_probe.hpp"

#include <cmath>

#include "coronet/cases/fluid.hpp"
#include "coronet/cases/formula.hpp"
#include "coronet/cases/point_value.hpp"

namespace coronet {

namespace {

double constant(std::string const& text, Case const& c) { return Formula(text, c.parameters)(Vector<double, 2>{}, 0); }

}  // namespace

template <int D>
ChannelProbe<D>::ChannelProbe(ProbeKeys const& keys, Case const& c)
    : exact_(rheology_of(c), c.fluid.density, c.fluid.gravity[0] + constant(c.fluid.body_force[0], c),
             {constant(keys.gap, c), constant(keys.lower_velocity, c), constant(keys.upper_velocity, c)}),
      from_rest_(keys.flow == "from-rest"),
      kernel_(probe_kernel<D>(c)) {
    if (!c.domain.centre.empty())
        for (int k = 0; k < D; ++k) centre_[k] = c.domain.centre[k];
    double const gap = constant(keys.gap, c);
    auto const count = static_cast<std::size_t>(std::max(std::lround(gap / c.particles.spacing), 1L));
    for (std::size_t k = 0; k < count; ++k)
        profile_.position.push_back(gap * ((static_cast<double>(k) + 0.5) / static_cast<double>(count) - 0.5));
}

template <int D>
std::vector<double> ChannelProbe<D>::sample(Snapshot<D> const& now) {
    auto const v = now.particles.template get<Velocity>(0);
    profile_.computed.clear();
    profile_.reference.clear();
    for (double const y : profile_.position) {
        auto at = centre_;
        at[1] = y;
        profile_.computed.push_back(linear_value_at(now.particles, kernel_, at, [&](std::size_t i) { return v[i]; }));
        profile_.reference.push_back(from_rest_ ? exact_.from_rest(y, now.time) : exact_.steady(y));
    }
    return {relative_error(profile_)};
}

template <int D>
std::vector<Measure> ChannelProbe<D>::measures() const {
    double const error = relative_error(profile_);
    return {{"velocity_error_rms", error, 0.0, error,
             from_rest_ ? "series, Morris, Fox and Zhu (1997) Eqs 34 and 36; over the root mean square of the profile"
                        : "quadrature of the exact stress; over the root mean square of the profile"}};
}

template class ChannelProbe<2>;
template class ChannelProbe<3>;

}  // namespace coronet
