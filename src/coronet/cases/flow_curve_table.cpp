// SPDX-License-Identifier: BSD-3-Clause

// From the table that a case names to the parameters of its rheology, and the table that a run leaves.

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coronet/cases/fluid.hpp"
#include "coronet/core/error.hpp"
#include "coronet/io/csv.hpp"

namespace coronet {

FlowCurve read_flow_curve(std::filesystem::path const& file) {
    Csv const table = read_csv(file);
    auto const column = [&](std::string const& name) {
        return static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), name) -
                                        table.columns.begin());
    };
    std::size_t const none = table.columns.size(), rate = column("shear_rate"), stress = column("stress"),
                      viscosity = column("viscosity");
    if (rate == none || (stress == none) == (viscosity == none))
        throw CaseError(
            fmt::format("{}: the columns are {}, but must be shear_rate [1/s] and one of stress [Pa] and "
                        "viscosity [Pa s]",
                        file.string(), fmt::join(table.columns, ", ")));
    FlowCurve curve;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        auto const value = [&](std::size_t at) {
            if (!(table.rows[k][at] > 0))
                throw CaseError(fmt::format("{}:{}: {} is {}, but must be above 0: leave the row away", file.string(),
                                            table.lines[k], table.columns[at], table.rows[k][at]));
            return table.rows[k][at];
        };
        curve.shear_rate.push_back(value(rate));
        curve.stress.push_back(stress != none ? value(stress) : value(viscosity) * value(rate));
    }
    return curve;
}

void fit_rheology(Case& c, std::string const& file) try {
    auto const table = std::filesystem::path(file).parent_path() / c.fluid.flow_curve;
    FlowCurveFit const fit = fit_flow_curve(read_flow_curve(table), rheology_of(c));
    for (auto const& [parameter, error] : fit.fitted) {
        double const value = fit.law.*parameter->value;
        c.fluid.*parameter->value = value;
        if (!(value > parameter->above && value <= parameter->at_most))
            throw CaseError(fmt::format(
                "{} comes out as {:.3g}{}, out of its range: the table does not look like {}; take another model or "
                "state fluid.{}",
                parameter->name, value, parameter->unit == "-" ? "" : " " + parameter->unit, c.fluid.rheology,
                parameter->name));
    }
    c.flow_curve_fit = fit;
} catch (CaseError const& error) {
    throw CaseError(fmt::format("{}: fluid.flow_curve = '{}': {}", file, c.fluid.flow_curve, error.what()));
}

std::string write_flow_curve(FlowCurveFit const& fit) {
    Rheology const bare = without_bounds(fit.law);
    std::string text = "shear_rate,stress,fit,as_run\n";
    for (std::size_t k = 0; k < fit.curve.stress.size(); ++k) {
        double const rate = fit.curve.shear_rate[k];
        text += fmt::format("{},{},{},{}\n", rate, fit.curve.stress[k], bare.stress_at(rate), fit.law.stress_at(rate));
    }
    return text;
}

}  // namespace coronet
