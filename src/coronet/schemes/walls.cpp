// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/walls.hpp"

#include <algorithm>
#include <cmath>

#include "coronet/pairs/close.hpp"
#include "coronet/pairs/sweep.hpp"
#include "coronet/schemes/laws.hpp"
#include "coronet/terms/gradient_correction.hpp"

namespace coronet {

namespace {

// A mean over less than this share of a full support is none: rounding would show.
constexpr double least_kernel_sum = 1e-6;

template <int D>
bool is_wall(Particles<D> const& particles, std::size_t i) {
    Role const role = particles.role(i);
    return role == Role::wall || role == Role::wall_image;
}

}  // namespace

template <int D>
void Walls<D>::move(Particles<D>& particles, PeriodicBox<D> const& box, double time) {
    auto const view = particles.view();
    std::size_t const begin = particles.begin(Role::wall), end = particles.end(Role::wall);
    if (begin == end) return;
    for_each(end - begin, [&](std::size_t k) { view.template set<Acceleration>(begin + k, settings_.gravity); });
    if (settings_.motion) settings_.motion(time, particles);
    if (settings_.body_force) settings_.body_force(time, view, begin, end);
    if (wall_of_.empty()) find_mirrors(particles);
    std::size_t const first = particles.begin(Role::mirror);
    for_each(wall_of_.size(), [&](std::size_t k) {
        auto const x = view.template get<Position>(wall_of_[k]) + view.template get<ToMirror>(wall_of_[k]);
        view.template set<Position>(first + k, x + box.shift_into(x));
    });
}

template <int D>
void Walls<D>::find_mirrors(Particles<D> const& particles) {
    std::size_t const count = particles.count(Role::wall), wall = particles.begin(Role::wall),
                      mirror = particles.begin(Role::mirror);
    std::vector<std::size_t> place(count);
    for (std::size_t k = 0; k < count; ++k) place[static_cast<std::size_t>(particles.id[wall + k]) - wall] = wall + k;
    wall_of_.resize(count);
    for (std::size_t k = 0; k < count; ++k)
        wall_of_[k] = place[static_cast<std::size_t>(particles.id[mirror + k]) - mirror];
}

template <int D>
void Walls<D>::follow(Particles<D> const& particles, Neighbours<D> const& neighbours) {
    if (particles.count(Role::wall) == 0) return;
    find_mirrors(particles);
    near_wall_.assign(particles.owned(), 0);
    for_each(near_wall_.size(), [&](std::size_t i) {
        for (Index const j : neighbours.row(i))
            if (is_wall(particles, static_cast<std::size_t>(j))) near_wall_[i] = 1;
    });
    near_ = neighbours.targets([&](std::size_t i) { return is_near(i); });
}

template <int D>
Vector<double, D> Walls<D>::held_off(Particles<D> const& particles, Neighbours<D> const& neighbours, std::size_t i,
                                     Vector<double, D> d, double least) const {
    auto const view = particles.view();
    auto const x = view.template get<Position>(i);
    for (Index const place : neighbours.row(i)) {
        auto const j = static_cast<std::size_t>(place);
        if (!is_wall(particles, j)) continue;
        auto const to_mirror = view.template get<ToMirror>(j), from = x - view.template get<Position>(j);
        double const depth = 0.5 * std::sqrt(norm2(to_mirror));
        auto const n = (0.5 / depth) * to_mirror;
        double const above = dot(from, n), aside2 = norm2(from) - above * above;
        if (above <= 0 || aside2 > 4 * least * least) continue;
        double const room = std::max(above - depth - least, 0.0), in = -dot(d, n);
        if (in > room) d += (in - room) * n;
    }
    return d;
}

template <int D>
void Walls<D>::add_to_density_rate(Particles<D>& particles, Neighbours<D> const& neighbours) {
    if (near_.blocks() == 0) return;
    auto const view = particles.view();
    contact_.resize(particles.owned());
    auto const close = [&](std::size_t i, auto const& sums) {
        view.template at<DensityRate>()[i] += sums.drho;
        contact_[i] = sums.dv;
    };
    WallContact const contact{settings_.contact_range, settings_.equation_of_state.c};
    // In full: with mixed precision velocities would be relative to a frame that the walls' own are not.
    sweep(particles, neighbours, settings_.kernel, Precision::full,
          Part{near_, WallCorrections{{}, contact}, OneByOne{close}});
}

template <int D>
void Walls<D>::add_contact(Particles<D>& particles) const {
    auto const view = particles.view();
    for_each(contact_.size(), [&](std::size_t i) {
        if (is_near(i)) view.template set<Acceleration>(i, view.template get<Acceleration>(i) + contact_[i]);
    });
}

template <int D>
void Walls<D>::look_at_liquid(Particles<D>& particles, Neighbours<D> const& neighbours) const {
    if (wall_of_.empty()) return;
    auto const view = particles.view();
    std::size_t const first = particles.begin(Role::mirror);
    EquationOfState const eos = settings_.equation_of_state;
    bool const corrected = particles.template has<CorrectedStress>(), stressed = particles.template has<Stress>(),
               kept = particles.template has<SlopeCorrection>();
    auto const close = [&](std::size_t i, auto const& sums) {
        std::size_t const w = wall_of_[i - first];
        auto const v_wall = view.template get<WallVelocity>(w), to_mirror = view.template get<ToMirror>(w);
        Vector<double, D> v = v_wall;
        Matrix<double, D> grad_v;
        double p = 0;
        if (sums.W0 > least_kernel_sum) {
            auto const n = (1 / std::sqrt(norm2(to_mirror))) * to_mirror;
            auto const to_centre = (1 / sums.W0) * sums.W1;  // of the liquid, from the mirror
            GradientCorrection<double, D> const correction(sums.W0, sums.W1, sums.G0, sums.G1);
            v = (1 / sums.W0) * sums.v_jump;
            if (correction.fell_back == 0) {
                grad_v = correction.gradient(sums.v_slope, sums.v_jump);
                v = v - grad_v * to_centre;
            }
            // Both ways the wall particle's own gradient follows from that of the liquid, with R = I - 2 n n^T:
            // no slip v(x) = 2 v_wall - v'(R x), slip v(x) = R v'(R x).
            auto const reflected = [&](Vector<double, D> const& u) { return u - 2 * dot(n, u) * n; };
            auto const mirrored = grad_v - 2 * outer(grad_v * n, n);
            if (view.template get<Slip>(w) == 0) {
                v = 2 * v_wall - v;
                grad_v = -1 * mirrored;
            } else {
                v = v_wall + reflected(v - v_wall);
                grad_v = mirrored - 2 * outer(n, transpose(mirrored) * n);
            }
            p = sums.p_jump / sums.W0 - eos.rho0 * dot(view.template get<Acceleration>(w), to_mirror + to_centre);
        }
        double const rho = eos.density(p), V = view.template get<Mass>(w) / eos.rho0;  // a solid is not compressed
        view.template set<Velocity>(w, v);
        view.template set<Pressure>(w, p);
        view.template set<Density>(w, rho);
        view.template set<Volume>(w, V);
        view.template set<SoundSpeed>(w, eos.sound_speed(rho));
        if (!settings_.liquid.is_newtonian()) view.template set<Viscosity>(w, settings_.liquid.viscosity(grad_v));
        if (kept) {
            view.template set<SlopeCorrection>(w, (1 / settings_.lattice_slope_moment) * identity<double, D>());
            view.template set<ValueCorrection>(w, {});
        }
        if (!stressed) return;
        // Viscosity acts between velocities here; stress is left with the pressure.
        auto const sigma = Newtonian{0.0}.stress(p, grad_v);
        view.template set<Stress>(w, sigma);
        if (!corrected) return;
        view.template set<CorrectedStress>(
            w, (V / settings_.lattice_slope_moment) * product<double, D>(sigma, identity<double, D>()));
        view.template set<StressOffset>(w, {});
    };
    sweep(particles, neighbours, settings_.kernel, settings_.precision,
          Part{neighbours.mirrors(), MirrorSums{}, OneByOne{close}});
}

template class Walls<2>;
template class Walls<3>;

}  // namespace coronet
