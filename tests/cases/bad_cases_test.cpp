// SPDX-License-Identifier: BSD-3-Clause

// Wrong cases and what is said about them. Each file of tests/cases/bad begins with comments: `# expect: ` and a
// part of a line of the message, one for each line it must have; `# line: ` and a line of the file that the
// message must point at.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "coronet/cases/read.hpp"
#include "coronet/core/error.hpp"

namespace coronet {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> bad_files() {
    std::vector<std::string> names;
    for (auto const& entry : fs::directory_iterator(CORONET_SOURCE "/tests/cases/bad"))
        names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> lines_of(std::string const& text) {
    std::vector<std::string> lines;
    std::stringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> comments(std::string const& text, std::string const& mark) {
    std::vector<std::string> found;
    for (std::string const& line : lines_of(text))
        if (line.starts_with(mark)) found.push_back(line.substr(mark.size()));
    return found;
}

/// What is said about a case; empty if nothing is wrong.
std::string complaint(std::string const& text, std::string const& file, std::vector<std::string> const& settings = {}) {
    try {
        read_case(text, file, settings);
        return "";
    } catch (CaseError const& error) {
        return error.what();
    }
}

class BadCase : public testing::TestWithParam<std::string> {};

TEST_P(BadCase, IsRefusedWithAllThatIsWrongAndWhere) {
    std::string const file = GetParam() + ".toml";
    std::ifstream stream(CORONET_SOURCE "/tests/cases/bad/" + file);
    std::string const text{std::istreambuf_iterator<char>(stream), {}};
    auto const expected = comments(text, "# expect: ");
    ASSERT_FALSE(expected.empty()) << file << " does not say what to expect";

    std::string const message = complaint(text, file);
    auto const lines = lines_of(message);
    for (std::string const& part : expected)
        EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                                [&](std::string const& line) { return line.find(part) != std::string::npos; }))
            << "expected: " << part << "\nfound: " << message;
    EXPECT_EQ(lines.size(), expected.size()) << message;
    for (std::string const& line : lines) EXPECT_TRUE(line.starts_with(file + ":")) << line;

    std::vector<std::string> places;
    for (std::string const& line : lines)
        if (std::isdigit(static_cast<unsigned char>(line[file.size() + 1])))
            places.push_back(line.substr(file.size() + 1, line.find(':', file.size() + 1) - file.size() - 1));
    auto wanted = comments(text, "# line: ");
    std::sort(places.begin(), places.end());
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(places, wanted) << message;
}

INSTANTIATE_TEST_SUITE_P(Of, BadCase, testing::ValuesIn(bad_files()), [](auto const& test) { return test.param; });

/// Valid as it stands: line 6 holds the radius.
std::string const drop = R"(name = "drop"
dimension = 2

[[shapes]]
kind = "disc"
radius = 1.0

[particles]
spacing = 0.2

[fluid]
density = 1000.0
sound_speed = 14.0

[time]
end = 0.1
)";

std::string complaint_about(std::string const& setting) { return complaint(drop, "drop.toml", {setting}); }

TEST(Override, ReplacesAValueOfTheFile) {
    EXPECT_EQ(read_case(drop, "drop.toml").fluid.density, 1000);
    EXPECT_EQ(read_case(drop, "drop.toml", {"fluid.density=998"}).fluid.density, 998);
}

TEST(Override, TakesABareWordAsAString) {
    EXPECT_EQ(read_case(drop, "drop.toml", {"method.gradient=sph"}).method.gradient, "sph");
    EXPECT_EQ(read_case(drop, "drop.toml", {"method.gradient=\"sph\""}).method.gradient, "sph");
    EXPECT_EQ(read_case(drop, "drop.toml", {"title=two words"}).title, "two words");
    EXPECT_EQ(read_case(drop, "drop.toml", {"initial.pressure=2*x + 1"}).initial.pressure, "2*x + 1");
}

TEST(Override, TakesNumbersFlagsAndLists) {
    auto const c = read_case(drop, "drop.toml",
                             {"time.end=2e-3", "output.frames=false", "fluid.gravity=[0, -9.81]",
                              "initial.velocity=[\"y\", 1]", "parameters.rate=3"});
    EXPECT_EQ(c.time.end, 2e-3);
    EXPECT_FALSE(c.output.frames);
    EXPECT_EQ(c.fluid.gravity, (std::vector<double>{0, -9.81}));
    EXPECT_EQ(c.initial.velocity, (std::vector<std::string>{"y", "1"}));
    EXPECT_EQ(c.parameters.at("rate"), 3);
}

