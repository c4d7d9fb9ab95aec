// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/shifting.hpp"

#include <cmath>
#include <type_traits>

#include "coronet/pairs/sweep.hpp"
#include "coronet/schemes/laws.hpp"
#include "coronet/terms/concentration_shift.hpp"
#include "coronet/terms/distance_shift.hpp"
#include "coronet/terms/gradient_correction.hpp"

namespace coronet {

namespace {

/// How the sweep ends at a particle: it is moved, and its velocity and density with it.
template <class Term>
struct ShiftClose {
    Term term;
    double scale, most;  ///< K alpha and alpha/2 [m]

    template <class At, class Sums>
    CORONET_HD void operator()(At const& at, Sums const& sums) const {
        using R = typename At::Number;
        constexpr int D = At::dimension;
        Vector<R, D> d = R(scale) * term.vector(sums);
        if constexpr (Term::respects_surface) {
            auto const n = at.template get<NearestNormal>();
            R const out = dot(d, n);
            d = d - select(at.template get<Surface>() > R(0), out, largest(out, R(0))) * n;
        }
        // Without the sums of the kernel itself, this is the inverse of the slope moments.
        GradientCorrection<R, D> const correction(R(1), Vector<R, D>{}, Vector<R, D>{}, sums.G1);
        R const length = square_root(norm2(d));
        d = (select(length > R(most), R(most) / length, R(1)) * (R(1) - correction.fell_back)) * d;

        auto const grad_v = correction.gradient(sums.v_slope, Vector<R, D>{});
        at.template set<Position>(at.template get<Position>() + d);
        at.template set<Velocity>(at.template get<Velocity>() + grad_v * d);
        at.template set<Density>(at.template get<Density>() + dot(correction.gradient(sums.rho_slope, R(0)), d));
    }
};

}  // namespace

template <int D>
void Shifting<D>::advance(Particles<D>& particles, Neighbours<D> const& neighbours, double step) {
    auto const view = particles.view();
    std::size_t const n = particles.owned();
    auto const mean = (1 / static_cast<double>(n)) *
                      sum_over(n, Vector<double, D>{}, [&](std::size_t i) { return view.template get<Velocity>(i); });
    double const speed =
        std::sqrt(max_over(n, 0, [&](std::size_t i) { return norm2(view.template get<Velocity>(i) - mean); }));
    double const alpha = speed * step;
    if (alpha == 0) return;
    auto const shift_by = [&](auto const& term) {
        using Term = std::decay_t<decltype(term)>;
        sweep(particles, neighbours, kernel_, precision_,
              Part{neighbours.all(), ShiftAndGradients<Term>{{}, {}, {}, term},
                   ShiftClose<Term>{term, settings_.coefficient * alpha, 0.5 * alpha}});
    };
    if (settings_.vector == ShiftVector::sun) {
        look_at_surface(particles, neighbours);
        shift_by(ConcentrationShift{kernel_.support, kernel_(settings_.spacing * settings_.spacing).W});
    } else {
        shift_by(settings_.vector == ShiftVector::xu ? DistanceShift::xu(kernel_.support)
                                                     : DistanceShift::jahanbakhsh(settings_.spacing));
    }
}

/// Sets Surface and NearestNormal.
template <int D>
void Shifting<D>::look_at_surface(Particles<D>& particles, Neighbours<D> const& neighbours) {
    if (listing_seen_ == neighbours.listings()) return;
    listing_seen_ = neighbours.listings();
    find_surface(particles, neighbours, settings_.surface);
    particles.allocate(Fields<NearestNormal>{});
    auto const view = particles.view();
    for_each(particles.size(), [&](std::size_t i) {
        auto const x = view.template get<Position>(i);
        auto normal = view.template get<SurfaceNormal>(i);
        double nearest = view.template at<Surface>()[i] > 0 ? 0 : neighbours.support() * neighbours.support();
        for (Index const place : neighbours.row(i)) {
            auto const j = static_cast<std::size_t>(place);
            if (view.template at<Surface>()[j] == 0) continue;
            double const r2 = norm2(view.template get<Position>(j) - x);
            if (r2 >= nearest) continue;
            nearest = r2;
            normal = view.template get<SurfaceNormal>(j);
        }
        view.template set<NearestNormal>(i, normal);
    });
}

template class Shifting<2>;
template class Shifting<3>;

}  // namespace coronet
