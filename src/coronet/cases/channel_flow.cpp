// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/channel_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coronet {

namespace {

constexpr int cells = 4000, terms = 400, halvings = 200;

/// The root of a function that rises from below 0 at `low` to above 0 at `high`.
template <class Rising>
double root(double low, double high, Rising const& f) {
    for (int k = 0; k < halvings && low < high; ++k) {
        double const middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        (f(middle) < 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

ChannelFlow::ChannelFlow(Rheology const& law, double density, double force_per_mass, Plates const& plates)
    : law_(without_bounds(law)), density_(density), force_(force_per_mass), plates_(plates), u_(cells + 1) {
    double const slip = plates.upper - plates.lower;
    // With equal plates the flow is even in y, and no stress acts at the centre.
    double bound = density * std::fabs(force_per_mass) * plates.gap / 2;
    if (slip == 0) {
        profile(0);
        return;
    }
    for (double reach = std::max(bound, 1e-300);; reach *= 2)
        if (profile(reach) > std::fabs(slip) && profile(-reach) < -std::fabs(slip)) {
            bound = reach;
            break;
        }
    profile(root(-bound, bound, [&](double stress) { return profile(stress) - slip; }));
}

/// The shear rate of a stress, of its sign.
double ChannelFlow::rate(double stress) const {
    double const size = std::fabs(stress);
    if (law_.model == Rheology::Model::newtonian) return stress / law_.viscosity;
    bool const yields = law_.model == Rheology::Model::bingham || law_.model == Rheology::Model::herschel_bulkley ||
                        law_.model == Rheology::Model::casson;
    if (size == 0 || (yields && size <= law_.yield_stress)) return 0;
    // Over the logarithm: rates span decades.
    double const g = std::exp(root(-100, 100, [&](double ln_g) { return law_.stress_at(std::exp(ln_g)) - size; }));
    return std::copysign(g, stress);
}

/// Fills u for a stress at y = 0, by the midpoints of the cells, and returns the velocity of the upper plate to the
/// lower one.
double ChannelFlow::profile(double stress_at_centre) {
    double const dy = plates_.gap / cells;
    u_[0] = plates_.lower;
    for (int k = 0; k < cells; ++k)
        u_[k + 1] = u_[k] + dy * rate(stress_at_centre - density_ * force_ * ((k + 0.5) * dy - plates_.gap / 2));
    return u_[cells] - u_[0];
}

double ChannelFlow::steady(double y) const {
    double const at = std::clamp((y / plates_.gap + 0.5) * cells, 0.0, static_cast<double>(cells));
    int const k = std::min(static_cast<int>(at), cells - 1);
    return u_[k] + (at - k) * (u_[k + 1] - u_[k]);
}

double ChannelFlow::from_rest(double y, double t) const {
    double const pi = std::numbers::pi, L = plates_.gap, s = y + L / 2, nu = law_.viscosity / density_;
    double u = steady(y);
    for (int n = terms; n >= 1; --n) {
        // b_n of the three parts of u_steady: a constant, a slope, and the bulge f/(2 nu) s (L - s).
        double const k = n * pi, odd = n % 2 == 1 ? 1 : 0, sign = n % 2 == 1 ? 1 : -1;
        double const b = 4 * odd * plates_.lower / k + 2 * sign * (plates_.upper - plates_.lower) / k +
                         4 * odd * force_ * L * L / (nu * k * k * k);
        u -= b * std::sin(k * s / L) * std::exp(-k * k * nu * t / (L * L));
    }
    return u;
}

}  // namespace coronet
