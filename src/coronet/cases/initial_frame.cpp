// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/initial_frame.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coronet/cases/frame_flow.hpp"
#include "coronet/cases/wall_check.hpp"
#include "coronet/cases/wall_fill.hpp"
#include "coronet/core/error.hpp"

namespace coronet {

namespace {

constexpr double most_beyond = 0.1;

/// The particles of liquid, with the wanted fields as far as they are there.
Frame liquid_of(Frame const& frame) {
    auto const* wall = field_of(frame, "wall");
    Frame liquid{.time = frame.time, .points = {}, .ids = {}, .fields = {}};
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < frame.ids.size(); ++i)
        if (!wall || wall->values[i] == 0) which.push_back(i);
    auto const pick = [&](auto const& from, auto& to, std::size_t components) {
        for (std::size_t const i : which)
            for (std::size_t k = 0; k < components; ++k) to.push_back(from[i * components + k]);
    };
    pick(frame.points, liquid.points, 3);
    pick(frame.ids, liquid.ids, 1);
    for (char const* const name : {"pressure", "velocity", "volume"})
        if (auto const* field = field_of(frame, name)) {
            liquid.fields.push_back({field->name, field->unit, field->components, {}});
            pick(field->values, liquid.fields.back().values, static_cast<std::size_t>(field->components));
        }
    return liquid;
}

/// Throws CaseError where the liquid is none that the case could start from.
void check_liquid(Frame const& liquid, Case const& c) {
    if (liquid.ids.empty()) throw CaseError("it holds no liquid");
    auto const expect = [&](std::string const& name, int components) {
        auto const* field = field_of(liquid, name);
        if (!field) throw CaseError(fmt::format("it has no field '{}': take a frame that a run has written", name));
        if (field->components != components)
            throw CaseError(fmt::format("its '{}' has {} components, not {}", name, field->components, components));
    };
    expect("velocity", 3);
    expect("volume", 1);
    if (c.method.scheme == "weakly-compressible") expect("pressure", 1);

    auto const finite = [](std::vector<double> const& values) {
        return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    };
    auto const& volume = field_of(liquid, "volume")->values;
    bool sound = finite(liquid.points) && *std::min_element(volume.begin(), volume.end()) > 0;
    for (auto const& field : liquid.fields) sound = sound && finite(field.values);
    if (!sound)
        throw CaseError("it holds numbers that are not finite, or a volume that is not above 0: take an earlier frame");

    bool flat = true;
    for (std::size_t i = 0; i < liquid.ids.size(); ++i) flat = flat && liquid.points[3 * i + 2] == 0;
    if (flat != (c.dimension == 2))
        throw CaseError(
            fmt::format("it is of a run in {} dimensions, and the case is in {}", flat ? 2 : 3, c.dimension));
}

}  // namespace

void read_initial_frame(Case& c, std::string const& file) try {
    auto const path = std::filesystem::path(file).parent_path() / c.initial.from;
    auto liquid = liquid_of(read_frame(path));
    check_liquid(liquid, c);
    c.initial.frame = std::make_shared<Frame const>(std::move(liquid));
} catch (CaseError const& error) {
    throw CaseError(fmt::format("{}: initial.from = '{}': {}", file, c.initial.from, error.what()));
}

template <int D>
void check_initial_frame(Case const& c, std::size_t beyond, std::size_t particles, std::vector<std::string>& errors) {
    Frame const& frame = *c.initial.frame;
    auto const box = periodic_box<D>(c);
    double const slack = spacing_of(frame, D);
    for (int k = 0; k < D; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (std::size_t i = 0; i < frame.ids.size(); ++i) {
            low = std::min(low, frame.points[3 * i + k]);
            high = std::max(high, frame.points[3 * i + k]);
        }
        if (box.periodic[k] && (low < box.low[k] - slack || high > box.low[k] + box.size[k] + slack))
            say(errors,
                "initial.from = '{}' has liquid from {:.4g} to {:.4g} m along {}, beyond the periodic box of {:.4g} to "
                "{:.4g} m: take a frame of the same domain",
                c.initial.from, low, high, "xyz"[k], box.low[k], box.low[k] + box.size[k]);
    }
    if (static_cast<double>(beyond) > most_beyond * static_cast<double>(particles))
        say(errors,
            "initial.from = '{}' has no liquid within {:.4g} m, {} of its spacings, of {} of the {} particles; at most "
            "{:.0f} % may take the values of the nearest: do both have the same place and unit?",
            c.initial.from, FrameFlow<D>::radius_in_spacings * slack, FrameFlow<D>::radius_in_spacings, beyond,
            particles, 100 * most_beyond);
}

template void check_initial_frame<2>(Case const&, std::size_t, std::size_t, std::vector<std::string>&);
template void check_initial_frame<3>(Case const&, std::size_t, std::size_t, std::vector<std::string>&);

}  // namespace coronet
