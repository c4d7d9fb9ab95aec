// SPDX-License-Identifier: BSD-3-Clause

// A fit recovers what a rheometer with 2 % of noise has seen: 60 shear rates from 0.01 to 1000 1/s, even in logarithms.

#include "coronet/materials/flow_curve.hpp"

#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "coronet/core/error.hpp"

namespace coronet {

namespace {

using Model = Rheology::Model;

constexpr int seeds = 20;

std::string name_of(Rheology const& law) { return rheology_names()[static_cast<std::size_t>(law.model)]; }

FlowCurve measured(Rheology const& law, double noise, unsigned seed = 0, int count = 60) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> error(0, 1);
    Rheology const bare = without_bounds(law);
    FlowCurve curve;
    for (int k = 0; k < count; ++k) {
        double const rate = 0.01 * std::pow(1e5, k / (count - 1.0));
        curve.shear_rate.push_back(rate);
        curve.stress.push_back(bare.stress_at(rate) * (1 + noise * error(engine)));
    }
    return curve;
}

/// Liquids whose every parameter shapes the curve over a decade or more, so that it can be told within 5 %.
std::vector<Rheology> liquids() {
    return {{.model = Model::newtonian, .viscosity = 0.0035},
            {.model = Model::power_law, .consistency = 0.017, .power_index = 0.708},
            {.model = Model::cross,
             .zero_shear_viscosity = 5,
             .infinite_shear_viscosity = 0.05,
             .time_constant = 1,
             .cross_exponent = 0.95},
            {.model = Model::bingham, .yield_stress = 5, .plastic_viscosity = 0.1},
            {.model = Model::herschel_bulkley, .consistency = 1, .power_index = 0.6, .yield_stress = 2},
            {.model = Model::herschel_bulkley, .consistency = 0.2, .power_index = 1.3, .yield_stress = 1},
            {.model = Model::casson, .yield_stress = 0.005, .plastic_viscosity = 0.0035}};
}

Rheology const carreau_yasuda{.model = Model::carreau_yasuda,
                              .power_index = 0.3,
                              .zero_shear_viscosity = 5,
                              .infinite_shear_viscosity = 0.05,
                              .time_constant = 3,
                              .yasuda_exponent = 2};

/// The largest relative errors of the fitted parameters over the seeds, in shares of the value (first) and of the
/// standard error that the fit itself gives (second).
std::map<std::string, std::pair<double, double>> errors_of(Rheology const& law, Rheology const& given) {
    std::map<std::string, std::pair<double, double>> worst;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        auto const fit = fit_flow_curve(measured(law, 0.02, seed), given);
        for (auto const& [parameter, standard_error] : fit.fitted) {
            double const error = std::fabs(fit.law.*parameter->value / law.*parameter->value - 1);
            auto& [of_value, of_standard_error] = worst[parameter->name];
            of_value = std::max(of_value, error);
            of_standard_error = std::max(of_standard_error, error / standard_error);
        }
    }
    return worst;
}

TEST(FlowCurve, GivesBackEveryParameterWithinFivePercentWithTwoPercentOfNoise) {
    for (Rheology const& law : liquids())
        for (auto const& [name, worst] : errors_of(law, {.model = law.model}))
            EXPECT_LT(worst.first, 0.05) << name_of(law) << " " << name;
}

TEST(FlowCurve, GivesBackTheParametersOfCarreauWithinFivePercent) {
    // With Yasuda's exponent stated, as it is in Carreau's law.
    for (auto const& [name, worst] : errors_of(carreau_yasuda, {.model = Model::carreau_yasuda, .yasuda_exponent = 2}))
        EXPECT_LT(worst.first, 0.05) << name;
}

TEST(FlowCurve, GivesBackTheFiveParametersOfCarreauAndYasudaWithinWhatNoiseAllows) {
    // Time constant, both exponents and the lower plateau can stand in for each other: no estimate without bias can be
    // nearer than the standard errors that follow from the curvature of the misfit (Cramer and Rao), 6 % for a. The
    // viscosities that they give are known far better than they are.
    double widest = 0;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        auto const fit = fit_flow_curve(measured(carreau_yasuda, 0.02, seed), {.model = Model::carreau_yasuda});
        for (auto const& [parameter, standard_error] : fit.fitted) {
            double const value = carreau_yasuda.*parameter->value;
            EXPECT_LT(std::fabs(std::log(fit.law.*parameter->value / value)), 4 * standard_error) << parameter->name;
            if (parameter->name == "yasuda_exponent") widest = std::max(widest, standard_error);
        }
        for (double const rate : fit.curve.shear_rate)
            EXPECT_NEAR(fit.law.viscosity_at(rate) / carreau_yasuda.viscosity_at(rate), 1, 0.03) << rate;
    }
    EXPECT_GT(widest, 0.05);
}

