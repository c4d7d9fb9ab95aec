// SPDX-License-Identifier: BSD-3-Clause

// What acts on the boundary of the liquid in the weakly compressible scheme, tension and the mean pressure, and the
// work that is done there and by friction.

#include "coronet/schemes/weakly_compressible.hpp"

namespace coronet {

/// Leaves in Pressure what exceeds the mean of each piece of liquid. With dt > 0 pressure will have gained, before it
/// acts, what continuity between particles makes of it in dt; the mean of that is not known before the sweep that finds
/// it, and that of the last step stands in for it.
template <int D>
void WeaklyCompressible<D>::find_boundary_and_mean_pressure(double dt) {
    boundary_ = find_boundary_(particles_, neighbours_, settings_.surface);
    auto const view = particles_.view();
    double const* const V = view.template at<Volume>();
    double* const p = view.template at<Pressure>();
    auto const volume = boundary_.sums([&](std::size_t i) { return V[i]; });
    mean_pressure_ = boundary_.sums([&](std::size_t i) { return V[i] * p[i]; });
    if (mean_gain_.size() != volume.size()) mean_gain_.assign(volume.size(), 0.0);
    for (std::size_t k = 0; k < volume.size(); ++k)
        mean_pressure_[k] = mean_pressure_[k] / volume[k] + dt * mean_gain_[k];
    for_each(particles_.owned(), [&](std::size_t i) { p[i] -= mean_pressure_[boundary_.piece_of(i)]; });
    neighbours_.images().refresh(particles_, Fields<Pressure>{});
}

/// Before tension and mean pressure act: what remains of the work of the forces between particles is that of pressure,
/// which continuity tells, being dual to it.
template <int D>
void WeaklyCompressible<D>::look_at_dissipation() {
    auto const view = particles_.view();
    dissipation_ = -sum_over(particles_.owned(), 0.0, [&](std::size_t i) {
        auto const a = view.template get<Acceleration>(i) - settings_.gravity;
        double const compressing = view.template at<Pressure>()[i] * view.template at<DensityRate>()[i] /
                                   (view.template at<Density>()[i] * view.template at<Density>()[i]);
        return view.template at<Mass>()[i] * (dot(a, view.template get<Velocity>(i)) + compressing);
    });
}

/// Of tension and friction [W], that of tension at the velocities that accelerations make in dt [s].
template <int D>
Works WeaklyCompressible<D>::rates_of_work(double dt) const {
    auto const view = particles_.view();
    double const shortening = sum_over(particles_.owned(), 0.0, [&](std::size_t i) {
        return dot(boundary_.of_size[i], view.template get<Velocity>(i) + dt * view.template get<Acceleration>(i));
    });
    return {-settings_.surface.tension * shortening, dissipation_};
}

/// Of the content of each piece, at the velocities as they are [m^D/s].
template <int D>
std::vector<double> WeaklyCompressible<D>::content_rates() const {
    return boundary_.sums(
        [&](std::size_t i) { return dot(boundary_.of_content[i], particles_.view().template get<Velocity>(i)); });
}

/// With symplectic steps: the mean pressure of each piece after dt [s], what continuity between particles adds having
/// acted there; and `excess` [m^D/s] so that content and volume part by less than the second order of dt. The content
/// changes, over the step that ended here, by the mean of its rates where that began and ended, and the density follows
/// now; a volume m/rho whose density is advanced at the rate -rho x changes at the rate x + dt x^2 times itself.
template <int D>
void WeaklyCompressible<D>::look_ahead_on_boundary(double dt, std::vector<double> const& volume,
                                                   std::vector<double>& excess) {
    auto const view = particles_.view();
    double const* const V = view.template at<Volume>();
    double const* const rho = view.template at<Density>();
    double const* const c = view.template at<SoundSpeed>();
    double const* const rate = view.template at<DensityRate>();
    if (last_way_.gain.size() == boundary_.pieces) {
        auto const now = content_rates();
        for (std::size_t k = 0; k < boundary_.pieces; ++k)
            excess[k] += 0.5 * (last_way_.gain[k] + last_way_.step * now[k]) / dt - now[k];
    }
    auto const squares = boundary_.sums([&](std::size_t i) {
        std::size_t const k = boundary_.piece_of(i);
        double const x = rate[i] / rho[i] - excess[k] / volume[k];
        return V[i] * x * x;
    });
    auto const unforeseen = boundary_.sums([&](std::size_t i) { return V[i] * view.template at<Pressure>()[i]; });
    auto const stiffness = boundary_.sums([&](std::size_t i) { return V[i] * rho[i] * c[i] * c[i]; });
    for (std::size_t k = 0; k < boundary_.pieces; ++k) {
        excess[k] -= dt * squares[k];
        mean_gain_[k] += unforeseen[k] / (dt * volume[k]);
        mean_pressure_[k] -= dt * (stiffness[k] / volume[k]) * (excess[k] / volume[k]);
    }
}

/// Adds tension and mean pressure there to Acceleration, and to DensityRate what content of the boundary and volume of
/// the particles differ in; pressure and stress are whole again. With dt > 0 the mean pressure is that after dt, too.
template <int D>
void WeaklyCompressible<D>::act_on_boundary(double dt) {
    auto const view = particles_.view();
    double const* const m = view.template at<Mass>();
    double const* const V = view.template at<Volume>();
    double const* const rho = view.template at<Density>();
    double* const rate = view.template at<DensityRate>();
    auto const volume = boundary_.sums([&](std::size_t i) { return V[i]; });
    auto excess = boundary_.sums([&](std::size_t i) {
        return dot(boundary_.of_content[i], view.template get<Velocity>(i)) + V[i] * rate[i] / rho[i];
    });
    if (dt > 0) look_ahead_on_boundary(dt, volume, excess);
    add_tension(particles_, boundary_, settings_.surface.tension);
    for_each(particles_.owned(), [&](std::size_t i) {
        std::size_t const k = boundary_.piece_of(i);
        view.template set<Acceleration>(
            i, view.template get<Acceleration>(i) + (mean_pressure_[k] / m[i]) * boundary_.of_content[i]);
        view.template at<Pressure>()[i] += mean_pressure_[k];
        if (particles_.template has<Stress>()) {
            auto sigma = view.template get<Stress>(i);
            unrolled<D>([&](int a) { sigma(a, a) -= mean_pressure_[k]; });
            view.template set<Stress>(i, sigma);
        }
        rate[i] -= rho[i] * excess[k] / volume[k];
    });
}

template void WeaklyCompressible<2>::find_boundary_and_mean_pressure(double);
template void WeaklyCompressible<3>::find_boundary_and_mean_pressure(double);
template void WeaklyCompressible<2>::look_at_dissipation();
template void WeaklyCompressible<3>::look_at_dissipation();
template std::vector<double> WeaklyCompressible<2>::content_rates() const;
template std::vector<double> WeaklyCompressible<3>::content_rates() const;
template Works WeaklyCompressible<2>::rates_of_work(double) const;
template Works WeaklyCompressible<3>::rates_of_work(double) const;
template void WeaklyCompressible<2>::look_ahead_on_boundary(double, std::vector<double> const&, std::vector<double>&);
template void WeaklyCompressible<3>::look_ahead_on_boundary(double, std::vector<double> const&, std::vector<double>&);
template void WeaklyCompressible<2>::act_on_boundary(double);
template void WeaklyCompressible<3>::act_on_boundary(double);

}  // namespace coronet
