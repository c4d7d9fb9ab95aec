// SPDX-License-Identifier: BSD-3-Clause

// Mixed precision rounds what a pair reads and its sums to float, and nothing else: rates differ from those in double
// by a few roundings of the largest pair, wherever the liquid is and however fast it moves as a whole.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

/// Largest difference of acceleration and of density rate from those in double, over the largest of each.
template <int D>
double difference(LiquidOptions const& options) {
    auto const full = liquid<D>(options);
    Case c = liquid_case<D>(options);
    c.method.precision = "mixed";
    auto const mixed = make_scheme<D>(c);
    mixed->begin_step(0);
    auto const a = full->particles().view(), b = mixed->particles().view();
    double apart = 0, size = 0, rate_apart = 0, rate_size = 0;
    for (std::size_t i = 0; i < full->particles().owned(); ++i) {
        apart = std::max(apart, norm2(a.template get<Acceleration>(i) - b.template get<Acceleration>(i)));
        size = std::max(size, norm2(a.template get<Acceleration>(i)));
        rate_apart = std::max(rate_apart, std::fabs(a.template get<DensityRate>(i) - b.template get<DensityRate>(i)));
        rate_size = std::max(rate_size, std::fabs(a.template get<DensityRate>(i)));
    }
    return std::max(std::sqrt(apart / size), rate_apart / rate_size);
}

}  // namespace

TEST(MixedPrecision, DiffersFromDoubleByRoundingsOfFloat) {
    for (std::string const gradient : {"sph", "cph", "fpm"}) {
        double const two = difference<2>({.gradient = gradient}), three = difference<3>({.gradient = gradient});
        EXPECT_LT(two, 200 * std::numeric_limits<float>::epsilon()) << gradient;
        EXPECT_LT(three, 200 * std::numeric_limits<float>::epsilon()) << gradient;
        EXPECT_GT(two, 0) << "mixed precision did nothing";
        EXPECT_GT(three, 0) << "mixed precision did nothing";
    }
}

TEST(MixedPrecision, DoesNotSufferFromACommonVelocity) {
    double const moving = difference<2>({.velocity_2d = "'sin(2*y) - x*y + 10001', 'cos(3*x) + 0.5*x - 5000'"});
    EXPECT_LT(moving, 200 * std::numeric_limits<float>::epsilon());
}

}  // namespace coronet
