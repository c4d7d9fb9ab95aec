// SPDX-License-Identifier: BSD-3-Clause

// What holds of shifting: lattices stay, crowds spread, linear fields are met exactly, and a surface that is respected
// keeps its place.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "coronet/core/parallel.hpp"
#include "coronet/schemes/shifting.hpp"
#include "tests/neighbours/points.hpp"
#include "tests/schemes/bodies.hpp"

namespace coronet {

namespace {

constexpr double dx = 0.1, support = 2.6 * dx, step = 0.01, speed = 1.0, alpha = speed * step;

/// A box of side n of particles in a flow whose largest speed, from its mean, is 1 m/s; not at the centre of the world.
template <int D>
struct Box {
    Particles<D> particles;
    Neighbours<D> neighbours{support, 0.05 * dx};
    std::vector<Vector<double, D>> start;  ///< by identity

    /// Each particle is displaced by displaced(x) from its place in the lattice, whose centre is 0.
    Box(int n, std::function<Vector<double, D>(Vector<double, D> const&)> const& displaced)
        : particles(test::particles_at(test::lattice<D>(n, dx))) {
        particles.template allocate<Velocity, Density, Volume>();
        auto const view = particles.view();
        double largest2 = 0;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            auto x = view.template get<Position>(i);
            for (int k = 0; k < D; ++k) x[k] -= (n - 1) * dx / 2;
            view.template set<Position>(i, x + displaced(x));
            view.template set<Volume>(i, std::pow(dx, D));
            largest2 = std::max(largest2, norm2(flow(view.template get<Position>(i))));
        }
        for (std::size_t i = 0; i < particles.size(); ++i) {
            auto const x = view.template get<Position>(i);
            view.template set<Velocity>(i, (speed / std::sqrt(largest2)) * flow(x));
            view.template set<Density>(i, 1000 + 3 * x[0] - 2 * x[D - 1]);
            start.push_back(x);
        }
        scale = speed / std::sqrt(largest2);
    }
    Box(int n, double jitter) : Box(n, random(jitter)) {}

    /// Linear, with divergence, shear and rotation; its mean over the box is 0.
    static Vector<double, D> flow(Vector<double, D> const& x) {
        Vector<double, D> v;
        for (int k = 0; k < D; ++k) v[k] = (k + 1) * x[k] - 3 * x[(k + 1) % D];
        return v;
    }
    static std::function<Vector<double, D>(Vector<double, D> const&)> random(double jitter) {
        auto engine = std::make_shared<std::mt19937_64>(5);
        return [=](Vector<double, D> const&) {
            Vector<double, D> d;
            for (int k = 0; k < D; ++k)
                d[k] = jitter * dx * (2 * (static_cast<double>((*engine)() >> 11) * 0x1p-53) - 1);
            return d;
        };
    }

    void shift(ShiftVector vector, double coefficient = 0, int times = 1) {
        Kernel const kernel = make_kernel("cubic-spline", D, support);
        SurfaceSettings const surface{.spacing = dx, .coverage_radius = 1.2 * dx, .fit = {2.5 * dx}};
        Shifting<D> shifting({vector,
                              coefficient > 0              ? coefficient
                              : vector == ShiftVector::sun ? 1
                                                           : 0.1,
                              dx, surface},
                             kernel, Precision::full);
        for (int k = 0; k < times; ++k) {
            neighbours.update(particles);
            shifting.find(particles, neighbours, step);
            shifting.apply(particles);
        }
    }
    /// From where it stood to where it stands.
    Vector<double, D> moved(std::size_t i) const {
        return particles.view().template get<Position>(i) - start[static_cast<std::size_t>(particles.id[i])];
    }
    bool inside(std::size_t i, double from_edge, double half) const {
        auto const& x = start[static_cast<std::size_t>(particles.id[i])];
        return std::all_of(x.c, x.c + D, [&](double c) { return std::fabs(c) < half - from_edge; });
    }
    double least_spacing() const {
        auto const x = test::points_of(particles);
        double least2 = 1;
        for (std::size_t i = 0; i < x.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) least2 = std::min(least2, norm2(x[i] - x[j]));
        return std::sqrt(least2);
    }

    double scale;  ///< of flow()
};

constexpr ShiftVector all[] = {ShiftVector::xu, ShiftVector::jahanbakhsh, ShiftVector::sun};

template <class Act>
void in_2d_and_3d(Act const& act) {
    act(std::integral_constant<int, 2>{}, 12);
    act(std::integral_constant<int, 3>{}, 8);
}

}  // namespace

TEST(Shifting, LeavesALatticeInPeace) {
    in_2d_and_3d([]<int D>(std::integral_constant<int, D>, int n) {
        for (ShiftVector const vector : all) {
            Box<D> box(n, 0.0);
            box.shift(vector);
            double largest = 0;
            for (std::size_t i = 0; i < box.particles.size(); ++i)
                if (box.inside(i, support, n * dx / 2)) largest = std::max(largest, norm2(box.moved(i)));
            // Differences of coordinates are exact to 1e-16 of a metre, ten neighbours push by up to K alpha each.
            EXPECT_LT(std::sqrt(largest), 1e-13 * alpha) << static_cast<int>(vector) << " in " << D << "D";
        }
    });
}

TEST(Shifting, OfNeighboursNearerThanASpacingLeavesTheSurfaceOfALatticeWhereItIs) {
    Box<2> lattice(12, 0.0);
    lattice.shift(ShiftVector::jahanbakhsh);
    Box<2> spreading(12, 0.0);
    spreading.shift(ShiftVector::xu);
    double stays = 0, spreads = 0;
    for (std::size_t i = 0; i < lattice.particles.size(); ++i) {
        stays = std::max(stays, norm2(lattice.moved(i)));
        spreads = std::max(spreads, norm2(spreading.moved(i)));
    }
    EXPECT_EQ(stays, 0);
    EXPECT_GT(std::sqrt(spreads), 0.1 * alpha) << "with neighbours on one side Xu's vector points out";
}

