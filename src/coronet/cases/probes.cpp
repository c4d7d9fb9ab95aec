// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "coronet/cases/cavity_probe.hpp"
#include "coronet/cases/channel_probe.hpp"
#include "coronet/cases/column_probe.hpp"
#include "coronet/cases/dam_break_probe.hpp"
#include "coronet/cases/drag_probe.hpp"
#include "coronet/cases/drop_probe.hpp"
#include "coronet/cases/formula.hpp"
#include "coronet/cases/hydrostatic_probe.hpp"
#include "coronet/cases/impact_probe.hpp"
#include "coronet/cases/mode_probe.hpp"
#include "coronet/cases/patch_probe.hpp"
#include "coronet/cases/pieces_probe.hpp"
#include "coronet/cases/point_value.hpp"
#include "coronet/cases/probe.hpp"
#include "coronet/cases/static_drop_probe.hpp"
#include "coronet/cases/stretching_drop.hpp"
#include "coronet/cases/taylor_green_probe.hpp"
#include "coronet/cases/totals.hpp"
#include "coronet/cases/wall_force_probe.hpp"

namespace coronet {

namespace {

constexpr char axis_name[] = {'x', 'y', 'z'};

template <int D>
Vector<double, D> constants(std::vector<std::string> const& texts, Case const& c) {
    Vector<double, D> values;
    for (int k = 0; k < D; ++k) values[k] = Formula(texts[k], c.parameters)(Vector<double, D>{}, 0);
    return values;
}

/// Pressure, density or speed at a point.
template <int D>
class ValueProbe final : public Probe<D> {
public:
    ValueProbe(ProbeKeys const& keys, Case const& c) : keys_(keys), kernel_(probe_kernel<D>(c)) {
        for (int k = 0; k < D; ++k) at_[k] = keys.at[k];
    }
    std::vector<std::string> columns() const override { return {keys_.name}; }
    std::vector<double> sample(Snapshot<D> const& now) override {
        auto const view = now.particles.view();
        return {value_at(now.particles, kernel_, at_, [&](std::size_t i) {
            if (keys_.field == "pressure") return view.template get<Pressure>(i);
            if (keys_.field == "density") return view.template get<Density>(i);
            return std::sqrt(norm2(view.template get<Velocity>(i)));
        })};
    }

private:
    ProbeKeys keys_;
    Kernel kernel_;
    Vector<double, D> at_;
};

/// How far the angular momentum has drifted from its first value; in 3D by the length of the difference.
template <int D>
class AngularMomentumProbe final : public Probe<D> {
public:
    explicit AngularMomentumProbe(Case const& c) : free_(no_outer_force(c)) {}
    std::vector<std::string> columns() const override { return {"angular_momentum_drift"}; }
    std::vector<double> sample(Snapshot<D> const& now) override {
        auto const momentum = totals(now.particles).angular_momentum;
        if (!first_) first_ = momentum;
        double const scale = std::sqrt(norm2(*first_));
        drift_ = scale > 0 ? std::sqrt(norm2(momentum - *first_)) / scale : 0;  // nothing to drift from
        return {drift_};
    }
    std::vector<Measure> measures() const override {
        if (!free_) return {{"angular_momentum_drift", drift_, {}, {}, "relative change, by the outer force too"}};
        return {{"angular_momentum_drift", drift_, 0.0, drift_, "conservation; relative to the first value"}};
    }

private:
    bool free_;
    std::optional<Vector<double, 3>> first_;
    double drift_ = 0;
};

/// Semi-axes and centre pressure of a stretching drop, beside the exact ones (stretching_drop.hpp). A semi-axis is
/// measured by the second moment of mass, s_k = sqrt((D + 2) sum m (x_k - centre_k)^2 / sum m), which is a_k for a
/// uniform ellipsoid; the exact one is that of the first sample, carried along by the exact flow.
template <int D>
class StretchingProbe final : public Probe<D> {
public:
    StretchingProbe(ProbeKeys const& keys, Case const& c)
        : first_axes_(constants<D>(keys.semi_axes, c)),
          exact_(first_axes_, constants<D>(keys.rates, c), c.fluid.density),
          kernel_(probe_kernel<D>(c)),
          pressure_scale_(exact_.centre_pressure()) {}

    std::vector<std::string> columns() const override {
        std::vector<std::string> names;
        for (std::string const prefix : {"", "exact_"}) {
            for (int k = 0; k < D; ++k) names.push_back(prefix + "semi_axis_" + axis_name[k]);
            names.push_back(prefix + "centre_pressure");
        }
        return names;
    }

