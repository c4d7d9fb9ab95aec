// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/detect.hpp"

#include <gtest/gtest.h>

#include <map>

#include "coronet/core/error.hpp"
#include "coronet/surface/arc_coverage.hpp"
#include "coronet/surface/sphere_coverage.hpp"
#include "tests/neighbours/points.hpp"

namespace {

using namespace coronet;
using namespace coronet::test;

/// By identity: 1 for the surface.
template <int D>
std::map<std::int64_t, double> marks(Points<D> const& points, double radius, double support, double skin = 0.1) {
    auto particles = particles_at<D>(points);
    Neighbours<D> neighbours(support, skin);
    neighbours.update(particles);
    mark_surface(particles, neighbours, radius);
    std::map<std::int64_t, double> marks;
    for (std::size_t i = 0; i < points.size(); ++i) marks[particles.id[i]] = particles.template get<Surface>()[i];
    return marks;
}

template <int D>
std::size_t count(std::map<std::int64_t, double> const& marks) {
    std::size_t count = 0;
    for (auto const& [id, mark] : marks) count += mark > 0;
    return count;
}

template <class Check>
void in_two_and_three_dimensions(Check const& check) {
    check.template operator()<2>();
    check.template operator()<3>();
}

template <int D>
bool on_the_faces(Vector<double, D> const& x, double low, double high) {
    for (double const c : x.c)
        if (c == low || c == high) return true;
    return false;
}

TEST(SurfaceDetection, MarksTheFacesOfABlock) {
    in_two_and_three_dimensions([]<int D>() {
        auto const points = lattice<D>(9, 1);
        for (double const radius : {0.9, 1.0, 1.2, 1.4})
            for (auto const& [id, mark] : marks<D>(points, radius, 3)) {
                auto const& x = points[static_cast<std::size_t>(id)];
                EXPECT_EQ(mark, on_the_faces<D>(x, 0, 8)) << "particle " << id << ", radius " << radius;
            }
    });
}

TEST(SurfaceDetection, SeesAVoidThatTheCircleFitsIn) {
    in_two_and_three_dimensions([]<int D>() {
        // Without its middle particle a lattice has a void that a ball of radius 1 just fits in.
        auto points = lattice<D>(9, 1);
        Vector<double, D> middle;
        for (double& c : middle.c) c = 4;
        std::erase_if(points, [&](auto const& x) { return norm2(x - middle) == 0; });
        std::size_t const faces = marks<D>(lattice<D>(9, 1), 1.0, 3).size();
        ASSERT_EQ(points.size(), faces - 1);
        auto const outer = count<D>(marks<D>(lattice<D>(9, 1), 1.0, 3));
        EXPECT_EQ(count<D>(marks<D>(points, 0.99, 3)), outer + 2 * D);
        EXPECT_EQ(count<D>(marks<D>(points, 1.01, 3)), outer);
        EXPECT_EQ(count<D>(marks<D>(points, 1.0, 3)), outer) << "what touches, closes";
    });
}

TEST(SurfaceDetection, DoesNotLoseParticlesThatCoincide) {
    in_two_and_three_dimensions([]<int D>() {
        auto const points = lattice<D>(6, 1);
        auto twice = points;
        twice.insert(twice.end(), points.begin(), points.end());
        auto const once = marks<D>(points, 1.0, 3), both = marks<D>(twice, 1.0, 3);
        auto const size = static_cast<std::int64_t>(points.size());
        for (auto const& [id, mark] : both) EXPECT_EQ(mark, once.at(id % size));
    });
}

TEST(SurfaceDetection, DependsOnNothingButPositionsAndRadius) {
    in_two_and_three_dimensions([]<int D>() {
        auto const points = cloud<D>(D == 2 ? 2000 : 1500);
        double const radius = D == 2 ? 0.06 : 0.2;
        auto const usual = marks<D>(points, radius, 2 * radius);
        EXPECT_GT(count<D>(usual), 100u);
        EXPECT_LT(count<D>(usual), points.size() - 100);
        for (std::size_t i = 0; i < points.size(); i += 7) {  // of all others, however far
            std::conditional_t<D == 2, ArcCoverage, SphereCoverage> coverage;
            for (std::size_t j = 0; j < points.size(); ++j)
                if (j != i) coverage.add(Cap<D>(points[j] - points[i], radius, radius));
            EXPECT_EQ(usual.at(static_cast<std::int64_t>(i)), !coverage.covered());
        }
        EXPECT_EQ(usual, marks<D>(points, radius, 3 * radius, 0.5 * radius));
        for (int const some : {1, 2, 3}) {
            set_threads(some);
            EXPECT_EQ(usual, marks<D>(points, radius, 2 * radius, 0.02)) << some << " threads";
        }
        set_threads(0);
        // Far from the origin, where positions are rounded coarsely, a lattice keeps its marks.
        auto far = lattice<D>(7, 0.1);
        auto const here = marks<D>(far, 0.1, 0.3);
        for (auto& x : far) x = x + along<D>(0, 1e4) + along<D>(1, -3e3);
        EXPECT_EQ(here, marks<D>(far, 0.1, 0.3));
    });
}

TEST(SurfaceDetection, RefusesListsThatDoNotReachFarEnough) {
    auto const points = lattice<2>(3, 1);
    EXPECT_NO_THROW(marks<2>(points, 1.5, 3));
    EXPECT_THROW(marks<2>(points, 1.51, 3), CaseError);
    EXPECT_THROW(marks<2>(points, NAN, 3), CaseError);
}

}  // namespace