TEST(FlowCurve, KnowsHowFarItsParametersMayBeOff) {
    // 20 seeds: errors of more than 4 standard errors come once in 800 such tables, of less than 1 everywhere never.
    for (Rheology const& law : liquids())
        for (auto const& [name, worst] : errors_of(law, {.model = law.model})) {
            EXPECT_LT(worst.second, 4) << name_of(law) << " " << name;
            EXPECT_GT(worst.second, 1) << name_of(law) << " " << name;
        }
}

TEST(FlowCurve, WithoutNoiseIsTheLawItself) {
    auto all = liquids();
    all.push_back(carreau_yasuda);
    for (Rheology const& law : all) {
        auto const fit = fit_flow_curve(measured(law, 0), {.model = law.model});
        // The search ends when a step changes the misfit by less than a root of round-off.
        for (auto const& [parameter, standard_error] : fit.fitted)
            EXPECT_NEAR(fit.law.*parameter->value / law.*parameter->value, 1, 1e-5)
                << name_of(law) << " " << parameter->name;
        EXPECT_LT(fit.rms_deviation, 1e-7) << name_of(law);
    }
}

TEST(FlowCurve, ReportsItsDeviations) {
    // Newtonian: the fitted viscosity is the geometric mean of 1, 1, 1 and 1.1^4, which is 1.1.
    FlowCurve const curve{{1, 2, 4, 8}, {1, 2, 4, 8 * std::pow(1.1, 4)}};
    auto const fit = fit_flow_curve(curve, {.model = Model::newtonian});
    double const last = 1.1 / std::pow(1.1, 4) - 1;
    EXPECT_NEAR(fit.law.viscosity, 1.1, 1e-7);
    EXPECT_NEAR(fit.rms_deviation, std::sqrt((3 * 0.01 + last * last) / 4), 1e-7);
    EXPECT_NEAR(fit.largest_deviation, last, 1e-7);
    EXPECT_EQ(fit.largest_at, 8);
    // ln 1.1 and -3 ln 1.1 are left: variance over 4 - 1, over 4 points.
    ASSERT_EQ(fit.fitted.size(), 1u);
    EXPECT_NEAR(fit.fitted[0].relative_error, std::log(1.1) * std::sqrt(12 / 3.0 / 4), 1e-7);
}

TEST(FlowCurve, KeepsWhatIsStatedAndItsBounds) {
    Rheology const law = liquids()[4];
    Rheology given{.model = law.model, .yield_stress = 2, .regularisation = 7, .shear_rate_min = 0.3};
    auto const fit = fit_flow_curve(measured(law, 0), given);
    EXPECT_EQ(fit.law.yield_stress, 2);
    EXPECT_EQ(fit.law.regularisation, 7);  // of the run: the table is compared with the law without
    EXPECT_EQ(fit.law.shear_rate_min, 0.3);
    EXPECT_EQ(fit.fitted.size(), 2u);
    EXPECT_LT(fit.rms_deviation, 1e-7);
    given = fit.law;
    auto const again = fit_flow_curve(fit.curve, given);
    EXPECT_TRUE(again.fitted.empty());
    EXPECT_EQ(again.law.consistency, fit.law.consistency);
    EXPECT_EQ(again.rms_deviation, fit.rms_deviation);
}

TEST(FlowCurve, SaysWhichParameterItCannotDetermine) {
    // All rates are far below 1/lambda: only the upper plateau shows.
    Rheology law = liquids()[2];
    law.time_constant = 1e-9;
    for (auto const& [parameter, standard_error] :
         fit_flow_curve(measured(law, 0.02, 1), {.model = Model::cross}).fitted) {
        if (parameter->name == "zero_shear_viscosity") EXPECT_LT(standard_error, 0.1);
        else EXPECT_GT(standard_error, 1) << parameter->name;
    }
}

TEST(FlowCurve, NeedsMoreShearRatesThanParameters) {
    FlowCurve const curve{{1, 1, 2, 4, 4}, {1, 1.1, 2, 4, 4.1}};  // three rates for three parameters
    EXPECT_THROW(fit_flow_curve(curve, {.model = Model::herschel_bulkley}), CaseError);
    EXPECT_NO_THROW(fit_flow_curve(curve, {.model = Model::bingham}));
}

}  // namespace

}  // namespace coronet
