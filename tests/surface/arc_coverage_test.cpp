// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/arc_coverage.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace coronet;

constexpr double pi = std::numbers::pi;

struct Disc {
    Vector<double, 2> x;
    double R;
};
using Discs = std::vector<Disc>;

Vector<double, 2> at(double angle) { return {{std::cos(angle), std::sin(angle)}}; }

/// How far a point of the unit circle is inside a disc; negative: outside.
double depth(Disc const& disc, double angle) { return disc.R - std::sqrt(norm2(at(angle) - disc.x)); }

bool same_as_ours(Disc const& disc) { return norm2(disc.x) < 1e-14 && std::fabs(disc.R - 1) < 1e-7; }

double depth(Discs const& discs, double angle) {
    double deepest = -1e9;
    for (Disc const& disc : discs)
        if (!same_as_ours(disc)) deepest = std::max(deepest, depth(disc, angle));
    return deepest;
}

ArcCoverage coverage_by(Discs const& discs) {
    ArcCoverage coverage;
    for (std::size_t j = 0; j < discs.size(); ++j) coverage.add({discs[j].x, 1, discs[j].R}, static_cast<Index>(j));
    return coverage;
}

std::vector<Gap> gaps_left_by(Discs const& discs) {
    std::vector<Gap> gaps;
    coverage_by(discs).for_gaps([&](Gap const& gap) { gaps.push_back(gap); });
    return gaps;
}

/// Angles all around, and close to where circles cross, on both sides: (Lobo 3.22-3.30) with the law of cosines.
std::vector<double> samples(Discs const& discs) {
    std::vector<double> angles;
    for (int k = 0; k < 500; ++k) angles.push_back(2 * pi * k / 500);
    for (Disc const& disc : discs) {
        double const d = std::sqrt(norm2(disc.x)), cosine = (1 + d * d - disc.R * disc.R) / (2 * d);
        if (!(std::fabs(cosine) < 1)) continue;
        for (double const side : {-1, 1})
            for (double const nudge : {-1e-5, 1e-5})
                angles.push_back(std::atan2(disc.x[1], disc.x[0]) + side * std::acos(cosine) + nudge);
    }
    return angles;
}

/// Every sample outside all discs lies in a gap, no sample inside one does; gaps have the neighbours at their ends that
/// they say.
void expect_right(Discs const& discs) {
    auto const gaps = gaps_left_by(discs);
    EXPECT_EQ(coverage_by(discs).covered(), gaps.empty());
    for (double const angle : samples(discs)) {
        bool in_gap = false;
        for (Gap const& gap : gaps) {
            double const beyond = std::remainder(angle - gap.begin, 2 * pi);
            in_gap |= (beyond < 0 ? beyond + 2 * pi : beyond) < gap.end - gap.begin;
        }
        double const inside = depth(discs, angle);
        if (std::fabs(inside) > 1e-8) {
            EXPECT_EQ(in_gap, inside < 0) << angle << ": depth " << inside;
        }
    }
    double total = 0;
    for (Gap const& gap : gaps) {
        EXPECT_LT(gap.begin, gap.end);
        EXPECT_GE(gap.begin, -3 * pi);
        EXPECT_LE(gap.end, pi);
        EXPECT_LT(depth(discs, (gap.begin + gap.end) / 2), 0);
        total += gap.end - gap.begin;
        if (gap.from < 0) continue;
        auto const &from = discs[static_cast<std::size_t>(gap.from)], &to = discs[static_cast<std::size_t>(gap.to)];
        EXPECT_NEAR(depth(from, gap.begin), 0, 1e-9);
        EXPECT_NEAR(depth(to, gap.end), 0, 1e-9);
        EXPECT_GT(depth(from, gap.begin - 1e-6), depth(from, gap.begin + 1e-6));
        EXPECT_LT(depth(to, gap.end - 1e-6), depth(to, gap.end + 1e-6));
    }
    EXPECT_LE(total, 2 * pi * (1 + 1e-15));
}

/// The neighbours of the origin on the lattice of p and q, nearer than twice the radius; in units of the radius.
Discs lattice(Vector<double, 2> const& p, Vector<double, 2> const& q, double radius) {
    Discs discs;
    for (int a = -4; a <= 4; ++a)
        for (int b = -4; b <= 4; ++b) {
            auto const x = 1 / radius * (static_cast<double>(a) * p + static_cast<double>(b) * q);
            if ((a != 0 || b != 0) && norm2(x) <= 4) discs.push_back({x, 1});
        }
    return discs;
}

TEST(ArcCoverage, AgreesWithPointsOnTheCircleForRandomClouds) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> place(-1.6, 1.6), radius(0.2, 1.8);
    int covered = 0;
    for (int cloud = 0; cloud < 4000; ++cloud) {
        Discs discs(static_cast<std::size_t>(cloud % 14));
        for (Disc& disc : discs) disc = {{{place(engine), place(engine)}}, cloud % 2 ? radius(engine) : 1};
        expect_right(discs);
        covered += coverage_by(discs).covered();
    }
    EXPECT_GT(covered, 1000);
    EXPECT_LT(covered, 3000);
}