TEST(Shifting, SpreadsACrowd) {
    in_2d_and_3d([]<int D>(std::integral_constant<int, D>, int n) {
        for (ShiftVector const vector : all) {
            Box<D> box(n, 0.35);
            double const before = box.least_spacing();
            box.shift(vector, 0, 40);
            EXPECT_GT(box.least_spacing(), before + 0.1 * dx) << static_cast<int>(vector) << " in " << D << "D";
        }
    });
}

TEST(Shifting, MeetsLinearFieldsExactly) {
    in_2d_and_3d([]<int D>(std::integral_constant<int, D>, int n) {
        for (ShiftVector const vector : all) {
            Box<D> box(n, 0.3);
            box.shift(vector);
            double v_error = 0, rho_error = 0, largest = 0;
            for (std::size_t i = 0; i < box.particles.size(); ++i) {
                auto const x = box.particles.view().template get<Position>(i);
                auto const v = box.particles.view().template get<Velocity>(i);
                v_error = std::max(v_error, norm2(v - box.scale * box.flow(x)));
                double const rho = box.particles.view().template get<Density>(i);
                rho_error = std::max(rho_error, std::fabs(rho - (1000 + 3 * x[0] - 2 * x[D - 1])));
                largest = std::max(largest, norm2(box.moved(i)));
            }
            EXPECT_GT(std::sqrt(largest), 0.1 * alpha);
            EXPECT_LE(std::sqrt(largest), 0.55 * alpha) << "the mean of the flow is not quite 0";
            EXPECT_LT(std::sqrt(v_error), 1e-14 * speed) << static_cast<int>(vector) << " in " << D << "D";
            EXPECT_LT(rho_error, 3 * 1000 * 2.3e-16) << static_cast<int>(vector) << " in " << D << "D";
        }
    });
}

TEST(Shifting, MovesNothingOutOfASurfaceThatItRespects) {
    in_2d_and_3d([]<int D>(std::integral_constant<int, D>, int n) {
        // Disorder inside and along the surface, whose rows stay flat. Far from the edges the normals are along the
        // axes.
        double const half = (n - 1) * dx / 2;
        auto const random = Box<D>::random(0.2);
        auto const displaced = [&](Vector<double, D> const& x) {
            auto d = random(x);
            for (int k = 0; k < D; ++k)
                if (std::fabs(x[k]) > half - 0.5 * dx) d[k] = 0;
            return d;
        };
        for (ShiftVector const vector : {ShiftVector::sun, ShiftVector::jahanbakhsh}) {
            Box<D> box(n, displaced);
            box.shift(vector);
            double out = 0, out_below = 0, along = 0;
            for (std::size_t i = 0; i < box.particles.size(); ++i) {
                auto const& x = box.start[static_cast<std::size_t>(box.particles.id[i])];
                bool const middle =
                    std::all_of(x.c, x.c + D - 1, [&](double c) { return std::fabs(c) < half - 2.5 * dx; });
                if (!middle || std::fabs(x[D - 1]) < half - 1.4 * dx) continue;
                auto const d = box.moved(i);
                double const outward = std::copysign(1.0, x[D - 1]) * d[D - 1];
                if (std::fabs(x[D - 1]) > half - 0.5 * dx) out = std::max(out, std::fabs(outward));
                else out_below = std::max(out_below, outward);
                along = std::max(along, std::fabs(d[0]));
            }
            EXPECT_GT(along, 0.03 * alpha);
            if (vector == ShiftVector::sun) {
                EXPECT_LT(out, 1e-12 * alpha) << D << "D";
                EXPECT_LT(out_below, 1e-12 * alpha) << D << "D";
            } else {
                EXPECT_GT(out, 0.03 * alpha) << D << "D: the paper's vector knows no surface";
            }
        }
    });
}

TEST(Shifting, DoesNotDependOnWhoLooks) {
    for (ShiftVector const vector : all) {
        Box<2> still(12, 0.3), passing(12, 0.3);
        auto const view = passing.particles.view();
        for (std::size_t i = 0; i < passing.particles.size(); ++i)
            view.set<Velocity>(i, view.get<Velocity>(i) + Vector<double, 2>{{7, -4}});
        still.shift(vector);
        passing.shift(vector);
        double worst = 0;
        for (std::size_t i = 0; i < still.particles.size(); ++i)
            worst = std::max(worst, norm2(still.moved(i) - passing.moved(i)));
        EXPECT_LT(std::sqrt(worst), 1e-13 * alpha) << static_cast<int>(vector);
    }
}

TEST(Shifting, GivesTheSameBitsForAnyNumberOfThreads) {
    for (ShiftVector const vector : all) {
        auto const shifted = [&](int count) {
            set_threads(count);
            Box<2> box(40, 0.3);
            box.shift(vector, 0, 3);
            set_threads(0);
            std::vector<double> bits;
            for (std::size_t i = 0; i < box.particles.size(); ++i)
                for (int k = 0; k < 2; ++k) {
                    bits.push_back(box.particles.view().at<Position>(k)[i]);
                    bits.push_back(box.particles.view().at<Velocity>(k)[i]);
                }
            return bits;
        };
        EXPECT_EQ(shifted(1), shifted(2)) << static_cast<int>(vector);
    }
}

}  // namespace coronet
