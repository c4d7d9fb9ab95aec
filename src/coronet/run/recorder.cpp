// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/recorder.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>
#include <sys/resource.h>
#include <nlohmann/json.hpp>

#include "coronet/cases/series_columns.hpp"
#include "coronet/cases/totals.hpp"
#include "coronet/core/parallel.hpp"
#include "coronet/io/whole_file.hpp"
#include "coronet/version.hpp"

namespace coronet {

namespace {

/// The fields a reader of a frame looks for, under the names VTK's users would give them.
template <int D>
std::vector<FrameField> frame_fields(Particles<D> const& particles, bool is_newtonian) {
    constexpr std::array shown{Velocity::number, Acceleration::number, Density::number,  Pressure::number,
                               Mass::number,     Volume::number,       Stress::number,   Surface::number,
                               Exterior::number, FellBack::number,     Viscosity::number};
    constexpr std::array names{"velocity", "acceleration", "density",  "pressure",        "mass",     "volume",
                               "stress",   "surface",      "exterior", "singular_matrix", "viscosity"};
    std::size_t const n = particles.end(Role::wall);
    auto const view = particles.view();
    std::vector<FrameField> fields;
    if (n > particles.owned()) {
        fields.push_back({"wall", "-", 1, std::vector<double>(n, 1.0)});
        std::fill_n(fields.back().values.begin(), particles.owned(), 0.0);
    }
    for (std::size_t f = 0; f < shown.size(); ++f) {
        if (!particles.has(shown[f]) || (is_newtonian && shown[f] == Viscosity::number)) continue;
        FieldInfo const& info = field_info[static_cast<std::size_t>(shown[f])];
        // ParaView wants three components of a vector and six of a symmetric tensor, in 2D too.
        int const components = info.rank == Rank::scalar ? 1 : info.rank == Rank::vector ? 3 : 6;
        FrameField field{names[f], std::string(info.unit), components, std::vector<double>(n * components)};
        auto const put = [&](int from, int to) {
            double const* const values = view.first[shown[f]] + static_cast<std::size_t>(from) * view.stride;
            for_each(n, [&](std::size_t i) { field.values[i * components + to] = values[i]; });
        };
        if (info.rank == Rank::scalar) put(0, 0);
        if (info.rank == Rank::vector)
            for (int k = 0; k < D; ++k) put(k, k);
        if (info.rank == Rank::symmetric)
            for (int k = 0; k < Symmetric<double, D>::size; ++k) put(k, D == 2 && k == 2 ? 3 : k);
        fields.push_back(std::move(field));
    }
    return fields;
}

}  // namespace

template <int D>
Recorder<D>::Recorder(Case const& c, std::filesystem::path directory, Scheme<D>& scheme)
    : case_(c),
      directory_(std::move(directory)),
      scheme_(scheme),
      probes_(make_probes<D>(c)),
      change_(std::numeric_limits<double>::infinity()) {
    auto columns = standard_columns(D);
    for (auto const& probe : probes_)
        for (std::string const& name : probe->columns()) columns.push_back(name);
    for (Reading const& reading : scheme.readings()) columns.push_back(reading.name);
    series_.emplace(directory_ / "series.csv", columns);
    if (case_.output.frames) frames_.emplace(directory_);
}

template <int D>
void Recorder<D>::sample(double time, std::int64_t step, double dt) {
    phases_.act("samples", [&] {
        scheme_.refresh();
        arrangement_ = scheme_.arrangement();
        auto const& particles = scheme_.particles();
        auto const sum = totals(particles);
        std::vector<double> row{
            time, static_cast<double>(step), dt, static_cast<double>(particles.owned()), sum.mass, sum.volume};
        auto const vector = [&](Vector<double, D> const& v) { row.insert(row.end(), v.c, v.c + D); };
        vector(sum.momentum);
        row.push_back(sum.angular_momentum[2]);
        if (D == 3) row.insert(row.end(), {sum.angular_momentum[0], sum.angular_momentum[1]});
        vector(sum.centre());
        row.insert(row.end(), {sum.kinetic_energy, arrangement_.smallest_distance / case_.particles.spacing});
        auto const readings = scheme_.readings();
        Snapshot<D> const now(time, particles, case_, readings);
        for (auto& probe : probes_) {
            auto const values = probe->sample(now);
            row.insert(row.end(), values.begin(), values.end());
        }
        for (Reading const& reading : readings) row.push_back(reading.value);
        series_->row(row);
        if (case_.time.settled > 0) {
            std::vector<Profile> all;
            for (auto const& probe : probes_)
                for (Profile& profile : probe->profiles()) all.push_back(std::move(profile));
            change_ = settling_.change(time, all);
        }
    });
}

template <int D>
bool Recorder<D>::settled() const {
    return case_.time.settled > 0 && change_ <= case_.time.settled;
}

/// profiles.csv, where there are any.
template <int D>
void Recorder<D>::write_profiles() const {
    std::string text = "profile,position,computed,reference\n";
    bool any = false;
    for (auto const& probe : probes_)
        for (Profile const& profile : probe->profiles())
            for (std::size_t k = 0; k < profile.computed.size(); ++k, any = true)
                text += fmt::format("{},{},{},{}\n", profile.name, profile.position[k], profile.computed[k],
                                    profile.reference.empty() ? "" : fmt::format("{}", profile.reference[k]));
    if (any) write_whole(directory_ / "profiles.csv", text);
}

template <int D>
void Recorder<D>::frame(double time) {
    if (!frames_) return;
    phases_.act("frames", [&] {
        scheme_.refresh();
        auto const& particles = scheme_.particles();
        auto const view = particles.view();
        std::size_t const n = particles.end(Role::wall);
        Frame frame{time,
                    std::vector<double>(3 * n),
                    {particles.id.begin(), particles.id.begin() + n},
                    frame_fields(particles, case_.fluid.rheology == "newtonian")};
        for_each(n, [&](std::size_t i) {
            for (int k = 0; k < D; ++k) frame.points[3 * i + k] = view.template at<Position>(k)[i];
        });
        frames_->push(std::move(frame));
    });
}

template <int D>
void Recorder<D>::finish_frames() {
    if (frames_) phases_.act("frames", [&] { frames_->drain(); });
}

template <int D>
void Recorder<D>::summary(std::string const& status, std::string const& message, std::int64_t steps,
                          double wall_seconds) {
    auto const& counters = scheme_.counters();
    auto const particles = scheme_.particles().owned();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    auto const peak = static_cast<std::int64_t>(usage.ru_maxrss) * 1024;

    nlohmann::ordered_json json;
    json["case"] = case_.name;
    json["version"] = version;
    json["commit"] = commit();
    json["threads"] = threads();
    json["precision"] = case_.method.precision;
    json["particles"] = particles;
    json["steps"] = steps;
    json["evaluations"] = counters.evaluations;
    json["neighbour_listings"] = counters.listings;
    json["neighbours_mean"] = arrangement_.neighbours_mean;
    json["singular_matrices"] = counters.singular_matrices;
    json["wall_seconds"] = wall_seconds;
    auto& seconds = json["seconds_per_phase"] = nlohmann::ordered_json::object();
    double stepping = 0;
    for (auto const& [name, time] : scheme_.phases().seconds()) {
        seconds[name] = time;
        stepping += time;
    }
    for (auto const& [name, time] : phases_.seconds()) seconds[name] = time;
    json["particle_evaluations_per_second"] =
        stepping > 0 ? static_cast<double>(counters.evaluations) * static_cast<double>(particles) / stepping : 0;
    json["peak_rss_bytes"] = peak;
    json["bytes_per_particle"] = static_cast<double>(peak) / static_cast<double>(particles);
    json["status"] = status;
    if (case_.time.settled > 0) json["profile_change"] = change_;
    if (!message.empty()) json["message"] = message;
    auto& measures = json["measures"] = nlohmann::ordered_json::object();
    for (auto const& probe : probes_)
        for (Measure const& m : probe->measures()) {
            auto& entry = measures[m.name];
            entry["value"] = m.value;
            if (m.reference) entry["reference"] = *m.reference;
            if (m.error) entry["error"] = *m.error;
            if (m.standard_error) entry["standard_error"] = *m.standard_error;
            if (!m.source.empty()) entry["source"] = m.source;
        }
    write_profiles();
    write_whole(directory_ / "summary.json", json.dump(2) + "\n");
}

template class Recorder<2>;
template class Recorder<3>;

}  // namespace coronet
