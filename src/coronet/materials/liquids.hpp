// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Liquids by name, at atmospheric pressure, with what has been published about them. Sources stand beside the numbers
// in liquids.cpp. What is not known is not a number.

#include <string>
#include <vector>

#include "coronet/materials/rheology.hpp"

namespace coronet {

struct Liquid {
    double density = Rheology::unset;          ///< [kg/m^3]
    double surface_tension = Rheology::unset;  ///< against air [N/m]
    Rheology rheology;                         ///< with a Newtonian viscosity beside the law's own parameters
};

/// The names that `liquid` knows.
std::vector<std::string> const& liquid_names();

/// Temperature from 0 to 100 degrees C, for water and glycerol-water; blood is at 37. Throws std::logic_error for
/// another name.
Liquid liquid(std::string const& name, double temperature, double glycerol_mass_fraction);

/// Kell, J. Chem. Eng. Data 20 (1975) 97: density [kg/m^3] of water without air.
double water_density(double temperature);
/// IAPWS SR6-08, after Patek et al., J. Phys. Chem. Ref. Data 38 (2009) 21: viscosity [Pa s].
double water_viscosity(double temperature);
/// IAPWS R1-76: surface tension [N/m] against its vapour.
double water_surface_tension(double temperature);
/// Volk and Kaehler, Exp. Fluids 59 (2018) 75, measured from 15 to 30 degrees C: density [kg/m^3].
double glycerol_water_density(double mass_fraction, double temperature);
/// Cheng, Ind. Eng. Chem. Res. 47 (2008) 3285, from 0 to 100 degrees C: viscosity [Pa s].
double glycerol_water_viscosity(double mass_fraction, double temperature);

}  // namespace coronet
