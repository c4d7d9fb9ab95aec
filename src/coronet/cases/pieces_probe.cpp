// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/pieces_probe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "coronet/cases/nearest_neighbour.hpp"
#include "coronet/cases/totals.hpp"
#include "coronet/surface/detect.hpp"
#include "coronet/surface/pieces.hpp"

namespace coronet {

template <int D>
std::vector<std::string> PiecesProbe<D>::columns() const {
    std::vector<std::string> names{"pieces", "gap", "momentum_drift", "angular_momentum_drift"};
    ledger_.add_columns(names);
    return names;
}

template <int D>
auto PiecesProbe<D>::start_of(Particles<D> const& particles) -> Start {
    auto const total = totals(particles);
    auto const view = particles.view();
    double const lever = sum_over(particles.owned(), 0.0, [&](std::size_t i) {
        return view.template get<Mass>(i) * std::sqrt(norm2(view.template get<Position>(i) - total.centre()) *
                                                      norm2(view.template get<Velocity>(i)));
    });
    return {total.momentum, total.angular_momentum, total.momentum_scale, lever};
}

template <int D>
auto PiecesProbe<D>::look_at(Particles<D> const& particles) const -> Pieces {
    double const radius = case_.surface.coverage_radius * case_.particles.spacing;
    auto points = copy_of_positions(particles);
    Neighbours<D> neighbours(2 * radius, 0);
    neighbours.update(points);
    std::vector<Index> piece(points.owned());
    Pieces found{number_pieces(points, neighbours, 2 * radius, piece)};
    if (found.count < 2) return found;
    mark_surface(points, neighbours, radius);
    auto const view = points.view();
    std::vector<std::size_t> surface;
    for (std::size_t i = 0; i < points.owned(); ++i)
        if (view.template get<Surface>(i) != 0) surface.push_back(i);
    double const nearest2 = min_over(surface.size(), std::numeric_limits<double>::infinity(), [&](std::size_t k) {
        std::size_t const i = surface[k];
        auto const x = view.template get<Position>(i);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t const j : surface)
            if (piece[j] != piece[i]) least = std::min(least, norm2(view.template get<Position>(j) - x));
        return least;
    });
    found.gap = std::sqrt(nearest2) - case_.particles.spacing;
    return found;
}

template <int D>
std::vector<double> PiecesProbe<D>::sample(Snapshot<D> const& now) {
    auto const total = totals(now.particles);
    auto const before = pieces_;
    pieces_ = look_at(now.particles);
    if (!start_) start_ = start_of(now.particles);
    else if (pieces_.count < before.count && !joined_) {
        joined_ = now.time;
        last_gap_ = before.gap;
    }
    auto const drift = [](double change, double scale) { return scale > 0 ? change / scale : 0; };
    double const momentum = drift(std::sqrt(norm2(total.momentum - start_->momentum)), start_->momentum_scale),
                 angular =
                     drift(std::sqrt(norm2(total.angular_momentum - start_->angular_momentum)), start_->angular_scale);
    momentum_drift_ = std::max(momentum_drift_, momentum);
    angular_drift_ = std::max(angular_drift_, angular);
    std::vector<double> row{static_cast<double>(pieces_.count), pieces_.gap, momentum, angular};
    ledger_.sample(now, row);
    return row;
}

template <int D>
std::vector<Measure> PiecesProbe<D>::measures() const {
    if (!start_) return {};
    double const none = std::numeric_limits<double>::quiet_NaN(), dx = case_.particles.spacing;
    std::vector<Measure> measures{
        {"pieces_final", static_cast<double>(pieces_.count), {}, {}, "joined by balls of the coverage radius"},
        {"joins_at", joined_.value_or(none), {}, {}, joined_ ? "the first sample of fewer pieces [s]" : "none joined"},
        {"joining_gap", joined_ ? last_gap_ / dx : none, {}, {}, "in the sample before, in spacings"}};
    auto const add_drift = [&](std::string const& name, double drift, std::string const& over) {
        if (is_free_)
            measures.push_back({name, drift, 0.0, drift, "conservation; largest of all samples, over " + over});
        else measures.push_back({name, drift, {}, {}, "by the outer force, too; largest of all samples, over " + over});
    };
    add_drift("momentum_drift", momentum_drift_, "the first sum m |v|");
    add_drift("angular_momentum_drift", angular_drift_, "the first sum m |x| |v| from the centre of mass");
    ledger_.add_measures(measures);
    return measures;
}

template class PiecesProbe<2>;
template class PiecesProbe<3>;

}  // namespace coronet