    std::vector<double> sample(Snapshot<D> const& now) override {
        auto const& particles = now.particles;
        auto const view = particles.view();
        auto const total = totals(particles);
        auto const centre = total.centre();
        auto const moments = sum_over(particles.owned(), Vector<double, D>{}, [&](std::size_t i) {
            auto x = view.template get<Position>(i) - centre;
            for (int k = 0; k < D; ++k) x[k] *= view.template get<Mass>(i) * x[k];
            return x;
        });
        Vector<double, D> s;
        for (int k = 0; k < D; ++k) s[k] = std::sqrt((D + 2) * moments[k] / total.mass);
        if (samples_ == 0) first_s_ = s;
        exact_.advance_to(now.time);

        double const p =
            value_at(particles, kernel_, centre, [&](std::size_t i) { return view.template get<Pressure>(i); });
        std::vector<double> row(s.c, s.c + D);
        row.push_back(p);
        for (int k = 0; k < D; ++k) {
            double const exact = first_s_[k] * exact_.semi_axes()[k] / first_axes_[k];
            worst_axis_ = std::max(worst_axis_, std::fabs(s[k] / exact - 1));
            row.push_back(exact);
        }
        row.push_back(exact_.centre_pressure());
        sum_p2_ += std::pow((p - exact_.centre_pressure()) / pressure_scale_, 2);
        ++samples_;
        return row;
    }

    std::vector<Measure> measures() const override {
        std::string const source = "exact stretching drop, Fang et al. (2009) Eqs 94-96";
        double const rms = std::sqrt(sum_p2_ / samples_);
        return {{"semi_axis_error_max", worst_axis_, 0.0, worst_axis_, source},
                {"centre_pressure_error_rms", rms, 0.0, rms, source + "; over the exact initial centre pressure"}};
    }

private:
    Vector<double, D> first_axes_;
    StretchingDrop<D> exact_;
    Kernel kernel_;
    double pressure_scale_, worst_axis_ = 0, sum_p2_ = 0;
    Vector<double, D> first_s_;
    int samples_ = 0;
};

}  // namespace

bool no_outer_force(Case const& c) {
    auto const is_zero = [](auto const& component) {
        if constexpr (std::is_same_v<std::decay_t<decltype(component)>, double>) return component == 0;
        else return component == "0";
    };
    return std::all_of(c.fluid.gravity.begin(), c.fluid.gravity.end(), is_zero) &&
           std::all_of(c.fluid.body_force.begin(), c.fluid.body_force.end(), is_zero);
}

template <int D>
std::vector<std::unique_ptr<Probe<D>>> make_probes(Case const& c) {
    std::vector<std::unique_ptr<Probe<D>>> probes;
    for (ProbeKeys const& keys : c.probes) {
        if (keys.kind == "value") probes.push_back(std::make_unique<ValueProbe<D>>(keys, c));
        if (keys.kind == "angular-momentum") probes.push_back(std::make_unique<AngularMomentumProbe<D>>(c));
        if (keys.kind == "stretching") probes.push_back(std::make_unique<StretchingProbe<D>>(keys, c));
        if (keys.kind == "cavity") probes.push_back(std::make_unique<CavityProbe<D>>(keys, c));
        if (keys.kind == "hydrostatic") probes.push_back(std::make_unique<HydrostaticProbe<D>>(keys, c));
        if (keys.kind == "channel") probes.push_back(std::make_unique<ChannelProbe<D>>(keys, c));
        if (keys.kind == "wall-force") probes.push_back(std::make_unique<WallForceProbe<D>>(keys, c));
        if (keys.kind == "sensor") probes.push_back(std::make_unique<SensorProbe<D>>(keys, c));
        if constexpr (D == 3) {
            if (keys.kind == "drag") probes.push_back(std::make_unique<DragProbe>(keys, c));
            if (keys.kind == "column") probes.push_back(std::make_unique<ColumnProbe>(keys, c));
        }
        if (keys.kind == "drop") probes.push_back(std::make_unique<DropProbe<D>>(c));
        if (keys.kind == "mode") probes.push_back(std::make_unique<ModeProbe<D>>(keys, c));
        if (keys.kind == "pieces") probes.push_back(std::make_unique<PiecesProbe<D>>(c));
        if (keys.kind == "static-drop") probes.push_back(std::make_unique<StaticDropProbe<D>>(c));
        if constexpr (D == 2) {
            if (keys.kind == "dam-break") probes.push_back(std::make_unique<DamBreakProbe>(keys, c));
            if (keys.kind == "impact") probes.push_back(std::make_unique<ImpactProbe>(keys, c));
            if (keys.kind == "patch") probes.push_back(std::make_unique<PatchProbe>(keys, c));
            if (keys.kind == "taylor-green") probes.push_back(std::make_unique<TaylorGreenProbe>(keys, c));
        }
    }
    return probes;
}

template std::vector<std::unique_ptr<Probe<2>>> make_probes(Case const&);
template std::vector<std::unique_ptr<Probe<3>>> make_probes(Case const&);

}  // namespace coronet
