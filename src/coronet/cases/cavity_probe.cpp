// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/cavity_probe.hpp"

#include <cmath>
#include <sstream>

#include "coronet/cases/builtin.hpp"
#include "coronet/cases/fluid.hpp"
#include "coronet/cases/formula.hpp"
#include "coronet/cases/point_value.hpp"

namespace coronet {

namespace {

bool is_same(double a, double b) { return std::fabs(a - b) <= 1e-6 * b; }

}  // namespace

std::string cavity_table(int dimension, double reynolds) {
    if (dimension == 2) return "cavity2d_own_reference";
    return is_same(reynolds, 1000) ? "cavity3d_albensoeder_kuhlmann2005" : "cavity3d_own_reference";
}

std::vector<Profile> cavity_reference(int dimension, double reynolds) {
    std::vector<Profile> profiles{{"u", {}, {}, {}}, {"v", {}, {}, {}}};
    for (BuiltinFile const& table : builtin_tables()) {
        if (table.name != cavity_table(dimension, reynolds)) continue;
        std::istringstream lines{std::string(table.text)};
        for (std::string line; std::getline(lines, line);) {
            std::istringstream row(line);
            std::string number, kind, coordinate, value;
            std::getline(row, number, ',') && std::getline(row, kind, ',') && std::getline(row, coordinate, ',') &&
                std::getline(row, value, ',');
            if (kind != "u_vertical" && kind != "v_horizontal") continue;
            if (!is_same(reynolds, std::stod(number))) continue;
            Profile& profile = profiles[kind == "u_vertical" ? 0 : 1];
            profile.position.push_back(std::stod(coordinate));
            profile.reference.push_back(std::stod(value));
        }
    }
    return profiles;
}

template <int D>
CavityProbe<D>::CavityProbe(ProbeKeys const& keys, Case const& c)
    : length_(Formula(keys.side, c.parameters)(Vector<double, D>{}, 0)),
      speed_(Formula(keys.upper_velocity, c.parameters)(Vector<double, D>{}, 0)),
      kernel_(probe_kernel<D>(c)),
      reynolds_(c.fluid.density * speed_ * length_ / c.fluid.viscosity),
      profiles_(cavity_reference(D, reynolds_)) {
    for (Profile& profile : profiles_)
        if (profile.position.empty())  // no table: 33 equal steps of the midline
            for (int k = 1; k < 33; ++k) profile.position.push_back(k / 33.0);
}

template <int D>
std::vector<double> CavityProbe<D>::sample(Snapshot<D> const& now) {
    for (int component = 0; component < 2; ++component) {
        Profile& profile = profiles_[component];
        profile.computed.clear();
        auto const v = now.particles.template get<Velocity>(component);
        for (double const at : profile.position) {
            Vector<double, D> x;
            for (int k = 0; k < D; ++k) x[k] = 0.5 * length_;
            x[1 - component] = at * length_;
            profile.computed.push_back(linear_value_at(now.particles, kernel_, x, [&](std::size_t i) { return v[i]; }) /
                                       speed_);
        }
    }
    return {error(profiles_[0]), error(profiles_[1])};
}

/// Root mean square of the difference, over the speed of the lid; NaN without a reference.
template <int D>
double CavityProbe<D>::error(Profile const& profile) const {
    double sum = 0;
    for (std::size_t k = 0; k < profile.reference.size(); ++k)
        sum += std::pow(profile.computed[k] - profile.reference[k], 2);
    return std::sqrt(sum / static_cast<double>(profile.reference.size()));
}

template <int D>
std::vector<Measure> CavityProbe<D>::measures() const {
    std::vector<Measure> list;
    for (Profile const& profile : profiles_) {
        Measure measure{profile.name + "_error_rms", error(profile), {}, {}, "no table at this Reynolds number"};
        if (!profile.reference.empty()) {
            measure.reference = 0;
            measure.error = measure.value;
            measure.source = "cases/reference/" + cavity_table(D, reynolds_) + ".csv, over the speed of the lid";
        }
        list.push_back(measure);
    }
    return list;
}

template class CavityProbe<2>;
template class CavityProbe<3>;

}  // namespace coronet
