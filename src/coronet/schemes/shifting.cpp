// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/shifting.hpp"

#include <cmath>
#include <type_traits>

#include "coronet/pairs/sweep.hpp"
#include "coronet/schemes/laws.hpp"
#include "coronet/surface/detect.hpp"
#include "coronet/terms/concentration_shift.hpp"
#include "coronet/terms/distance_shift.hpp"

namespace coronet {

namespace {

/// How the sweep ends at a particle: with the scheme's gradients, and how far the particle is to be moved.
template <class Term, class GradientClose, class HeldOff>
struct ShiftClose {
    Term term;
    double scale, most;  ///< K alpha and alpha/2 [m]
    GradientClose gradients;
    HeldOff held_off;  ///< held_off(at, d): d without what leads into a wall

    template <class At, class Sums>
    void operator()(At const& at, Sums const& sums) const {
        using R = typename At::Number;
        constexpr int D = At::dimension;
        auto const correction = correction_of(at, sums, gradients.kernel_at_zero);
        gradients(at, sums, correction);

        Vector<R, D> d = R(scale) * term.vector(sums);
        if constexpr (Term::respects_surface) {
            auto const n = at.template get<NearestNormal>();
            R const out = dot(d, n);
            d = d - select(at.template get<Surface>() > R(0), out, largest(out, R(0))) * n;
        }
        R const length = square_root(norm2(d));
        d = (select(length > R(most), R(most) / length, R(1)) * (R(1) - correction.fell_back)) * d;
        d = held_off(at, d);
        at.template set<Shift>(d);
        at.template set<VelocityAlongShift>(correction.gradient(sums.v_slope, sums.v_jump) * d);
        at.template set<DensityAlongShift>(dot(correction.gradient(sums.rho_slope, sums.rho_jump), d));
    }
};
template <class Term, class GradientClose, class HeldOff>
ShiftClose(Term, double, double, GradientClose, HeldOff) -> ShiftClose<Term, GradientClose, HeldOff>;

/// The largest speed, from the mean velocity [m/s].
template <int D>
double largest_speed(Particles<D> const& particles) {
    auto const view = particles.view();
    std::size_t const n = particles.owned();
    auto const mean = (1 / static_cast<double>(n)) *
                      sum_over(n, Vector<double, D>{}, [&](std::size_t i) { return view.template get<Velocity>(i); });
    return std::sqrt(max_over(n, 0, [&](std::size_t i) { return norm2(view.template get<Velocity>(i) - mean); }));
}

}  // namespace

template <int D>
template <class GradientClose>
void Shifting<D>::find(Particles<D>& particles, Neighbours<D> const& neighbours, double step, Walls<D> const* walls,
                       GradientClose const& gradients) {
    particles.allocate(Fields<Shift, VelocityAlongShift, DensityAlongShift>{});
    if (!started_) note_volume(particles, neighbours);
    double const alpha = largest_speed(particles) * step;
    auto const held_off = [&](PackOfParticles<D> const& at, Vector<Pack<double>, D> d) {
        if (!walls) return d;
        double lanes[D][pack_size<double>];
        unrolled<D>([&](int k) { store(d[k], lanes[k]); });
        for (int lane = 0; lane < at.count(); ++lane) {
            if (!walls->is_near(at[lane])) continue;
            Vector<double, D> own;
            unrolled<D>([&](int k) { own[k] = lanes[k][lane]; });
            own = walls->held_off(particles, neighbours, at[lane], own, settings_.spacing / 2);
            unrolled<D>([&](int k) { lanes[k][lane] = own[k]; });
        }
        unrolled<D>([&](int k) { d[k] = load(lanes[k]); });
        return d;
    };
    auto const shift_by = [&](auto const& term) {
        using Term = std::decay_t<decltype(term)>;
        sweep(particles, neighbours, kernel_, precision_,
              Part{neighbours.all(), GradientsAndShift<Term>{{}, {}, {}, {}, term},
                   ShiftClose{term, settings_.coefficient * alpha, 0.5 * alpha, gradients, held_off}});
    };
    if (settings_.vector == ShiftVector::sun) {
        look_at_surface(particles, neighbours);
        shift_by(ConcentrationShift{kernel_.support, kernel_(settings_.spacing * settings_.spacing).W});
    } else {
        shift_by(settings_.vector == ShiftVector::xu ? DistanceShift::xu(kernel_.support)
                                                     : DistanceShift::jahanbakhsh(settings_.spacing));
    }
}

template <int D>
void Shifting<D>::apply(Particles<D>& particles) const {
    auto const view = particles.view();
    for_each(particles.owned(), [&](std::size_t i) {
        view.template set<Position>(i, view.template get<Position>(i) + view.template get<Shift>(i));
        view.template set<Velocity>(i, view.template get<Velocity>(i) + view.template get<VelocityAlongShift>(i));
        view.template at<Density>()[i] += view.template at<DensityAlongShift>()[i];
    });
    if (closed_volume_ > 0) hold_volume(particles);
}

namespace {

template <int D>
double volume_of(Particles<D> const& particles) {
    auto const view = particles.view();
    return sum_over(particles.owned(), 0.0,
                    [&](std::size_t i) { return view.template at<Mass>()[i] / view.template at<Density>()[i]; });
}

}  // namespace

template <int D>
void Shifting<D>::note_volume(Particles<D>& particles, Neighbours<D> const& neighbours) {
    started_ = true;
    bool const open = particles.size() == particles.owned();  // neither walls nor periodic boundaries
    if (open || settings_.walls_move) return;
    mark_surface(particles, neighbours, settings_.surface.coverage_radius);
    auto const surface = particles.view().template at<Surface>();
    if (sum_over(particles.owned(), 0.0, [&](std::size_t i) { return surface[i]; }) == 0)
        closed_volume_ = volume_of(particles);
}

template <int D>
void Shifting<D>::hold_volume(Particles<D>& particles) const {
    double const factor = volume_of(particles) / closed_volume_;
    double* const rho = particles.view().template at<Density>();
    for_each(particles.owned(), [&](std::size_t i) { rho[i] *= factor; });
}

/// Sets Surface and NearestNormal.
template <int D>
void Shifting<D>::look_at_surface(Particles<D>& particles, Neighbours<D> const& neighbours) {
    if (listing_seen_ == neighbours.listings()) return;
    listing_seen_ = neighbours.listings();
    particles.allocate(Fields<NearestNormal>{});
    if (closed_volume_ > 0) return;  // no particle has been marked, and none will be
    find_surface(particles, neighbours, settings_.surface);
    neighbours.images().refresh(particles, Fields<SurfaceNormal>{});
    auto const view = particles.view();
    for_each(particles.owned(), [&](std::size_t i) {
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

#define CORONET_FIND(D, Close) \
    template void Shifting<D>::find(Particles<D>&, Neighbours<D> const&, double, Walls<D> const*, Close const&)
CORONET_FIND(2, NoGradients);
CORONET_FIND(2, CorrectedClose);
CORONET_FIND(2, CorrectionClose);
CORONET_FIND(3, NoGradients);
CORONET_FIND(3, CorrectedClose);
CORONET_FIND(3, CorrectionClose);
#undef CORONET_FIND

template class Shifting<2>;
template class Shifting<3>;

}  // namespace coronet
