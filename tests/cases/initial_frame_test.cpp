// SPDX-License-Identifier: BSD-3-Clause

// A case that starts from a frame: what its particles get of it, and which frames are refused with what words.

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/core/error.hpp"
#include "coronet/io/frame.hpp"

namespace coronet {

namespace {

namespace fs = std::filesystem;

class InitialFrame : public ::testing::Test {
protected:
    /// Liquid in the unit square around x = 0, 0.05 m apart; u = 1 + y, p = 200 x.
    InitialFrame() {
        fs::create_directories(folder);
        frame.fields = {{"pressure", "Pa", 1, {}}, {"velocity", "m/s", 3, {}}, {"volume", "m^2", 1, {}}};
        for (int n = 0; n < 400; ++n) add((n % 20 + 0.5) * 0.05 - 0.5, (n / 20 + 0.5) * 0.05 - 0.5);
    }
    ~InitialFrame() override { fs::remove_all(folder); }

    void add(double x, double y) {
        frame.ids.push_back(static_cast<std::int64_t>(frame.ids.size()));
        frame.points.insert(frame.points.end(), {x, y, 0});
        field(0).push_back(200 * x);
        field(1).insert(field(1).end(), {1 + y, 0, 0});
        field(2).push_back(0.05 * 0.05);
    }
    std::vector<double>& field(std::size_t k) { return frame.fields[k].values; }

    Case case_from_frame(std::vector<std::string> const& settings = {}) const {
        std::string const text =
            "name = 'finer'\ndimension = 2\nshapes = [{ kind = 'box', size = [1.0, 1.0] }]\n"
            "particles = { spacing = 0.02, origin = 'cell' }\nfluid = { density = 1000, sound_speed = 20 }\n"
            "initial = { velocity = ['7', '7'], pressure = 7, from = 'coarse.vtkhdf' }\ntime.end = 0.1\n";
        write_frame(folder / "coarse.vtkhdf", frame);
        return read_case(text, (folder / "finer.toml").string(), settings);
    }
    std::string complaint(std::vector<std::string> const& settings = {}) const {
        try {
            case_from_frame(settings);
            return "none";
        } catch (CaseError const& error) {
            return error.what();
        }
    }
    void expect_complaint(std::string const& part, std::vector<std::string> const& settings = {}) const {
        std::string const found = complaint(settings), file = (folder / "finer.toml").string();
        EXPECT_TRUE(found.starts_with(file + ": ")) << found;
        EXPECT_NE(found.find("initial.from = 'coarse.vtkhdf'"), std::string::npos) << found;
        EXPECT_NE(found.find(part), std::string::npos) << found;
    }

    fs::path folder = fs::temp_directory_path() / ("coronet_initial_frame_test." + std::to_string(getpid()));
    Frame frame;
};

TEST_F(InitialFrame, GivesItsVelocityAndPressureInPlaceOfTheFormulas) {
    auto const c = case_from_frame();
    auto const seeds = fill<2>(c);
    auto const state = initial_state(c, seeds, WallSeeds<2>{});
    auto const view = state.particles.view();
    ASSERT_EQ(seeds.size(), 2500u);
    EXPECT_EQ(state.beyond, 0u);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        auto const& x = seeds.position[i];
        double const rho = 1000 + 200 * x[0] / 400;
        EXPECT_NEAR(view.get<Velocity>(i)[0], 1 + x[1], 1e-13);
        EXPECT_NEAR(view.get<Velocity>(i)[1], 0, 1e-13);
        EXPECT_NEAR(view.get<Density>(i), rho, 1e-10);
        EXPECT_NEAR(view.get<Mass>(i), rho * 0.02 * 0.02, 1e-12);
    }
}

TEST_F(InitialFrame, OfARunWithWallsGivesItsLiquidAlone) {
    frame.fields.push_back({"wall", "-", 1, std::vector<double>(400, 0.0)});
    for (int k = 0; k < 20; ++k) {
        add(k * 0.05, -0.525);
        field(1)[3 * frame.ids.size() - 3] = 1000;
        field(2).back() = 0;
        field(3).push_back(1);
    }
    EXPECT_EQ(case_from_frame().initial.frame->ids.size(), 400u);
}

TEST_F(InitialFrame, GivesAProjectionItsVelocityAndNeedsNoPressureThen) {
    std::vector<std::string> const projection{"method.scheme=projection", "initial.pressure=0"};
    frame.fields.erase(frame.fields.begin());
    auto const c = case_from_frame(projection);
    auto const state = initial_state(c, fill<2>(c), WallSeeds<2>{});
    for (std::size_t i = 0; i < state.particles.owned(); ++i) EXPECT_EQ(state.particles.view().get<Density>(i), 1000);
    EXPECT_NEAR(state.fastest2, 0.49 * 0.49, 1e-12);
    expect_complaint("it has no field 'pressure'");
}

TEST_F(InitialFrame, ThatIsOfAnotherDimensionIsRefused) {
    frame.points[2] = 0.1;
    expect_complaint("it is of a run in 3 dimensions, and the case is in 2");
    frame.points[2] = 0;
    expect_complaint("it is of a run in 2 dimensions, and the case is in 3",
                     {"dimension=3", "shapes.0.size=[1,1,1]", "initial.velocity=[0,0,0]"});
}

TEST_F(InitialFrame, WithoutVelocityOrLiquidIsRefused) {
    frame.fields[1].name = "speed";
    expect_complaint("it has no field 'velocity'");
    frame.fields[1] = {"velocity", "m/s", 1, std::vector<double>(400, 1.0)};
    expect_complaint("its 'velocity' has 1 components, not 3");
    frame.fields = {{"wall", "-", 1, std::vector<double>(400, 1.0)}};
    expect_complaint("it holds no liquid");
}

TEST_F(InitialFrame, OfARunThatHasBlownUpIsRefused) {
    field(1)[30] = NAN;
    expect_complaint("it holds numbers that are not finite");
}

TEST_F(InitialFrame, OfLiquidElsewhereIsRefused) {
    expect_complaint("of 2500 of the 2500 particles", {"shapes.0.centre=[3, 0]"});
    EXPECT_EQ(complaint({"shapes.0.size=[1.28, 1]"}), "none");
    expect_complaint("of 700 of the 3500 particles", {"shapes.0.size=[1.4, 1]", "shapes.0.centre=[0.2, 0]"});
}

TEST_F(InitialFrame, OfALargerPeriodicBoxIsRefused) {
    expect_complaint("has liquid from -0.475 to 0.475 m along x, beyond the periodic box of -0.4 to 0.4 m",
                     {"domain={ periodic = 'x', size = [0.8, 1.0] }", "shapes.0.size=[0.8, 1]"});
}

TEST_F(InitialFrame, FasterThanSoundOrOfAPressureThatEmptiesTheLiquidIsRefused) {
    expect_complaint("the velocity of initial.from = 'coarse.vtkhdf' is up to", {"fluid.sound_speed=0.4"});
    for (double& p : field(0)) p = -1e7;
    expect_complaint("leaves no positive finite density");
}

}  // namespace

}  // namespace coronet
