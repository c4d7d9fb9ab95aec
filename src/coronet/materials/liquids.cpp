// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/materials/liquids.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace coronet {

namespace {

using Model = Rheology::Model;

/// Human blood at 37 degrees C and a usual share of cells.
Liquid blood(Rheology rheology) {
    rheology.viscosity = 0.0035;       // at high shear rates: Hund, Kameneva and Antaki, Fluids 2 (2017) 10
    return {.density = 1060,           // Kenner, Basic Res. Cardiol. 84 (1989) 111
            .surface_tension = 0.056,  // Hrncir and Rosina, Physiol. Res. 46 (1997) 319
            .rheology = rheology};
}

Liquid water(double temperature) {
    Rheology rheology;
    rheology.viscosity = water_viscosity(temperature);
    return {water_density(temperature), water_surface_tension(temperature), rheology};
}

Liquid glycerol_water(double mass_fraction, double temperature) {
    Liquid mixture;
    mixture.density = glycerol_water_density(mass_fraction, temperature);
    mixture.rheology.viscosity = glycerol_water_viscosity(mass_fraction, temperature);
    return mixture;
}

}  // namespace

double water_density(double T) {
    double const above =
        999.83952 +
        T * (16.945176 + T * (-7.9870401e-3 + T * (-46.170461e-6 + T * (105.56302e-9 - T * 280.54253e-12))));
    return above / (1 + 16.879850e-3 * T);
}

double water_viscosity(double T) {
    double const t = (T + 273.15) / 300;
    return 1e-6 * (280.68 * std::pow(t, -1.9) + 511.45 * std::pow(t, -7.7) + 61.131 * std::pow(t, -19.6) +
                   0.45903 * std::pow(t, -40));
}

double water_surface_tension(double T) {
    double const below_critical = 1 - (T + 273.15) / 647.096;
    return 0.2358 * std::pow(below_critical, 1.256) * (1 - 0.625 * below_critical);
}

double glycerol_water_density(double w, double T) {
    double const water = 1000 * (1 - std::pow(std::fabs(T - 3.98) / 615, 1.71)), glycerol = 1273.3 - 0.6121 * T;
    double const unmixed = 1 / ((1 - w) / water + w / glycerol);
    double const contraction = 1.41e-2 + T * (-1.82e-4 + T * 1.78e-6);
    double const angle = std::numbers::pi * std::pow(w, 1.31);  // sin(pi) is not quite 0, and may be negative
    return unmixed * (1 + contraction * std::pow(std::fabs(std::sin(angle)), 0.81));
}

double glycerol_water_viscosity(double w, double T) {
    double const water = 1.790e-3 * std::exp((-1230 - T) * T / (36100 + 360 * T));
    double const glycerol = 12.1 * std::exp((-1233 + T) * T / (9900 + 70 * T));
    double const a = 0.705 - 0.0017 * T, b = (4.9 + 0.036 * T) * std::pow(a, 2.5);
    double const share = 1 - w + a * b * w * (1 - w) / (a * w + b * (1 - w));
    return std::pow(water, share) * std::pow(glycerol, 1 - share);
}

std::vector<std::string> const& liquid_names() {
    static std::vector<std::string> const names{"water",        "glycerol-water",       "blood-newtonian",
                                                "blood-casson", "blood-carreau-yasuda", "blood-cross"};
    return names;
}

Liquid liquid(std::string const& name, double temperature, double glycerol_mass_fraction) {
    if (name == "water") return water(temperature);
    if (name == "glycerol-water") return glycerol_water(glycerol_mass_fraction, temperature);
    if (name == "blood-newtonian") return blood({});
    if (name == "blood-casson")  // Merrill et al., Biophys. J. 3 (1963) 199: yield stress from 0.004 to 0.01 Pa
        return blood({.model = Model::casson, .yield_stress = 0.005, .plastic_viscosity = 0.0035});
    if (name == "blood-carreau-yasuda")  // Cho and Kensey, Biorheology 28 (1991) 241
        return blood({.model = Model::carreau_yasuda,
                      .power_index = 0.22,
                      .zero_shear_viscosity = 0.056,
                      .infinite_shear_viscosity = 0.00345,
                      .time_constant = 1.902,
                      .yasuda_exponent = 1.25});
    if (name == "blood-cross")  // the same
        return blood({.model = Model::cross,
                      .zero_shear_viscosity = 0.056,
                      .infinite_shear_viscosity = 0.00345,
                      .time_constant = 1.007,
                      .cross_exponent = 1.028});
    throw std::logic_error("there is no liquid " + name);
}

}  // namespace coronet
