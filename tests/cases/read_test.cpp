// SPDX-License-Identifier: BSD-3-Clause

// Reading and writing cases: what is written is read as the same, and nothing is left out.

#include <sstream>

#include <gtest/gtest.h>

#include "coronet/cases/builtin.hpp"
#include "coronet/cases/nearest.hpp"
#include "coronet/cases/read.hpp"
#include "coronet/core/error.hpp"

namespace coronet {

namespace {

TEST(BuiltinCases, AreValidAndNamedAsTheirFiles) {
    EXPECT_GE(builtin_cases().size(), 4u);
    for (BuiltinFile const& known : builtin_cases()) {
        Case const c = load_case(std::string(known.name));
        EXPECT_EQ(c.name, known.name);
        EXPECT_FALSE(c.title.empty()) << known.name;
    }
}

TEST(WriteCase, OfABuiltInCaseReadsBackAsTheSameText) {
    for (BuiltinFile const& known : builtin_cases()) {
        std::string const text = write_case(load_case(std::string(known.name)));
        EXPECT_EQ(write_case(read_case(text, "written")), text);
    }
}

/// No value here is the default, so a key that is not written or not read shows.
std::string const unusual = R"case(
name = "odd.case-1"
title = "a \"quoted\" \\ title\twith\ntwo lines and a \u0001"
dimension = 2

[parameters]
a = 1.5
b_2 = 1e-300

[[shapes]]
kind = "box"
centre = [0.1, -0.2]
size = [1.1, 0.7]
rotation = 30.0

[[shapes.cuts]]
point = [0.5, 0.25]
normal = [1, 1]

[[shapes.cuts]]
normal = [0, -1]

[[shapes]]
kind = "ellipse"
semi_axes = [0.3, 0.9]

[[shapes]]
kind = "disc"
radius = 0.4

[particles]
spacing = 0.1
lattice = "hexagonal"
origin = "cell"
rotation = 17.5
jitter = 0.1
seed = 42

[initial]
velocity = ["a*y", "-b_2*x"]
pressure = "1e-3*(1 - x^2)"

[fluid]
density = 998.2
viscosity = 1e-3
sound_speed = 30.0
equation_of_state = "tait"
tait_exponent = 5.0
gravity = [0.0, -9.81]
body_force = ["0.1*sin(pi*t)", 0.25]

[method]
gradient = "cph"
kernel = "wendland-c2"
support = 2.6
skin = 0.5
artificial_viscosity = 0.3
artificial_viscosity_beta = 0.1

[time]
end = 0.1
step = 1e-4
courant = 0.2
position_update = "midpoint-velocity"

[output]
every = 0.05
series_every = 0.0125
frames = false

[[probes]]
kind = "value"
name = "p"
field = "speed"
at = [0.1, 0.2]

[[probes]]
kind = "stretching"
rates = ["a", "-a"]
semi_axes = [0.5, "a"]
)case";

TEST(WriteCase, KeepsEveryValueThatIsNotTheDefault) {
    Case const c = read_case(unusual, "unusual");
    std::string const text = write_case(c);
    Case const again = read_case(text, "written");
    EXPECT_EQ(write_case(again), text);
    EXPECT_EQ(again.title, "a \"quoted\" \\ title\twith\ntwo lines and a \x01");
    EXPECT_EQ(again.parameters, (std::map<std::string, double>{{"a", 1.5}, {"b_2", 1e-300}}));
    ASSERT_EQ(again.shapes.size(), 3u);
    EXPECT_EQ(again.shapes[0].size, (std::vector<double>{1.1, 0.7}));
    ASSERT_EQ(again.shapes[0].cuts.size(), 2u);
    EXPECT_EQ(again.shapes[0].cuts[0].normal, (std::vector<double>{1, 1}));
    EXPECT_EQ(again.shapes[0].cuts[1].point, (std::vector<double>{0, 0}));
    EXPECT_TRUE(again.shapes[1].cuts.empty());
    EXPECT_EQ(again.shapes[1].semi_axes, (std::vector<double>{0.3, 0.9}));
    EXPECT_EQ(again.fluid.body_force, (std::vector<std::string>{"0.1*sin(pi*t)", "0.25"}));
    EXPECT_EQ(again.time.step, 1e-4);
    EXPECT_EQ(again.probes.at(1).semi_axes, (std::vector<std::string>{"0.5", "a"}));
}

TEST(WriteCase, OfAProjectionReadsBackWithEveryOperator) {
    for (std::string const op : {"consistent", "thesis"})
        for (std::string const sound : {"", "sound_speed = 120.0\n"}) {
            Case const c = read_case(
                "name = 'p'\ndimension = 2\n[[shapes]]\nkind = 'disc'\nradius = 1.0\n"
                "[particles]\nspacing = 0.1\n[fluid]\ndensity = 1.0\n" +
                    sound + "[method]\nscheme = 'projection'\npressure_operator = '" + op + "'\n[time]\nend = 1.0\n",
                "p");
            std::string const text = write_case(c);
            EXPECT_EQ(write_case(read_case(text, "written")), text);
            EXPECT_EQ(text.find("[surface]"), text.rfind("[surface]"));
        }
}

TEST(WriteCase, WritesEveryKeyThatTheFileGives) {
    std::string const text = write_case(read_case(unusual, "unusual"));
    std::stringstream lines(unusual);
    for (std::string line; std::getline(lines, line);) {
        auto const equals = line.find(" = ");
        if (equals == std::string::npos) continue;
        std::string wanted = "\n";
        wanted += line.substr(0, equals + 3);
        EXPECT_NE(text.find(wanted), std::string::npos) << line;
    }
}

TEST(WriteCase, KeepsTheKeysOfThePatchProbe) {
    auto const c = load_case("square-patch", {"probes.0.side=1.25", "probes.0.angular_velocity=2*omega"});
    auto const again = read_case(write_case(c), "written");
    EXPECT_EQ(again.probes.at(0).side, "1.25");
    EXPECT_EQ(again.probes.at(0).angular_velocity, "2*omega");
}

TEST(WriteCase, GivesNumbersAPointAndTheirUnit) {
    auto const c = load_case("drop-stretching", {"shapes.0.radius=1", "fluid.viscosity=1e-3"});
    std::string const text = write_case(c);
    EXPECT_NE(text.find("\nradius = 1.0  # m\n"), std::string::npos);
    EXPECT_NE(text.find("\nviscosity = 0.001  # Pa s\n"), std::string::npos);
    EXPECT_NE(text.find("\nseed = 1\n"), std::string::npos);
}

TEST(WriteCase, SaysAutoForAnAutomaticStep) {
    std::string const text = write_case(load_case("drop-stretching", {"time.step=auto"}));
    EXPECT_NE(text.find("step = \"auto\""), std::string::npos);
    EXPECT_EQ(read_case(text, "written").time.step, 0);
}

TEST(ReadCase, GivesTenFramesAndTwoHundredRowsUnlessToldOtherwise) {
    Case const c = load_case("drop-rotating", {"time.end=0.1"});
    EXPECT_EQ(c.output.series_every, 0.1 / 200);
    EXPECT_EQ(load_case("drop-rotating", {"output={}"}).output.every, 0.1 / 10);
}

TEST(KeysPage, HasEveryKeyOnce) {
    std::map<std::string, int> rows;
    std::stringstream lines(keys_page());
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("| `")) ++rows[line.substr(3, line.find('`', 3) - 3)];
    EXPECT_GE(rows.size(), 50u);
    for (auto const& [key, count] : rows) EXPECT_EQ(count, 1) << key;

