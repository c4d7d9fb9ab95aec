// SPDX-License-Identifier: BSD-3-Clause

// The liquid of a case: what the file states wins over the flow curve, that over the preset; the case as written holds
// what was found and gives the same liquid again.

#include "coronet/cases/fluid.hpp"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "coronet/cases/read.hpp"
#include "coronet/core/error.hpp"
#include "coronet/materials/liquids.hpp"

namespace coronet {

namespace {

namespace fs = std::filesystem;
using Model = Rheology::Model;

/// A small drop of the liquid that `fluid` describes.
std::string drop_of(std::string const& fluid) {
    return "name = \"drop\"\ndimension = 2\n[[shapes]]\nkind = \"disc\"\nradius = 1.0\n[particles]\nspacing = "
           "0.2\n[time]\n"
           "end = 0.1\n[fluid]\nsound_speed = 14.0\n" +
           fluid;
}

Case case_of(std::string const& fluid) { return read_case(drop_of(fluid), "drop.toml"); }

std::string complaint_of(std::string const& fluid) {
    try {
        case_of(fluid);
        return "";
    } catch (CaseError const& error) {
        return error.what();
    }
}

void expect_same_law(Rheology const& a, Rheology const& b) {
    EXPECT_EQ(a.model, b.model);
    for (RheologyParameter const& parameter : rheology_parameters()) {
        if (!parameter.used_by(a.model)) continue;
        EXPECT_EQ(a.*parameter.value, b.*parameter.value) << parameter.name;
    }
}

TEST(Fluid, IsNewtonianWithoutViscosityUnlessToldOtherwise) {
    Case const c = case_of("density = 1000\n");
    EXPECT_EQ(rheology_of(c).model, Model::newtonian);
    EXPECT_EQ(rheology_of(c).viscosity_at(1), 0);
    EXPECT_EQ(c.fluid.surface_tension, 0);
    EXPECT_EQ(rheology_of(case_of("density = 1000\nviscosity = 0.5\n")).viscosity_at(1), 0.5);
}

TEST(Fluid, HasTheParametersOfItsModel) {
    Rheology const law =
        rheology_of(case_of("density = 1000\nrheology = \"herschel-bulkley\"\nyield_stress = 3\n"
                            "consistency = 2\npower_index = 0.5\nregularisation = 10\n"));
    EXPECT_EQ(law.model, Model::herschel_bulkley);
    EXPECT_NEAR(law.stress_at(4), 3 + 2 * 2, 1e-14);
    EXPECT_EQ(law.regularisation, 10);
    EXPECT_EQ(law.shear_rate_min, Rheology{}.shear_rate_min);
}

TEST(Fluid, AsksForTheKeysOfItsModelAlone) {
    EXPECT_EQ(complaint_of("density = 1000\nrheology = \"casson\"\nyield_stress = 3\n"),
              "drop.toml: fluid.plastic_viscosity is missing: of bingham, casson: viscosity that is left at high shear "
              "rates [Pa s]");
    EXPECT_NE(
        complaint_of("density = 1000\nrheology = \"power-law\"\nconsistency = 3\npower_index = 1\nviscosity = 1\n")
            .find("fluid.viscosity is no key here"),
        std::string::npos);
}

TEST(Preset, FillsWhatTheFileLeavesOpen) {
    for (std::string const& name : liquid_names()) {
        std::string const more = name == "glycerol-water" ? "glycerol_mass_fraction = 0.6\ntemperature = 25\n" : "";
        Case const c = case_of("preset = \"" + name + "\"\n" + more);
        Liquid const known = liquid(name, more.empty() ? 20 : 25, 0.6);
        EXPECT_EQ(c.fluid.density, known.density) << name;
        EXPECT_EQ(c.fluid.surface_tension, name == "glycerol-water" ? 0 : known.surface_tension) << name;
        expect_same_law(rheology_of(c), known.rheology);
    }
}

TEST(Preset, YieldsToWhatTheFileStates) {
    Case const c = case_of("preset = \"blood-casson\"\ndensity = 1050\nyield_stress = 0.01\nsurface_tension = 0\n");
    EXPECT_EQ(c.fluid.density, 1050);
    EXPECT_EQ(c.fluid.surface_tension, 0);
    EXPECT_EQ(rheology_of(c).yield_stress, 0.01);
    EXPECT_EQ(rheology_of(c).plastic_viscosity, 0.0035);
    EXPECT_EQ(case_of("preset = \"water\"\nviscosity = 0\n").fluid.viscosity, 0);
}

TEST(Preset, OfOneModelLendsItsNewtonianViscosityAloneToAnother) {
    EXPECT_EQ(rheology_of(case_of("preset = \"blood-casson\"\nrheology = \"newtonian\"\n")).viscosity_at(1), 0.0035);
    // A Casson liquid's yield stress is not a Bingham liquid's.
    EXPECT_NE(complaint_of("preset = \"blood-casson\"\nrheology = \"bingham\"\nplastic_viscosity = 1\n")
                  .find("fluid.yield_stress is missing"),
              std::string::npos);
}

TEST(Preset, IsWrittenWithTheValuesItGave) {
    for (std::string const fluid :
         {"preset = \"water\"\ntemperature = 35.5\n", "preset = \"glycerol-water\"\nglycerol_mass_fraction = 0.3\n",
          "preset = \"blood-cross\"\ntime_constant = 2\n", "preset = \"blood-casson\"\nrheology = \"newtonian\"\n",
          "preset = \"water\"\nviscosity = 0\n"}) {
        Case const c = case_of(fluid);
        std::string const text = write_case(c);
        EXPECT_EQ(text.find("nan"), std::string::npos) << text;
        expect_same_law(rheology_of(read_case(text, "written")), rheology_of(c));
        EXPECT_EQ(write_case(read_case(text, "written")), text);
        EXPECT_NE(text.find(fmt::format("\ndensity = {}", c.fluid.density)), std::string::npos) << text;
    }
}

class FlowCurveOfACase : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    void write(std::string const& name, std::string const& text) { std::ofstream(folder / name) << text; }
    Case read(std::string const& fluid) {
        return read_case(drop_of("density = 1000\nflow_curve = \"table.csv\"\n" + fluid),
                         (folder / "drop.toml").string());
    }
    std::string complaint(std::string const& table, std::string const& fluid) {
        write("table.csv", table);
        try {
            read(fluid);
            return "";
        } catch (CaseError const& error) {
            std::string text = error.what();
            for (auto at = text.find(folder.string()); at != std::string::npos; at = text.find(folder.string()))
                text.erase(at, folder.string().size() + 1);
            return text;
        }
    }
    /// A Casson liquid whose roots of stress are 2 + 3 sqrt(g).
    std::string casson(bool viscosity) const {
        std::string text = viscosity ? "shear_rate,torque,viscosity\n" : "shear_rate,torque,stress\n";
        for (double const rate : {0.01, 0.1, 1.0, 10.0, 100.0})
            text += fmt::format("{},7,{}\n", rate, std::pow(2 + 3 * std::sqrt(rate), 2) / (viscosity ? rate : 1));
        return text;
    }

