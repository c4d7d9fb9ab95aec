// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/conserving_shift.hpp"

#include <gtest/gtest.h>

#include "tests/schemes/bodies.hpp"

namespace coronet {

namespace {

constexpr double support = 3.5;

struct Shifted {
    std::unique_ptr<Body<2>> body;
    Boundary<2> boundary;
    std::vector<Vector<double, 2>> x, v;  ///< before
};

/// A disc of particles of several masses, moved by up to `jitter` spacings, with the velocities that `flow` says.
template <class Flow>
Shifted shifted(double jitter, Flow const& flow) {
    Shifted made{body<2>(12, jitter, support), {}, {}, {}};
    auto& particles = made.body->particles;
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        view.at<Mass>()[i] *= 1 + 0.2 * static_cast<double>(i % 3);
        view.set<Velocity>(i, flow(i, view.get<Position>(i)));
        made.x.push_back(view.get<Position>(i));
        made.v.push_back(view.get<Velocity>(i));
    }
    made.boundary = find_boundary(particles, made.body->neighbours, 1.2 * made.body->dx, made.body->dx,
                                  made.body->dx * made.body->dx);
    ConservingShift<2> shift(made.body->dx);
    shift.find(particles, made.body->neighbours);
    shift.apply(particles, made.body->neighbours, made.boundary);
    return made;
}

double cross(Vector<double, 2> const& a, Vector<double, 2> const& b) { return a[0] * b[1] - a[1] * b[0]; }

}  // namespace

TEST(ConservingShift, KeepsCentreMomentumAngularMomentumSizeAndContent) {
    auto const vx = random_numbers(1000, 3), vy = random_numbers(1000, 4);
    auto const s = shifted(0.5, [&](std::size_t i, auto const&) { return Vector<double, 2>{{5 + vx[i], vy[i]}}; });
    auto const view = s.body->particles.view();
    Vector<double, 2> centre{}, momentum{};
    double turn = 0, size = 0, content = 0, moved = 0, of_moved = 0;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        auto const x = view.get<Position>(i), v = view.get<Velocity>(i), d = x - s.x[i];
        double const m = view.at<Mass>()[i];
        centre += m * d;
        momentum += m * (v - s.v[i]);
        turn += m * (cross(x, v) - cross(s.x[i], s.v[i]));
        size += dot(s.boundary.of_size[i], d);
        content += dot(s.boundary.of_content[i], d);
        moved += m * std::sqrt(norm2(d));
        of_moved += std::sqrt(norm2(s.boundary.of_size[i]) * norm2(d));
    }
    EXPECT_GT(moved, 0);
    EXPECT_LT(std::sqrt(norm2(centre)), 1e-13 * moved);
    EXPECT_LT(std::sqrt(norm2(momentum)), 1e-12 * moved);
    EXPECT_LT(std::fabs(turn), 1e-11 * moved);
    EXPECT_LT(std::fabs(size), 1e-11 * of_moved);
    EXPECT_LT(std::fabs(content), 1e-11 * of_moved);
}

TEST(ConservingShift, PartsWhatIsTooNear) {
    auto const s = shifted(0.5, [](std::size_t, auto const&) { return Vector<double, 2>{}; });
    auto const view = s.body->particles.view();
    double before = 0, after = 0;
    for (std::size_t i = 0; i < s.x.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            auto const lack = [&](Vector<double, 2> const& apart) {
                double const gap = s.body->dx - std::sqrt(norm2(apart));
                return gap > 0 ? gap * gap : 0;
            };
            before += lack(s.x[i] - s.x[j]);
            after += lack(view.get<Position>(i) - view.get<Position>(j));
        }
    EXPECT_LT(after, 0.6 * before);
}

TEST(ConservingShift, LeavesALatticeAlone) {
    auto const s = shifted(0, [](std::size_t, auto const& x) { return x; });
    for (std::size_t i = 0; i < s.x.size(); ++i)
        EXPECT_LT(norm2(s.body->particles.view().get<Position>(i) - s.x[i]), 1e-26);
}

TEST(ConservingShift, DoesNotDiffuseALinearFlow) {
    auto const strain = [](Vector<double, 2> const& x) {
        return Vector<double, 2>{{3 * x[0] + x[1], 2 * x[0] - 3 * x[1]}};
    };
    auto const s = shifted(0.4, [&](std::size_t, auto const& x) { return strain(x); });
    auto const view = s.body->particles.view();
    // But for the rigid motion that gives the angular momentum back: fitted and taken off.
    double spin = 0, inertia = 0, left = 0, moved = 0;
    auto const error = [&](std::size_t i) { return view.get<Velocity>(i) - strain(view.get<Position>(i)); };
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        auto const x = view.get<Position>(i);
        spin += cross(x, error(i));
        inertia += norm2(x);
    }
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        auto const x = view.get<Position>(i);
        left += norm2(error(i) - (spin / inertia) * Vector<double, 2>{{-x[1], x[0]}});
        moved += norm2(strain(x - s.x[i]));
    }
    EXPECT_LT(left, 1e-4 * moved);
}

}  // namespace coronet