    std::string section;  // every key that `unusual` gives must be there
    std::stringstream given(unusual);
    for (std::string line; std::getline(given, line);) {
        if (line.starts_with("[")) section = line.substr(line.rfind('[') + 1, line.find(']') - line.rfind('[') - 1);
        auto const equals = line.find(" = ");
        if (equals == std::string::npos || section.starts_with("parameters")) continue;
        if (!section.empty() && section.back() != '.') section += '.';
        EXPECT_TRUE(rows.contains(section + line.substr(0, equals))) << section << line;
    }
    EXPECT_TRUE(rows.contains("parameters"));
    EXPECT_TRUE(rows.contains("shapes.cuts"));
}

TEST(KeysPage, TellsUnitRangeDefaultAndMeaning) {
    EXPECT_NE(keys_page().find(
                  "| `particles.spacing` | number [m], above 0 | required | distance between lattice neighbours |"),
              std::string::npos);
    EXPECT_NE(keys_page().find("| `method.gradient` | `sph`, `cph`, `fpm` | `fpm` |"), std::string::npos);
}

TEST(Nearest, FindsTheWordThatWasMeant) {
    std::vector<std::string> const words{"spacing", "lattice", "origin", "rotation", "jitter", "seed"};
    EXPECT_EQ(nearest("spaceing", words), "spacing");
    EXPECT_EQ(nearest("lattise", words), "lattice");
    EXPECT_EQ(nearest("oirgin", words), "origin");
    EXPECT_EQ(nearest("sede", words), "seed");
    EXPECT_EQ(nearest("spacing", words), "spacing");
}

TEST(Nearest, DoesNotGuessWildly) {
    std::vector<std::string> const words{"spacing", "lattice", "at", "end", "sph"};
    EXPECT_EQ(nearest("colour", words), "");
    EXPECT_EQ(nearest("dx", words), "");
    EXPECT_EQ(nearest("foo", words), "");
    EXPECT_EQ(nearest("", words), "");
    EXPECT_EQ(nearest("spacing", {}), "");
}

TEST(Nearest, CountsASwapOfNeighboursAsOneMistake) {
    EXPECT_EQ(edit_distance("fmp", "fpm"), 1u);
    EXPECT_EQ(edit_distance("spacing", "spaceing"), 1u);
    EXPECT_EQ(edit_distance("disc", "disk"), 1u);
    EXPECT_EQ(edit_distance("", "ball"), 4u);
}

}  // namespace

}  // namespace coronet