TEST(ArcCoverage, AgreesForCloudsOnALatticeWithTwins) {
    std::mt19937 engine(2);
    std::uniform_int_distribution<int> place(-3, 3), size(1, 3);
    for (int cloud = 0; cloud < 4000; ++cloud) {
        Discs discs(static_cast<std::size_t>(cloud % 10));
        for (Disc& disc : discs)
            disc = {{{place(engine) * 0.5, place(engine) * 0.5}}, cloud % 2 ? size(engine) * 0.5 : 1};
        expect_right(discs);
    }
}

TEST(ArcCoverage, OfALatticeIsFullAndWhatTouchesCloses) {
    Vector<double, 2> const x{{1, 0}}, y{{0, 1}}, up{{0.5, std::sqrt(0.75)}};
    // Four neighbours leave nothing from half a diagonal on, six from the circumradius of a triangle on.
    for (auto const& [q, closes] : {std::pair{y, std::sqrt(0.5)}, {up, std::sqrt(1 / 3.0)}})
        for (double const angle : {0.0, pi / 4, pi / 6, 0.3}) {
            auto const turned = [&](Vector<double, 2> const& v) {
                return v[0] * at(angle) + v[1] * at(angle + pi / 2);
            };
            for (double const larger : {1.0, 1.01, 1.2, 1.4, 1.7})
                EXPECT_TRUE(gaps_left_by(lattice(turned(x), turned(q), closes * larger)).empty()) << angle << larger;
            EXPECT_EQ(gaps_left_by(lattice(turned(x), turned(q), closes * 0.9999)).size(), q[0] > 0 ? 6 : 4);
        }
}

TEST(ArcCoverage, LeavesOneGapAtTheEdgeOfALattice) {
    auto discs = lattice({{1, 0}}, {{0, 1}}, 1);
    std::erase_if(discs, [](Disc const& disc) { return disc.x[1] > 0; });
    auto const gaps = gaps_left_by(discs);
    ASSERT_EQ(gaps.size(), 1u);
    // From the neighbour on the right, which ends at 60 degrees, to the one on the left; to `closing` times tan 60.
    EXPECT_NEAR(std::remainder(gaps[0].begin - pi / 3, 2 * pi), 0, 1e-9);
    EXPECT_NEAR(gaps[0].end - gaps[0].begin, pi / 3, 1e-9);
    EXPECT_EQ(discs[static_cast<std::size_t>(gaps[0].from)].x[0], 1);
    EXPECT_EQ(discs[static_cast<std::size_t>(gaps[0].to)].x[0], -1);
}

TEST(ArcCoverage, OfADiscInAnotherIsFullAndOfADiscAroundAnotherIsNone) {
    for (double const x : {0.0, 0.25, -0.5}) {
        EXPECT_TRUE(gaps_left_by({{{{x, 0}}, 1 + std::fabs(x) + (x == 0 ? 1e-6 : 0)}}).empty());  // touches from inside
        EXPECT_TRUE(gaps_left_by({{{{0, x}}, 2}}).empty());
        auto const around = gaps_left_by({{{{x, 0}}, 0.5 * (1 - std::fabs(x))}});
        ASSERT_EQ(around.size(), 1u);
        EXPECT_EQ(around[0].end - around[0].begin, 2 * pi);
        EXPECT_EQ(around[0].from, -1);
    }
    EXPECT_FALSE(coverage_by({}).covered());
}

TEST(ArcCoverage, OfTwoParticlesAtOnePlaceIsThatOfOne) {
    EXPECT_FALSE(coverage_by({{{{0, 0}}, 1}}).covered());
    EXPECT_FALSE(coverage_by({{{{1e-9, 0}}, 1}, {{{0.5, 0}}, 1}}).covered());
    // As soon as they are two, each is covered on the side of the other: half of it.
    for (double const apart : {2e-7, 1e-5, 1e-3}) {
        auto const gaps = gaps_left_by({{{{apart, 0}}, 1}});
        ASSERT_EQ(gaps.size(), 1u);
        EXPECT_NEAR(gaps[0].end - gaps[0].begin, pi, 2 * apart + 2e-10 / apart);
        EXPECT_NEAR(std::remainder((gaps[0].begin + gaps[0].end) / 2 - pi, 2 * pi), 0, 1e-12);
    }
}

TEST(ArcCoverage, KnowsItsAngles) {
    for (int k = -1000; k <= 1000; ++k) {
        double const angle = pi * k / 1000.0, q = quarters(std::cos(angle), std::sin(angle));
        EXPECT_NEAR(radians(q), angle, 1e-15);
    }
    EXPECT_EQ(quarters(1, 0), 0);
    EXPECT_EQ(quarters(0, 1), 1);
    EXPECT_EQ(quarters(0, -1), -1);
    EXPECT_EQ(std::fabs(quarters(-1, 0)), 2);
}

}  // namespace
