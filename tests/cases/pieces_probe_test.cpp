// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/pieces_probe.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "coronet/cases/fill.hpp"
#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"

namespace coronet {

namespace {

/// Two discs (balls) of 8 spacings, flying towards each other on lines that are so far from the x axis, their centres
/// so far apart along it.
template <int D>
Case two_drops(double apart, double off = 1) {
    std::string const kind = D == 2 ? "disc" : "ball", aside = fmt::format("{}{}", off, D == 2 ? "" : ", 0");
    return read_case(
        fmt::format("name = 'two'\ndimension = {}\n[[shapes]]\nkind = '{}'\nradius = 8\ncentre = [{}, {}]\n"
                    "[[shapes]]\nkind = '{}'\nradius = 8\ncentre = [{}, -{}]\n[particles]\nspacing = 1\n"
                    "lattice = 'shells'\n[initial]\nvelocity = ['x < 0 ? 1 : -1', {}]\n[fluid]\ndensity = 2\n"
                    "viscosity = 0\nsurface_tension = 10\nsound_speed = 30\n[method]\nsupport = 3\n"
                    "kernel = 'wendland-c2'\n[surface]\ncoverage_radius = 1.4\n[time]\nend = 1\n",
                    D, kind, -apart / 2, aside, kind, apart / 2, aside, D == 2 ? "0" : "0, 0"),
        "two");
}

template <int D>
Particles<D> particles_of(Case const& c) {
    auto state = initial_state(c, fill<D>(c), WallSeeds<D>{});
    return std::move(state.particles);
}

template <int D>
void sees_them_join() {
    auto const c = two_drops<D>(30);
    PiecesProbe<D> probe(c);
    double time = 0;
    std::vector<double> row;
    for (double const apart : {30.0, 25.0, 19.0, 16.5}) {
        auto const now = two_drops<D>(apart);
        row = probe.sample({time++, particles_of<D>(now), now});
        bool const joined = apart < 17;
        EXPECT_EQ(row[0], joined ? 1 : 2) << apart;
        // The outermost shells are somewhat less than half a spacing within the surfaces.
        EXPECT_NEAR(row[1], joined ? 0 : std::hypot(apart, 2) - 16, 0.4) << apart;
        EXPECT_LT(row[2], 1e-14);
        EXPECT_LT(row[3], 1e-13);
    }
    auto const off = two_drops<D>(16.5, 1.1);  // the moment of both momenta is a tenth larger
    row = probe.sample({time, particles_of<D>(off), off});
    double lever = 0, mass = 0;
    auto const first = two_drops<D>(30);
    auto const particles = particles_of<D>(first);
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        lever += std::sqrt(norm2(particles.view().template get<Position>(i)));
        mass += 1;
    }
    EXPECT_NEAR(row[3], 0.1 * mass / lever, 0.01 * row[3]);
    std::map<std::string, double> measures;
    for (Measure const& m : probe.measures()) measures[m.name] = m.value;
    EXPECT_EQ(measures.at("pieces_final"), 1);
    EXPECT_EQ(measures.at("joins_at"), 3);
    EXPECT_NEAR(measures.at("joining_gap"), std::hypot(19, 2) - 16, 0.4);
    EXPECT_EQ(measures.at("angular_momentum_drift"), row[3]);
}

}  // namespace

TEST(PiecesProbe, SeesTwoDropsJoinIn2D) { sees_them_join<2>(); }
TEST(PiecesProbe, SeesTwoDropsJoinIn3D) { sees_them_join<3>(); }

}  // namespace coronet
