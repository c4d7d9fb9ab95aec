// SPDX-License-Identifier: BSD-3-Clause

// How long a step of the weakly compressible scheme may be.

#include <algorithm>
#include <cmath>
#include <limits>

#include "coronet/schemes/weakly_compressible.hpp"

namespace coronet {

template <int D>
StepLimit WeaklyCompressible<D>::time_limit() const {
    auto const view = particles_.view();
    std::size_t const n = particles_.owned();
    double const h = settings_.kernel.support / 3;
    struct Largest {
        double c, a2;
    };
    bool const newtonian = settings_.liquid.is_newtonian();
    double const mu = newtonian ? settings_.liquid.rheology.viscosity
                                : max_over(n, 0, [&](std::size_t i) { return view.template at<Viscosity>()[i]; });
    auto const [c, a2] = fold(
        n, Largest{0, 0},
        [&](std::size_t i) {
            return Largest{view.template at<SoundSpeed>()[i], norm2(view.template get<Acceleration>(i))};
        },
        [](Largest const& a, Largest const& b) {
            return Largest{std::max(a.c, b.c), std::max(a.a2, b.a2)};
        });
    double const nu = mu / settings_.equation_of_state.rho0;
    constexpr double never = std::numeric_limits<double>::infinity();

    // Fang et al. (2009) Eqs 90, 91, 92 with safe factors: c is the speed of sound, a the largest force per mass.
    StepLimit limit{settings_.courant * h / c, "sound"};
    auto const vote = [&](double step, std::string_view reason) {
        if (step < limit.step) limit = {step, reason};
    };
    vote(a2 > 0 ? 0.25 * std::sqrt(h / std::sqrt(a2)) : never, "force");
    vote(step_limit(settings_.pair_terms, h, c), "pair terms");
    if (!implicit_viscosity_) vote(nu > 0 ? 0.125 * h * h / nu : never, "viscosity");
    vote(capillary_step(settings_.surface, settings_.equation_of_state.rho0), "capillary waves");
    return limit;
}

template StepLimit WeaklyCompressible<2>::time_limit() const;
template StepLimit WeaklyCompressible<3>::time_limit() const;

}  // namespace coronet