    fs::path folder = fs::temp_directory_path() / ("coronet_fluid_test." + std::to_string(getpid()));
};

TEST_F(FlowCurveOfACase, GivesTheParametersThatAreNotStated) {
    for (bool const viscosity : {false, true}) {
        write("table.csv", casson(viscosity));
        Case const c = read("rheology = \"casson\"\nregularisation = 5\n");
        EXPECT_NEAR(rheology_of(c).yield_stress, 4, 1e-6);
        EXPECT_NEAR(rheology_of(c).plastic_viscosity, 9, 1e-6);
        EXPECT_EQ(rheology_of(c).regularisation, 5);
        ASSERT_TRUE(c.flow_curve_fit);
        EXPECT_EQ(c.flow_curve_fit->fitted.size(), 2u);
    }
}

TEST_F(FlowCurveOfACase, WinsOverThePresetAndYieldsToTheFile) {
    write("table.csv", casson(false));
    Case const c = read("preset = \"blood-casson\"\nplastic_viscosity = 9.5\n");
    EXPECT_EQ(rheology_of(c).plastic_viscosity, 9.5);
    EXPECT_NEAR(rheology_of(c).yield_stress, 4, 0.5);
    EXPECT_EQ(c.fluid.surface_tension, 0.056);
}

TEST_F(FlowCurveOfACase, IsLeftWithTheRunThatItGivesTheSameLawAgain) {
    write("table.csv", casson(true));
    Case c = read("rheology = \"casson\"\n");
    write("flow_curve.csv", write_flow_curve(*c.flow_curve_fit));
    c.fluid.flow_curve = "flow_curve.csv";
    Case const again = read_case(write_case(c), (folder / "case.toml").string());
    expect_same_law(rheology_of(again), rheology_of(c));
    EXPECT_TRUE(again.flow_curve_fit->fitted.empty());
    EXPECT_EQ(again.flow_curve_fit->rms_deviation, c.flow_curve_fit->rms_deviation);
    EXPECT_EQ(again.flow_curve_fit->curve.stress, c.flow_curve_fit->curve.stress);
}

TEST_F(FlowCurveOfACase, ThatIsWrongIsToldWhereAndWhatWouldBeRight) {
    std::string const newtonian = "rheology = \"newtonian\"\n",
                      at = "drop.toml: fluid.flow_curve = 'table.csv': table.csv";
    EXPECT_EQ(
        complaint("shear_rate,tau\n1,2\n", newtonian),
        at + ": the columns are shear_rate, tau, but must be shear_rate [1/s] and one of stress [Pa] and viscosity "
             "[Pa s]");
    EXPECT_EQ(
        complaint("shear_rate,stress,viscosity\n1,2,2\n", newtonian),
        at + ": the columns are shear_rate, stress, viscosity, but must be shear_rate [1/s] and one of stress [Pa] "
             "and viscosity [Pa s]");
    EXPECT_EQ(complaint("# t\nshear_rate,stress\n1,2\n0,2\n", newtonian),
              at + ":4: shear_rate is 0, but must be above 0: leave the row away");
    EXPECT_EQ(complaint("shear_rate,stress\n1,-2\n", newtonian),
              at + ":2: stress is -2, but must be above 0: leave the row away");
    EXPECT_EQ(complaint("shear_rate,stress\n1,x\n", newtonian),
              at + ":2: stress is 'x', but must be a finite number such as 1.5e-3");
    EXPECT_EQ(complaint("shear_rate,stress\n1,1\n2,2\n2,3\n", "rheology = \"bingham\"\n"),
              "drop.toml: fluid.flow_curve = 'table.csv': there are 2 different shear rates, but bingham with 2 "
              "parameters to find needs 3 or more");
    EXPECT_NE(complaint("shear_rate,stress\n1,1\n2,32\n4,1024\n", "rheology = \"power-law\"\n")
                  .find("power_index comes out as 5, out of its range"),
              std::string::npos);
}

}  // namespace

}  // namespace coronet
