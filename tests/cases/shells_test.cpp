// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/shells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "coronet/cases/read.hpp"
#include "coronet/cases/shapes.hpp"
#include "coronet/cases/solid_harmonic.hpp"

namespace coronet {

namespace {

using std::numbers::pi;

Case round_case(int dimension, std::string const& kind, std::vector<std::string> more = {}) {
    more.push_back("dimension=" + std::to_string(dimension));
    more.push_back("particles.lattice=shells");
    return read_case("name = \"drop\"\nshapes = [{kind = \"" + kind +
                         "\", radius = 2}]\nparticles.spacing = 0.2\nfluid.density = 1\nfluid.sound_speed = "
                         "10\ntime.end = 1\n",
                     "drop", more);
}

template <int D>
double nearest(std::vector<Vector<double, D>> const& points) {
    double least = INFINITY;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, norm2(points[i] - points[j]));
    return std::sqrt(least);
}

}  // namespace

TEST(SolidHarmonic, HasTheGradientOfItsValue) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int const n : {2, 3, 4, 7}) {
        Vector<double, 3> const x{{uniform(engine), uniform(engine), uniform(engine)}};
        double const r = std::sqrt(norm2(x));
        auto const here = solid_harmonic(n, x);
        EXPECT_NEAR(here.value, std::pow(r, n) * std::legendre(static_cast<unsigned>(n), x[0] / r), 1e-14);
        for (int k = 0; k < 3; ++k) {
            auto ahead = x, behind = x;
            ahead[k] += 1e-5;
            behind[k] -= 1e-5;
            EXPECT_NEAR((solid_harmonic(n, ahead).value - solid_harmonic(n, behind).value) / 2e-5, here.gradient[k],
                        1e-8);
        }
        Vector<double, 2> const y{{x[0], x[1]}};
        EXPECT_NEAR(solid_harmonic(n, y).value, std::pow(norm2(y), n / 2.0) * std::cos(n * std::atan2(y[1], y[0])),
                    1e-14);
        EXPECT_NEAR(dot(solid_harmonic(n, y).gradient, y), n * solid_harmonic(n, y).value, 1e-14);  // Euler
    }
}

TEST(Shells, AreAsManyParticlesAsThereIsVolumeAndKeepApart) {
    auto const ball = fill<3>(round_case(3, "ball"));
    EXPECT_EQ(ball.size(), static_cast<std::size_t>(std::lround(4 * pi / 3 * 1000)));
    EXPECT_NEAR(ball.volume * static_cast<double>(ball.size()), 4 * pi / 3 * 8, 1e-12);
    EXPECT_GT(nearest(ball.position), 0.8 * 0.2);
    auto const disc = fill<2>(round_case(2, "disc"));
    EXPECT_EQ(disc.size(), static_cast<std::size_t>(std::lround(pi * 100)));
    EXPECT_GT(nearest(disc.position), 0.8 * 0.2);
}

TEST(Shells, OfADropFillItsWave) {
    for (int const n : {2, 3, 4}) {
        auto const c = round_case(3, "drop", {"drop.amplitude=0.02", "drop.mode=" + std::to_string(n)});
        double outermost = 0;  // over the wave's radius; the outer shell is half a spacing inside
        for (auto const& x : fill<3>(c).position)
            outermost = std::max(outermost, std::sqrt(norm2(x)) / drop_radius(c.shapes[0], x));
        EXPECT_NEAR(outermost, 1 - 0.05, 0.01) << n;
    }
}

TEST(DropRadius, IsThatOfADropWithTheVolumeOfItsBall) {
    for (int const n : {2, 3, 4, 5})
        for (double const a : {-0.3, 0.4}) {
            Shape shape;
            shape.kind = "drop";
            shape.mode = n;
            shape.amplitude = a;
            double volume = 0;  // 2 pi/3 times the integral of r^3 over the cosine
            int const steps = 20000;
            for (int k = 0; k < steps; ++k) {
                double const c = -1 + 2 * (k + 0.5) / steps;
                volume += 2 * pi / 3 *
                          std::pow(drop_radius(shape, Vector<double, 3>{{c, std::sqrt(1 - c * c), 0}}), 3) * 2 / steps;
            }
            EXPECT_NEAR(volume, 4 * pi / 3, 1e-7) << n;
        }
}

}  // namespace coronet
