// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/fluid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coronet/materials/liquids.hpp"

namespace coronet {

namespace {

/// The models in words, since some parameters belong to several.
std::string of_models(RheologyParameter const& parameter) {
    std::vector<std::string> names;
    for (Rheology::Model const model : parameter.models)
        names.push_back(rheology_names()[static_cast<std::size_t>(model)]);
    return fmt::format("of {}: {}", fmt::join(names, ", "), parameter.meaning);
}

void fill(double& value, double standard) {
    if (std::isnan(value)) value = standard;
}

/// What the preset tells of the liquid; nothing without one.
Liquid describe_preset(Keys& keys, Case& c) {
    auto& f = c.fluid;
    Keys::Words names = liquid_names();
    names.insert(names.begin(), "none");
    keys.choice({.path = "fluid.preset",
                 .meaning = "a liquid whose properties are known; what the file states of them itself wins"},
                f.preset, names);
    auto const wants = [&](std::string const& preset) { return keys.everything() || f.preset == preset; };
    if (wants("glycerol-water"))
        keys.number({.path = "fluid.glycerol_mass_fraction",
                     .unit = "-",
                     .meaning = "of the preset glycerol-water",
                     .at_least = 0,
                     .at_most = 1,
                     .required = true},
                    f.glycerol_mass_fraction);
    if (wants("water") || wants("glycerol-water"))
        keys.number({.path = "fluid.temperature",
                     .unit = "degrees C",
                     .meaning = "of the presets water and glycerol-water",
                     .at_least = 0,
                     .at_most = 100},
                    f.temperature);
    return f.preset == "none" ? Liquid{} : liquid(f.preset, f.temperature, f.glycerol_mass_fraction);
}

/// The model, and the parameters that it has. Those of a preset hold for the model of the preset only, but for its
/// Newtonian viscosity; those of the liquid need not be stated where a flow curve is there to find them.
void describe_rheology(Keys& keys, Case& c, Rheology const& preset) {
    auto& f = c.fluid;
    if (f.rheology.empty()) f.rheology = rheology_names()[static_cast<std::size_t>(preset.model)];
    keys.choice({.path = "fluid.rheology", .meaning = "how stress follows from shear rate"}, f.rheology,
                rheology_names());
    keys.text({.path = "fluid.flow_curve",
               .meaning = "a table (CSV) of shear_rate [1/s] with stress [Pa] or viscosity [Pa s], its path from the "
                          "case's folder: parameters of the model that are not stated are fitted to it"},
              f.flow_curve);
    auto const model = rheology_model(f.rheology);
    for (RheologyParameter const& parameter : rheology_parameters()) {
        if (!keys.everything() && !parameter.used_by(model)) continue;
        double& value = f.*parameter.value;
        bool const fitted = parameter.physical && !f.flow_curve.empty();
        bool const newtonian = parameter.value == &Rheology::viscosity;
        if (!fitted && (newtonian || model == preset.model)) fill(value, preset.*parameter.value);
        if (!fitted && newtonian && c.flow.reynolds > 0)
            fill(value, f.density * c.flow.speed * c.flow.length / c.flow.reynolds);
        if (!fitted && newtonian) fill(value, 0);
        keys.number({.path = "fluid." + parameter.name,
                     .unit = parameter.unit,
                     .meaning = of_models(parameter),
                     .at_least = parameter.at_least,
                     .above = parameter.above,
                     .at_most = parameter.at_most,
                     .required = !fitted && std::isnan(value)},
                    value);
    }
}

}  // namespace

namespace {

/// What is stated of the flow instead of the viscosity of a Newtonian liquid.
void describe_flow(Keys& keys, Case& c) {
    keys.number({.path = "flow.reynolds",
                 .unit = "-",
                 .meaning = "density times speed times length over viscosity: where it is above 0 and the viscosity of "
                            "a Newtonian liquid is not stated, it follows from this",
                 .at_least = 0},
                c.flow.reynolds);
    keys.number({.path = "flow.speed", .unit = "m/s", .meaning = "of the Reynolds number", .above = 0}, c.flow.speed);
    keys.number({.path = "flow.length", .unit = "m", .meaning = "of the Reynolds number", .above = 0}, c.flow.length);
}

}  // namespace

void describe_fluid(Keys& keys, Case& c) {
    describe_flow(keys, c);
    auto& f = c.fluid;
    Liquid const preset = describe_preset(keys, c);
    fill(f.density, preset.density);
    keys.number({.path = "fluid.density",
                 .unit = "kg/m^3",
                 .meaning = "density at zero pressure",
                 .above = 0,
                 .required = f.preset == "none" && std::isnan(f.density)},
                f.density);
    fill(f.surface_tension, std::isnan(preset.surface_tension) ? 0 : preset.surface_tension);
    keys.number({.path = "fluid.surface_tension", .unit = "N/m", .meaning = "against the gas around", .at_least = 0},
                f.surface_tension);
    describe_rheology(keys, c, preset.rheology);
    bool const needs_sound = c.method.scheme == "weakly-compressible" || any_reads<SoundSpeed>(c.method.pair_terms);
    Key sound{.path = "fluid.sound_speed",
              .unit = "m/s",
              .meaning =
                  "of the weakly compressible liquid: 10 times the largest speed keeps density within 1 %; an "
                  "incompressible one needs it for artificial viscosity alone",
              .required = needs_sound || keys.everything()};
    (sound.required ? sound.above : sound.at_least) = 0;
    keys.number(sound, f.sound_speed);
    keys.choice(
        {.path = "fluid.equation_of_state", .meaning = "linear: c^2 (rho - rho0); tait: rho0 c^2/n ((rho/rho0)^n - 1)"},
        f.equation_of_state, {"linear", "tait"});
    keys.number(
        {.path = "fluid.tait_exponent", .unit = "-", .meaning = "n of the Tait equation", .at_least = 1, .at_most = 20},
        f.tait_exponent);
    if (f.gravity.empty()) f.gravity.assign(static_cast<std::size_t>(c.dimension), 0.0);
    keys.numbers({.path = "fluid.gravity", .unit = "m/s^2", .meaning = "gravitational acceleration"}, f.gravity,
                 c.dimension);
    if (f.body_force.empty()) f.body_force.assign(static_cast<std::size_t>(c.dimension), "0");
    keys.formulas({.path = "fluid.body_force", .unit = "m/s^2", .meaning = "further force per mass"}, f.body_force,
                  c.dimension);
}

Rheology rheology_of(Case const& c) {
    Rheology law = c.fluid;
    law.model = rheology_model(c.fluid.rheology);
    return law;
}

}  // namespace coronet
