// SPDX-License-Identifier: BSD-3-Clause

// Viscosity along pairs in whole schemes: what acts there does not act as stress, whatever the rheology.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"

namespace coronet {

namespace {

constexpr char newtonian[] = "viscosity = 0.4";
/// A law of Cross that is 0.4 Pa s at every shear rate, and one that thins by a factor of 20.
constexpr char level[] =
    "rheology = 'cross'\nzero_shear_viscosity = 0.4\ninfinite_shear_viscosity = 0.4\ntime_constant = "
    "0.5\ncross_exponent = 1";
constexpr char thinning[] =
    "rheology = 'cross'\nzero_shear_viscosity = 0.4\ninfinite_shear_viscosity = 0.02\ntime_constant = "
    "0.5\ncross_exponent = 1";

Case flow(std::string const& scheme, std::string const& liquid, double share) {
    return read_case(
        fmt::format(
            "name = 'flow'\ndimension = 2\n[[shapes]]\nkind = 'disc'\n[particles]\nspacing = 0.1\njitter = 0.2\n"
            "[initial]\nvelocity = ['sin(2*y) - x*y', 'cos(3*x) + 0.5*x']\n[fluid]\ndensity = 1\n{}\n{}"
            "[method]\nscheme = '{}'\nkernel = 'wendland-c2'\nsupport = 3.2\ncentral_share = {}\n"
            "[time]\nend = 1\n",
            liquid, scheme == "projection" ? "" : "sound_speed = 20\n", scheme, share),
        "flow");
}

std::unique_ptr<Scheme<2>> after(int steps, double step, Case const& c) {
    auto scheme = make_scheme<2>(c);
    for (int k = 0; k < steps; ++k) {
        scheme->begin_step(k * step);
        scheme->advance(k * step, step);
    }
    return scheme;
}

double kinetic_energy(Scheme<2> const& scheme) {
    auto const view = scheme.particles().view();
    return sum_over(scheme.particles().owned(), 0.0, [&](std::size_t i) {
        return 0.5 * view.template at<Mass>()[i] * norm2(view.template get<Velocity>(i));
    });
}

}  // namespace

class CentralViscosityIn : public testing::TestWithParam<char const*> {};

TEST_P(CentralViscosityIn, IsTheSameForALawThatIsLevelAndForANewtonianLiquid) {
    for (double const share : {0.3, 1.0}) {
        auto const one = after(5, 1e-4, flow(GetParam(), newtonian, share));
        auto const other = after(5, 1e-4, flow(GetParam(), level, share));
        auto const a = one->particles().view(), b = other->particles().view();
        for (std::size_t i = 0; i < one->particles().owned(); ++i) {
            auto const difference = a.template get<Velocity>(i) - b.template get<Velocity>(i);
            EXPECT_LE(norm2(difference), 1e-24);
        }
    }
}

TEST_P(CentralViscosityIn, TakesAboutTheEnergyThatStressDoes) {
    // Far from the surface both are the same viscosity; there, and on disordered particles, they differ.
    for (char const* liquid : {newtonian, thinning}) {
        double const step = 1e-4;
        auto const lost = [&](double share) {
            Case const c = flow(GetParam(), liquid, share);
            return kinetic_energy(*after(0, step, c)) - kinetic_energy(*after(20, step, c));
        };
        double const as_stress = lost(0);
        EXPECT_GT(as_stress, 0);
        EXPECT_NEAR(lost(0.5) / as_stress, 1, 0.1) << liquid;
        EXPECT_NEAR(lost(1) / as_stress, 1, 0.2) << liquid;
    }
}

TEST_P(CentralViscosityIn, LeavesTheStressThatFramesShowWhole) {
    auto const one = after(1, 1e-7, flow(GetParam(), thinning, 0));
    auto const other = after(1, 1e-7, flow(GetParam(), thinning, 1));
    auto const a = one->particles().view(), b = other->particles().view();
    double largest = 0;
    for (std::size_t i = 0; i < one->particles().owned(); ++i)
        largest = std::max(largest, std::abs(a.template get<Stress>(i)(0, 1)));
    for (std::size_t i = 0; i < one->particles().owned(); ++i)
        EXPECT_NEAR(a.template get<Stress>(i)(0, 1), b.template get<Stress>(i)(0, 1), 1e-4 * largest);
    EXPECT_GT(largest, 0.1);
}

TEST_P(CentralViscosityIn, LeavesThePressureInThatStressUnderTension) {
    auto scheme = after(2, 1e-4, flow(GetParam(), "viscosity = 0.4\nsurface_tension = 1", 1));
    if (GetParam() == std::string("weakly-compressible")) scheme->begin_step(2e-4);
    auto const view = scheme->particles().view();
    double largest = 0;
    for (std::size_t i = 0; i < scheme->particles().owned(); ++i) {
        double const p = view.template at<Pressure>()[i];
        auto const sigma = view.template get<Stress>(i);
        EXPECT_NEAR(sigma(0, 0) + sigma(1, 1), -2 * p, 1e-12 * (1 + std::abs(p)));
        largest = std::max(largest, std::abs(p));
    }
    EXPECT_GT(largest, 0.01);
}

INSTANTIATE_TEST_SUITE_P(BothSchemes, CentralViscosityIn, testing::Values("weakly-compressible", "projection"),
                         [](auto const& parameter) {
                             return std::string(parameter.param) == "projection" ? "projection" : "sound";
                         });

}  // namespace coronet
