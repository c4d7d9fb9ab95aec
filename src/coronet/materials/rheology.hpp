// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Generalised Newtonian liquids: dynamic viscosity mu [Pa s] from the shear rate g = sqrt(2 D:D) [1/s], so that the
// stress in simple shear is mu(g) g [Pa].
//   newtonian         mu
//   power-law         K g^(n-1) with g held between shear_rate_min and shear_rate_max    Ostwald (1925)
//   cross             mu_inf + (mu_0 - mu_inf)/(1 + (lambda g)^m)                        Cross (1965)
//   carreau-yasuda    mu_inf + (mu_0 - mu_inf) (1 + (lambda g)^a)^((n-1)/a)              Yasuda et al. (1981)
//   bingham           mu_p + tau_y (1 - exp(-M g))/g                                     Papanastasiou (1987)
//   herschel-bulkley  K g^(n-1) + tau_y (1 - exp(-M g))/g, the first term bounded as above
//   casson            (sqrt(mu_p) + sqrt(tau_y/g) (1 - exp(-sqrt(M g))))^2, the same factor for roots of stress
// J. Colloid Sci. 20, 417; Rheol. Acta 20, 163; J. Rheol. 31, 385.
// M is the regularisation [s]: the yield stress is there to 1 % at g = 5/M (Casson: 28/M), and far below it the liquid
// creeps with a viscosity of order M tau_y. The root in Casson's exponential keeps that viscosity finite and falling
// with g; with exp(-M g) it would fall to mu_p at rest. Stress rises with g in every model, in Cross's with m > 1 only
// while mu_0/mu_inf <= ((m + 1)/(m - 1))^2. A plain value without memory of its own, fit for a loop over particles.

#include <limits>
#include <string>
#include <vector>

#include "coronet/core/tensor.hpp"

namespace coronet {

struct Rheology {
    enum class Model { newtonian, power_law, cross, carreau_yasuda, bingham, herschel_bulkley, casson };
    static constexpr double unset = std::numeric_limits<double>::quiet_NaN();

    Model model = Model::newtonian;
    double viscosity = unset;                 ///< [Pa s] of a Newtonian liquid
    double consistency = unset;               ///< K [Pa s^n]
    double power_index = unset;               ///< n [-]
    double zero_shear_viscosity = unset;      ///< mu_0 [Pa s]
    double infinite_shear_viscosity = unset;  ///< mu_inf [Pa s]
    double time_constant = unset;             ///< lambda [s]
    double cross_exponent = unset;            ///< m [-]
    double yasuda_exponent = unset;           ///< a [-]
    double yield_stress = unset;              ///< tau_y [Pa]
    double plastic_viscosity = unset;         ///< mu_p [Pa s]
    double regularisation = 100;              ///< M [s]
    double shear_rate_min = 1e-3;             ///< [1/s]
    double shear_rate_max = 1e6;              ///< [1/s]

    /// mu [Pa s] at a shear rate [1/s] of 0 or more.
    CORONET_HD double viscosity_at(double rate) const {
        switch (model) {
            case Model::newtonian: return viscosity;
            case Model::power_law: return power_law(rate);
            case Model::cross:
                return infinite_shear_viscosity + (zero_shear_viscosity - infinite_shear_viscosity) /
                                                      (1 + std::pow(time_constant * rate, cross_exponent));
            case Model::carreau_yasuda:
                return infinite_shear_viscosity + (zero_shear_viscosity - infinite_shear_viscosity) *
                                                      std::pow(1 + std::pow(time_constant * rate, yasuda_exponent),
                                                               (power_index - 1) / yasuda_exponent);
            case Model::bingham: return plastic_viscosity + creep(rate);
            case Model::herschel_bulkley: return power_law(rate) + creep(rate);
            case Model::casson: break;
        }
        double const rising =
            rate > 0 ? -std::expm1(-std::sqrt(regularisation * rate)) / std::sqrt(rate) : std::sqrt(regularisation);
        double const root = std::sqrt(plastic_viscosity) + std::sqrt(yield_stress) * rising;
        return root * root;
    }

    /// mu(g) g [Pa]
    CORONET_HD double stress_at(double rate) const { return viscosity_at(rate) * rate; }

    /// No mu [Pa s] is above it at any shear rate: what limits an explicit time step.
    double largest_viscosity() const;

private:
    CORONET_HD double power_law(double rate) const {
        return consistency * std::pow(smallest(largest(rate, shear_rate_min), shear_rate_max), power_index - 1);
    }
    CORONET_HD double creep(double rate) const {
        return yield_stress * (rate > 0 ? -std::expm1(-regularisation * rate) / rate : regularisation);
    }
};

/// The models' names in cases, in the order of Rheology::Model.
std::vector<std::string> const& rheology_names();
/// The model of that name, which must be one of them.
Rheology::Model rheology_model(std::string const& name);

/// What a model is given by. One list for the keys of cases, for fits and for what is said about them.
struct RheologyParameter {
    std::string name, unit, meaning;
    double Rheology::*value;
    std::vector<Rheology::Model> models;  ///< that have it
    double at_least = -std::numeric_limits<double>::infinity();
    double above = -std::numeric_limits<double>::infinity();
    double at_most = std::numeric_limits<double>::infinity();
    bool physical = true;  ///< of the liquid, so that a fit may find it; else a bound for the numerics

    bool used_by(Rheology::Model model) const;
};
std::vector<RheologyParameter> const& rheology_parameters();

/// The law that the numerics approach: yield stresses at once, power laws without bounds. For shear rates above 0 only.
Rheology without_bounds(Rheology law);

/// sqrt(2 d:d) [1/s] of grad_v(a, b) = dv_a/dx_b, d its symmetric traceless part: the part that the stress 2 mu d sees,
/// so that mu g^2 is what viscosity dissipates. Compression alone, as in sound, leaves viscosity as it is; in a flow
/// without divergence d is D. Exactly 0 in rigid rotation.
template <class R, int D>
CORONET_HD R shear_rate(Matrix<R, D> const& grad_v) {
    R const mean = trace(grad_v) * R(1.0 / D);
    R twice = R(0);
    unrolled<D * D>([&](int ab) {
        int const a = ab / D, b = ab % D;
        R const sum = grad_v(a, b) + grad_v(b, a);
        if (a < b) twice += sum * sum;
        if (a == b) twice += R(2) * (grad_v(a, a) - mean) * (grad_v(a, a) - mean);
    });
    return square_root(twice);
}

}  // namespace coronet
