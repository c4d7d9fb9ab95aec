// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/materials/rheology.hpp"

#include <algorithm>
#include <stdexcept>

namespace coronet {

using Model = Rheology::Model;

double Rheology::largest_viscosity() const {
    double const thickest = std::max(power_law(shear_rate_min), power_law(shear_rate_max));
    switch (model) {
        case Model::power_law: return thickest;
        case Model::cross:
        case Model::carreau_yasuda: return std::max(zero_shear_viscosity, infinite_shear_viscosity);
        case Model::herschel_bulkley: return thickest + creep(0);
        default: return viscosity_at(0);
    }
}

std::vector<std::string> const& rheology_names() {
    static std::vector<std::string> const names{"newtonian", "power-law",        "cross", "carreau-yasuda",
                                                "bingham",   "herschel-bulkley", "casson"};
    return names;
}

Model rheology_model(std::string const& name) {
    auto const& names = rheology_names();
    auto const found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::logic_error("there is no rheology " + name);
    return static_cast<Model>(found - names.begin());
}

bool RheologyParameter::used_by(Model model) const {
    return std::find(models.begin(), models.end(), model) != models.end();
}

std::vector<RheologyParameter> const& rheology_parameters() {
    using enum Rheology::Model;
    static std::vector<RheologyParameter> const parameters{
        {.name = "viscosity",
         .unit = "Pa s",
         .meaning = "dynamic viscosity",
         .value = &Rheology::viscosity,
         .models = {newtonian},
         .at_least = 0},
        {.name = "zero_shear_viscosity",
         .unit = "Pa s",
         .meaning = "viscosity at rest",
         .value = &Rheology::zero_shear_viscosity,
         .models = {cross, carreau_yasuda},
         .above = 0},
        {.name = "infinite_shear_viscosity",
         .unit = "Pa s",
         .meaning = "viscosity at high shear rates",
         .value = &Rheology::infinite_shear_viscosity,
         .models = {cross, carreau_yasuda},
         .at_least = 0},
        {.name = "time_constant",
         .unit = "s",
         .meaning = "one over the shear rate at which the viscosity begins to change",
         .value = &Rheology::time_constant,
         .models = {cross, carreau_yasuda},
         .above = 0},
        {.name = "cross_exponent",
         .unit = "-",
         .meaning = "of time_constant times shear rate in Cross's law",
         .value = &Rheology::cross_exponent,
         .models = {cross},
         .above = 0,
         .at_most = 10},
        {.name = "yasuda_exponent",
         .unit = "-",
         .meaning = "of time_constant times shear rate in the law of Carreau and Yasuda; 2 is Carreau's",
         .value = &Rheology::yasuda_exponent,
         .models = {carreau_yasuda},
         .above = 0,
         .at_most = 10},
        {.name = "yield_stress",
         .unit = "Pa",
         .meaning = "stress below which the liquid hardly flows",
         .value = &Rheology::yield_stress,
         .models = {bingham, herschel_bulkley, casson},
         .at_least = 0},
        {.name = "plastic_viscosity",
         .unit = "Pa s",
         .meaning = "viscosity that is left at high shear rates",
         .value = &Rheology::plastic_viscosity,
         .models = {bingham, casson},
         .above = 0},
        {.name = "consistency",
         .unit = "Pa s^n",
         .meaning = "the viscous stress is consistency times shear rate to the power_index",
         .value = &Rheology::consistency,
         .models = {power_law, herschel_bulkley},
         .above = 0},
        {.name = "power_index",
         .unit = "-",
         .meaning = "slope of log stress over log shear rate; below 1 the liquid thins",
         .value = &Rheology::power_index,
         .models = {power_law, carreau_yasuda, herschel_bulkley},
         .above = 0,
         .at_most = 3},
        {.name = "regularisation",
         .unit = "s",
         .meaning = "the yield stress is reached at shear rates above about five over this; a long one limits the step",
         .value = &Rheology::regularisation,
         .models = {bingham, herschel_bulkley, casson},
         .above = 0,
         .physical = false},
        {.name = "shear_rate_min",
         .unit = "1/s",
         .meaning = "below it the viscosity of a power law stays as it is there",
         .value = &Rheology::shear_rate_min,
         .models = {power_law, herschel_bulkley},
         .above = 0,
         .physical = false},
        {.name = "shear_rate_max",
         .unit = "1/s",
         .meaning = "above it the viscosity of a power law stays as it is there",
         .value = &Rheology::shear_rate_max,
         .models = {power_law, herschel_bulkley},
         .above = 0,
         .physical = false}};
    return parameters;
}

Rheology without_bounds(Rheology law) {
    law.regularisation = law.shear_rate_max = std::numeric_limits<double>::infinity();
    law.shear_rate_min = 0;
    return law;
}

}  // namespace coronet