TEST(Override, ReachesIntoListsOfTables) {
    EXPECT_EQ(read_case(drop, "drop.toml", {"shapes.0.radius=2"}).shapes[0].radius, 2);
    auto const c = read_case(drop, "drop.toml",
                             {"probes=[{kind=\"angular-momentum\"}]", "shapes.0.centre=[1, 2]", "shapes.0.centre.1=3"});
    EXPECT_EQ(c.probes.at(0).kind, "angular-momentum");
    EXPECT_EQ(c.shapes[0].centre, (std::vector<double>{1, 3}));
    EXPECT_TRUE(read_case(drop, "drop.toml", {"probes=[{kind=\"angular-momentum\"}]", "probes=[]"}).probes.empty());
}

TEST(Override, TheLastOfTheSameKeyCounts) {
    EXPECT_EQ(read_case(drop, "drop.toml", {"time.end=1", "time.end=2"}).time.end, 2);
}

TEST(Override, OfAnUnknownKeyIsNamedWithTheNearestKey) {
    EXPECT_EQ(complaint_about("fluid.desity=1"),
              "--set fluid.desity: fluid.desity is no key here; did you mean fluid.density?");
    EXPECT_EQ(complaint_about("fluids.density=1"), "--set fluids.density: fluids is no key here; did you mean fluid?");
    EXPECT_EQ(complaint_about("shapes.0.size=1"),
              "--set shapes.0.size: shapes.0.size is no key here; shapes.0 has kind, centre, radius, rotation, cuts");
}

TEST(Override, ThatIsWrongIsNamedAndNotALineOfTheFile) {
    EXPECT_EQ(complaint_about("particles.spacing=-1"),
              "--set particles.spacing: particles.spacing is -1, but must be a finite number [m], above 0");
    EXPECT_EQ(complaint_about("particles.spacing=1e"),
              "--set particles.spacing: particles.spacing is the string '1e', but must be a number [m], above 0");
    EXPECT_EQ(complaint_about("shapes.0.radius=0"),
              "--set shapes.0.radius: shapes.0.radius is 0, but must be a finite number [m], above 0");
    EXPECT_EQ(complaint_about("fluid.gravity=[0, inf]"),
              "--set fluid.gravity: fluid.gravity is inf, but must be a finite number [m/s^2]");
}

TEST(Override, WithoutAKeyAValueOrAPlaceIsRefused) {
    EXPECT_EQ(complaint_about("time.end"), "--set time.end: must have the form path.to.key=value");
    EXPECT_EQ(complaint_about("=1"), "--set =1: must have the form path.to.key=value");
    EXPECT_EQ(complaint_about("time..end=1"), "--set time..end=1: time..end has an empty part");
    EXPECT_EQ(complaint_about("time.=1"), "--set time.=1: time. has an empty part");
    EXPECT_EQ(complaint_about("time.end=1\nname=\"x\""), "--set time.end=1\nname=\"x\": must set one value");
    EXPECT_EQ(complaint_about("shapes.1.radius=1"),
              "--set shapes.1.radius=1: shapes.1 is not a table or a list's item in this case");
    EXPECT_EQ(complaint_about("shapes.99999999999999999999.radius=1"),
              "--set shapes.99999999999999999999.radius=1: shapes.99999999999999999999 is not a table or a list's "
              "item in "
              "this case");
    EXPECT_EQ(complaint_about("shapes.3=1"), "--set shapes.3=1: there is no item 3 in that list");
    EXPECT_EQ(complaint_about("time.end.x=1"),
              "--set time.end.x=1: time.end is not a table or a list's item in this case");
}

TEST(Override, AndFileAreBlamedTogether) {
    std::string text = drop;
    text.replace(text.find("1.0"), 3, "-1.0");
    auto const lines = lines_of(complaint(text, "drop.toml", {"time.end=0", "method.kernel=gauss"}));
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0], "drop.toml:6: shapes.0.radius is -1.0, but must be a finite number [m], above 0");
    EXPECT_TRUE(
        lines[1].starts_with("--set method.kernel: method.kernel is the string 'gauss', but must be one of quintic"));
    EXPECT_EQ(lines[2], "--set time.end: time.end is 0, but must be a finite number [s], above 0");
}

TEST(LoadCase, ThatDoesNotExistNamesTheNearestBuiltInCase) {
    try {
        load_case("drop-streching");
        FAIL() << "a case that does not exist was loaded";
    } catch (CaseError const& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean drop-stretching?"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("square-patch"), std::string::npos) << error.what();
    }
    EXPECT_THROW(load_case("/"), CaseError);
}

TEST(BadCases, AreMany) { EXPECT_GE(bad_files().size(), 24u); }

}  // namespace

}  // namespace coronet
