// SPDX-License-Identifier: BSD-3-Clause

// Every rheology tends to its limits and matches its closed form; regularised laws tend to those they stand for; the
// shear rate is objective.

#include "coronet/materials/rheology.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace coronet {

namespace {

using Model = Rheology::Model;

constexpr double eps = std::numeric_limits<double>::epsilon();

// A power, an exponential or a root passes a few roundings of its argument, times its exponent; all are below 10 here.
constexpr double few = 32 * eps;

std::vector<Rheology> laws() {
    return {{.model = Model::newtonian, .viscosity = 0.7},
            {.model = Model::power_law, .consistency = 2, .power_index = 0.4},
            {.model = Model::power_law, .consistency = 2, .power_index = 1.6},
            {.model = Model::cross,
             .zero_shear_viscosity = 3,
             .infinite_shear_viscosity = 0.02,
             .time_constant = 5,
             .cross_exponent = 0.8},
            {.model = Model::cross,  // thickens, as in Table 4.3 of Lobo (2011)
             .zero_shear_viscosity = 0.002,
             .infinite_shear_viscosity = 0.004,
             .time_constant = 1,
             .cross_exponent = 2},
            {.model = Model::carreau_yasuda,
             .power_index = 0.3,
             .zero_shear_viscosity = 3,
             .infinite_shear_viscosity = 0.02,
             .time_constant = 5,
             .yasuda_exponent = 1.4},
            {.model = Model::bingham, .yield_stress = 4, .plastic_viscosity = 0.3},
            {.model = Model::herschel_bulkley, .consistency = 2, .power_index = 0.5, .yield_stress = 4},
            {.model = Model::herschel_bulkley, .consistency = 2, .power_index = 1.5, .yield_stress = 4},
            {.model = Model::casson, .yield_stress = 4, .plastic_viscosity = 0.3}};
}

/// From far below every bound to far above.
std::vector<double> rates() {
    std::vector<double> list;
    for (double exponent = -8; exponent <= 10; exponent += 0.125) list.push_back(std::pow(10, exponent));
    return list;
}

double mu(Rheology const& law, double rate) { return law.viscosity_at(rate); }

TEST(Rheology, MatchesClosedFormsWithRootsAlone) {
    // Exponents that need square roots and products only, at lambda g = 4, or g = 4.
    Rheology const power{.model = Model::power_law, .consistency = 3, .power_index = 0.5};
    EXPECT_NEAR(mu(power, 4), 3 / 2.0, few * 1.5);
    Rheology const cross{.model = Model::cross,
                         .zero_shear_viscosity = 7,
                         .infinite_shear_viscosity = 1,
                         .time_constant = 2,
                         .cross_exponent = 0.5};
    EXPECT_NEAR(mu(cross, 2), 1 + 6 / (1 + 2.0), few * 3);
    Rheology const carreau{.model = Model::carreau_yasuda,
                           .power_index = 0,
                           .zero_shear_viscosity = 7,
                           .infinite_shear_viscosity = 1,
                           .time_constant = 0.5,
                           .yasuda_exponent = 2};
    EXPECT_NEAR(mu(carreau, 2 * std::sqrt(3.0)), 1 + 6 / 2.0, few * 4);  // sqrt(1 + 3) = 2
    Rheology const bingham{.model = Model::bingham, .yield_stress = 8, .plastic_viscosity = 3, .regularisation = 0.25};
    EXPECT_NEAR(mu(bingham, 4), 3 + 2 * 0.6321205588285577, few * 5);  // 1 - 1/e
    Rheology const bulkley{.model = Model::herschel_bulkley,
                           .consistency = 3,
                           .power_index = 0.5,
                           .yield_stress = 8,
                           .regularisation = 0.25};
    EXPECT_NEAR(mu(bulkley, 4), 1.5 + 2 * 0.6321205588285577, few * 3);
    Rheology const casson{.model = Model::casson, .yield_stress = 16, .plastic_viscosity = 9, .regularisation = 0.25};
    EXPECT_NEAR(mu(casson, 4), std::pow(3 + 2 * 0.6321205588285577, 2), few * 20);
    EXPECT_EQ(mu({.model = Model::newtonian, .viscosity = 3}, 4), 3);
}

TEST(Rheology, MatchesItsTextbookFormAtEveryRateBetweenItsBounds) {
    for (Rheology law : laws()) {
        law = without_bounds(law);
        for (double const g : rates()) {
            double const contrast = law.zero_shear_viscosity - law.infinite_shear_viscosity;
            double stress = 0;  // written as stress, as textbooks do, with logarithms for powers
            switch (law.model) {
                case Model::newtonian: stress = law.viscosity * g; break;
                case Model::power_law: stress = law.consistency * std::exp(law.power_index * std::log(g)); break;
                case Model::cross:
                    stress = g * (law.infinite_shear_viscosity +
                                  contrast / (1 + std::exp(law.cross_exponent * std::log(law.time_constant * g))));
                    break;
                case Model::carreau_yasuda: {
                    double const x = std::exp(law.yasuda_exponent * std::log(law.time_constant * g));
                    stress = g * (law.infinite_shear_viscosity +
                                  contrast * std::exp((law.power_index - 1) / law.yasuda_exponent * std::log1p(x)));
                    break;
                }
                case Model::bingham: stress = law.yield_stress + law.plastic_viscosity * g; break;
                case Model::herschel_bulkley:
                    stress = law.yield_stress + law.consistency * std::exp(law.power_index * std::log(g));
                    break;
                case Model::casson:
                    stress = std::pow(std::sqrt(law.yield_stress) + std::sqrt(law.plastic_viscosity * g), 2);
            }
            // A logarithm of up to 25 is rounded, and its exponential passes 25 roundings on; powers of powers twice.
            EXPECT_NEAR(law.stress_at(g), stress, 100 * few * stress)
                << rheology_names()[static_cast<std::size_t>(law.model)] << " at " << g;
        }
    }
}

TEST(Rheology, TendsToItsViscosityAtRest) {
    auto const expect = [](Rheology const& law, double at_rest) {
        EXPECT_NEAR(mu(law, 0), at_rest, few * at_rest);
        EXPECT_NEAR(mu(law, 1e-30), at_rest, 1e-11 * at_rest);  // roots of M g = 1e-28, g^0.8 = 1e-24
    };
    auto const all = laws();
    expect(all[0], 0.7);
    expect(all[1], 2 * std::pow(1e-3, -0.6));
    expect(all[2], 2 * std::pow(1e-3, 0.6));
    expect(all[3], 3);
    expect(all[4], 0.002);
    expect(all[5], 3);
    expect(all[6], 0.3 + 100 * 4);
    expect(all[7], 2 * std::pow(1e-3, -0.5) + 100 * 4);
    expect(all[9], std::pow(std::sqrt(0.3) + std::sqrt(100 * 4.0), 2));
}

TEST(Rheology, TendsToItsViscosityAtHighShearRates) {
    auto const all = laws();
    double const fast = 1e30;
    EXPECT_EQ(mu(all[1], fast), mu(all[1], 1e6));
    EXPECT_NEAR(mu(all[1], fast), 2 * std::pow(1e6, -0.6), few);
    EXPECT_NEAR(mu(all[2], fast), 2 * std::pow(1e6, 0.6), few * 1e4);
    EXPECT_NEAR(mu(all[3], fast), 0.02, few);
    EXPECT_NEAR(mu(all[4], fast), 0.004, few);
    EXPECT_NEAR(mu(all[5], fast), 0.02, few);
    EXPECT_NEAR(mu(all[6], fast), 0.3, few);
    EXPECT_NEAR(mu(all[7], fast), 2e-3, few);
    EXPECT_NEAR(mu(all[9], fast), 0.3, 1e-14);  // sqrt(tau_y/g) = 2e-15
}

TEST(Rheology, HasTheSlopeOfItsPowerIndexBetweenTheLimits) {
    // Carreau-Yasuda and Cross far from both plateaus, mu_inf = 0: the next term is (lambda g)^-a.
    Rheology carreau = laws()[5], cross = laws()[3];
    carreau.infinite_shear_viscosity = cross.infinite_shear_viscosity = 0;
    auto const slope = [](Rheology const& law, double g) {
        return std::log(law.stress_at(2 * g) / law.stress_at(g)) / std::log(2.0);
    };
    EXPECT_NEAR(slope(carreau, 1e8), 0.3, 1e-10);
    EXPECT_NEAR(slope(cross, 1e20), 1 - 0.8, 1e-10);
}

TEST(Rheology, OfCrossIsThatOfTheThesisWhoseNormIsSmallerByTheRootOfTwo) {
    // Lobo (2011) 3.17 has C |D|^a, |D| = g/sqrt 2: lambda = C^(1/a)/sqrt 2. Table 4.3 has C = a = 2, so lambda = 1.
    auto const law = laws()[4];
    for (double const g : rates()) {
        double const norm = g / std::sqrt(2.0);
        EXPECT_NEAR(mu(law, g), 0.004 + (0.002 - 0.004) / (1 + 2 * norm * norm), few * 0.004);
    }
}

TEST(Rheology, RegularisedIsThatWithAYieldStressAboveAFewInverseTimes) {
    for (Rheology const& law : laws()) {
        if (!(law.yield_stress > 0)) continue;
        Rheology const bare = without_bounds(law);
        // Papanastasiou's factor lacks exp(-M g) of the yield stress; Casson's twice exp(-sqrt(M g)) of its root.
        for (double const g : {0.05, 0.1, 1.0, 100.0}) {
            double const M = law.regularisation;
            double const lack = law.model == Model::casson
                                    ? 2 * std::exp(-std::sqrt(M * g)) * (law.yield_stress + std::sqrt(4 * 0.3 * g))
                                    : std::exp(-M * g) * law.yield_stress;
            EXPECT_LE(law.stress_at(g), bare.stress_at(g) * (1 + few));
            EXPECT_GE(law.stress_at(g), bare.stress_at(g) * (1 - few) - lack);
        }
        Rheology sharper = law;  // a longer regularisation comes nearer, with the same law above
        sharper.regularisation *= 10;
        EXPECT_GT(sharper.stress_at(0.01), law.stress_at(0.01));
        EXPECT_LT(sharper.stress_at(0.01), bare.stress_at(0.01));
    }
}

TEST(Rheology, StressRisesWithTheShearRateAndViscosityStaysBelowItsBound) {
    for (Rheology const& law : laws()) {
        std::string const name = rheology_names()[static_cast<std::size_t>(law.model)];
        double stress = 0, most = law.viscosity_at(0);
        EXPECT_EQ(law.stress_at(0), 0);
        for (double const g : rates()) {
            EXPECT_GT(law.stress_at(g), stress) << name << " at " << g;
            stress = law.stress_at(g);
            most = std::max(most, law.viscosity_at(g));
            EXPECT_GT(law.viscosity_at(g), 0) << name;
        }
        EXPECT_LE(most, law.largest_viscosity() * (1 + few)) << name;
        EXPECT_GE(most, 0.8 * law.largest_viscosity()) << name;  // and the bound is not idle
    }
}

TEST(Rheology, OfAYieldStressThinsAtEveryRate) {
    for (Rheology const& law : laws()) {
        if (law.model != Model::bingham && law.model != Model::casson) continue;
        double before = law.viscosity_at(0);
        for (double const g : rates()) {
            EXPECT_LE(law.viscosity_at(g), before * (1 + few)) << g;
            before = law.viscosity_at(g);
        }
    }
}

TEST(Rheology, OfCrossLosesItsRisingStressBeyondTheStatedContrast) {
    double const m = 3, most = std::pow((m + 1) / (m - 1), 2);  // 4
    for (double const share : {0.99, 1.01}) {
        Rheology const law{.model = Model::cross,
                           .zero_shear_viscosity = share * most,
                           .infinite_shear_viscosity = 1,
                           .time_constant = 1,
                           .cross_exponent = m};
        bool falls = false;
        for (double g = 0.5; g < 3; g += 0.01) falls = falls || law.stress_at(g + 0.01) < law.stress_at(g);
        EXPECT_EQ(falls, share > 1);
    }
}

TEST(RheologyParameters, AreSetForEveryModelAndNoOthers) {
    for (Rheology const& law : laws())
        for (RheologyParameter const& parameter : rheology_parameters()) {
            if (!parameter.physical) continue;
            EXPECT_EQ(parameter.used_by(law.model), !std::isnan(law.*parameter.value)) << parameter.name;
        }
    EXPECT_EQ(rheology_model("casson"), Model::casson);
    EXPECT_EQ(rheology_model("newtonian"), Model::newtonian);
}

template <int D>
Matrix<double, D> random_matrix(std::mt19937& engine) {
    std::uniform_real_distribution<double> entry(-1, 1);
    Matrix<double, D> a;
    for (double& c : a.c) c = entry(engine);
    return a;
}

template <class Check>
void in_two_and_three_dimensions(Check const& check) {
    std::mt19937 engine(1);
    for (int sample = 0; sample < 100; ++sample) {
        check.template operator()<2>(engine);
        check.template operator()<3>(engine);
    }
}

TEST(ShearRate, OfRigidRotationIsZero) {
    in_two_and_three_dimensions([]<int D>(std::mt19937& engine) {
        auto const a = random_matrix<D>(engine);
        EXPECT_EQ(shear_rate(1e6 * (a - transpose(a))), 0);
    });
}

TEST(ShearRate, OfSimpleShearIsItsRateWhateverTurnsWithIt) {
    in_two_and_three_dimensions([]<int D>(std::mt19937& engine) {
        Matrix<double, D> shear;
        shear(0, D - 1) = -0.7;
        EXPECT_NEAR(shear_rate(shear), 0.7, few);
        auto const a = random_matrix<D>(engine);
        EXPECT_NEAR(shear_rate(shear + (a - transpose(a))), 0.7, few * 4);
    });
}

TEST(ShearRate, OfStretchingIsTheRootOfTwiceTheSumOfSquares) {
    EXPECT_NEAR(shear_rate(Matrix<double, 2>{{0.7, 0, 0, -0.7}}), 1.4, few);
    EXPECT_NEAR(shear_rate(Matrix<double, 3>{{0.7, 0, 0, 0, -0.35, 0, 0, 0, -0.35}}), 0.7 * std::sqrt(3.0), few);
}

TEST(ShearRate, OfUniformExpansionIsZero) {
    EXPECT_NEAR(shear_rate(0.7 * identity<double, 2>()), 0, few);
    EXPECT_NEAR(shear_rate(0.7 * identity<double, 3>()), 0, few);
}

TEST(ShearRate, IsTheSameInAnyFrame) {
    // Seen by an observer turned by a reflection Q = I - 2 n n^T, of any direction.
    in_two_and_three_dimensions([]<int D>(std::mt19937& engine) {
        Vector<double, D> n;
        for (int k = 0; k < D; ++k) n[k] = random_matrix<D>(engine)[k];
        auto const Q = identity<double, D>() - (2 / norm2(n)) * outer(n, n);
        auto const a = random_matrix<D>(engine);
        auto const turned = product<double, D>(product<double, D>(Q, a), Q);
        EXPECT_NEAR(shear_rate(turned), shear_rate(a), 16 * D * eps * std::sqrt(norm2(a)));
    });
}

TEST(ShearRate, SquaredTimesViscosityIsWhatViscosityDissipates) {
    in_two_and_three_dimensions([]<int D>(std::mt19937& engine) {
        auto const a = random_matrix<D>(engine);
        double power = 0;  // 2 d : grad v, with d written out
        for (int k = 0; k < D; ++k)
            for (int l = 0; l < D; ++l) power += (a(k, l) + a(l, k) - (k == l ? 2 * trace(a) / D : 0)) * a(k, l);
        EXPECT_NEAR(std::pow(shear_rate(a), 2), power, 16 * D * D * eps * norm2(a));
    });
}

}  // namespace

}  // namespace coronet
