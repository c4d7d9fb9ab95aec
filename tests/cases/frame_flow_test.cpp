// SPDX-License-Identifier: BSD-3-Clause

// The flow of a frame at other points than its particles: what is met exactly, how fast the rest converges, and what
// holds where particles are few.

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "coronet/cases/frame_flow.hpp"
#include "coronet/core/random.hpp"

namespace coronet {

namespace {

template <int D>
using Point = Vector<double, D>;

/// Component k of the velocity at x; the pressure for k = D.
template <int D>
using Flow = std::function<double(Point<D> const& x, int k)>;

/// A frame of a flow at these particles, each of the volume of a cube of edge dx.
template <int D>
Frame frame_of(std::vector<Point<D>> const& points, double dx, Flow<D> const& flow) {
    Frame frame;
    frame.fields = {{"pressure", "Pa", 1, {}}, {"velocity", "m/s", 3, {}}, {"volume", "m^3", 1, {}}};
    for (auto const& x : points) {
        frame.ids.push_back(static_cast<std::int64_t>(frame.ids.size()));
        for (int k = 0; k < 3; ++k) {
            frame.points.push_back(k < D ? x[k] : 0);
            frame.fields[1].values.push_back(k < D ? flow(x, k) : 0);
        }
        frame.fields[0].values.push_back(flow(x, D));
        frame.fields[2].values.push_back(std::pow(dx, D));
    }
    return frame;
}

/// Cell centres of a unit square or cube, each displaced by up to `jitter` spacings.
template <int D>
std::vector<Point<D>> lattice(int cells, double jitter) {
    std::vector<Point<D>> points;
    int const count = D == 2 ? cells * cells : cells * cells * cells;
    for (int n = 0; n < count; ++n) {
        Point<D> x;
        for (int k = 0, digits = n; k < D; ++k, digits /= cells)
            x[k] =
                (digits % cells + 0.5 + jitter * (2 * random(1, static_cast<std::size_t>(n), std::uint64_t(k)) - 1)) /
                cells;
        points.push_back(x);
    }
    return points;
}

struct Errors {
    double largest, rms;
};

/// Of all components and the pressure.
template <int D>
Errors errors(FrameFlow<D> const& found, std::vector<Point<D>> const& points, Flow<D> const& flow) {
    double largest = 0, sum = 0;
    for (auto const& x : points) {
        auto const value = found.at(x);
        EXPECT_FALSE(value.beyond);
        for (int k = 0; k <= D; ++k) {
            double const error = (k < D ? value.velocity[k] : value.pressure) - flow(x, k);
            largest = std::max(largest, std::fabs(error));
            sum += error * error;
        }
    }
    return {largest, std::sqrt(sum / static_cast<double>((D + 1) * points.size()))};
}

template <int D>
double linear(Point<D> const& x, int component) {
    double value = component + 0.25;
    for (int k = 0; k < D; ++k) value += (0.7 * k - 0.4 * component - 1) * x[k];
    return value;
}

/// The finer lattice reaches beyond the coarser one's outermost particles, into its corners.
template <int D>
void expect_linear_flow_is_met() {
    for (double const jitter : {0.0, 0.3}) {
        FrameFlow<D> const found(frame_of<D>(lattice<D>(8, jitter), 1.0 / 8, linear<D>), {});
        EXPECT_LT(errors<D>(found, lattice<D>(21, 0), linear<D>).largest, 1e-13) << "jitter " << jitter;
    }
}

TEST(FrameFlow, ThatIsLinearIsMetOnAnotherLatticeInTwoDimensions) { expect_linear_flow_is_met<2>(); }

TEST(FrameFlow, ThatIsLinearIsMetOnAnotherLatticeInThreeDimensions) { expect_linear_flow_is_met<3>(); }

/// Root mean square, on a lattice turned by 30 degrees that reaches all four walls; waves along x, y, and for the
/// pressure along a diagonal.
TEST(FrameFlow, ThatIsSmoothIsMetToSecondOrder) {
    Flow<2> const wave = [](Point<2> const& x, int k) {
        return k < 2 ? std::sin(2 * std::numbers::pi * x[k] + 0.3) : std::cos(4 * (x[0] + x[1]));
    };
    std::vector<Point<2>> turned;
    for (auto const& x : lattice<2>(63, 0)) {
        double const a = 1.4 * (x[0] - 0.5), b = 1.4 * (x[1] - 0.5), root = std::sqrt(0.75);
        Point<2> const y{{0.5 + root * a - 0.5 * b, 0.5 + 0.5 * a + root * b}};
        if (std::min(y[0], y[1]) >= 0 && std::max(y[0], y[1]) <= 1) turned.push_back(y);
    }
    for (double const jitter : {0.0, 0.2}) {
        double error[3];
        for (int k = 0; k < 3; ++k) {
            int const cells = 20 << k;
            FrameFlow<2> const found(frame_of<2>(lattice<2>(cells, jitter), 1.0 / cells, wave), {});
            error[k] = errors(found, turned, wave).rms;
        }
        EXPECT_GT(std::log2(error[0] / error[1]), 1.9) << "jitter " << jitter;
        EXPECT_GT(std::log2(error[1] / error[2]), 1.9) << "jitter " << jitter;
        EXPECT_LT(error[2], 5e-4) << "jitter " << jitter;
    }
}

/// Twenty particles to a wavelength: what smoothing takes off is a thirtieth, and a thirtieth of that is left of it.
TEST(FrameFlow, ThatIsPeriodicHasNoSeamAndKeepsItsEnergy) {
    Flow<2> const wave = [](Point<2> const& x, int k) { return std::sin(2 * std::numbers::pi * (x[0] + 0.2 * k)); };
    PeriodicBox<2> const box{.low = {}, .size = {{1, 1}}, .periodic = {true, true}};
    FrameFlow<2> const found(frame_of<2>(lattice<2>(20, 0), 1.0 / 20, wave), box);
    double energy = 0, seam = 0;
    auto const points = lattice<2>(60, 0);
    for (auto const& x : points) {
        energy += found.at(x).velocity[0] * found.at(x).velocity[0];
        seam = std::max(seam, std::fabs(found.at(x).pressure - wave(x, 2)));
    }
    EXPECT_NEAR(energy / static_cast<double>(points.size()), 0.5, 1.5e-3);
    EXPECT_LT(seam, 2e-3);
}

TEST(FrameFlow, BesideARowOfParticlesIsTheirMean) {
    std::vector<Point<2>> row;
    for (int k = 0; k < 20; ++k) row.push_back({{0.1 * k, 0.3}});
    FrameFlow<2> const found(frame_of<2>(row, 0.1, linear<2>), {});
    for (double const y : {0.3, 0.35}) {  // on the row, and off it: symmetric about x = 1
        auto const value = found.at({{1.0, y}});
        EXPECT_NEAR(value.velocity[0], linear<2>({{1.0, 0.3}}, 0), 1e-12);
        EXPECT_NEAR(value.pressure, linear<2>({{1.0, 0.3}}, 2), 1e-12);
        EXPECT_FALSE(value.beyond);
    }
}

TEST(FrameFlow, FarFromAllParticlesIsThatOfTheNearest) {
    FrameFlow<3> const found(frame_of<3>(lattice<3>(6, 0), 1.0 / 6, linear<3>), {});
    Point<3> const corner{{11.0 / 12, 11.0 / 12, 1.0 / 12}};
    auto const value = found.at({{4, 5, -3}});
    EXPECT_TRUE(value.beyond);
    EXPECT_NEAR(value.velocity[1], linear<3>(corner, 1), 1e-12);
    EXPECT_NEAR(value.pressure, linear<3>(corner, 3), 1e-12);
}

}  // namespace

}  // namespace coronet
