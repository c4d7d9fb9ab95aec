// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Particle shifting, in any scheme's step: particles leave the paths of the flow by a little, so that they stay evenly
// spread, and take the values that the flow has where they come to (Jahanbakhsh et al. 2012, section VI, steps 4-6):
//     x += d,   v += d . grad v,   rho += d . grad rho,   d_i = K alpha R_i,   alpha = (largest speed) dt.
// R is one of three shifting vectors (terms/distance_shift.hpp, concentration_shift.hpp). The speed is taken
// from the mean velocity, so that the frame of the observer does not matter; at rest nothing is shifted. Gradients are
// corrected (terms/gradient_correction.hpp): linear fields are met exactly, on any arrangement. d is at most
// alpha/2; a particle whose neighbours do not span the space has no gradient, and stays.
//
// The shift is found where the scheme finds its gradients, with them in one sweep where these are corrected, and takes
// place at the end of the step. In print it is found there, too; here it is that of the particles at the step's start
// (at its middle, with two evaluations a step), from which they stand as far as they move in a step.
//
// With a vector that respects the surface (sun), a particle of the free surface is moved along it only, and one that
// has such a particle in its support is not moved towards it: along the normal of the nearest surface particle. So the
// surface stays where the flow took it, which is what keeps volume over long times. Marks and normals are renewed
// whenever the neighbours are listed, and lag by less than the lists' skin.
//
// Walls and periodic boundaries: wall particles and images count in R and in the gradients as the liquid sees them, and
// no particle is moved nearer than half a spacing to a wall.
//
// Volume in a closed domain: particles that the flow has brought out of order have taken volume along (the sum of V
// div v is -2 sum V v . grad C, C the concentration of the particles), and the shift brings them back without it, so
// that density and pressure would rise for ever. Liquid without a free surface at the start fills its walls, if
// they do not move, and its periodic box for good: after each shift all its densities are multiplied by what makes its
// volume that of the start.
//
// What it conserves: mass, and linear fields. Momentum changes by sum m d . grad v a step, energy accordingly: little
// inside, where shifts have no common direction, and much where a surface spreads (docs/method.md).

#include <cstddef>

#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/neighbours.hpp"
#include "coronet/schemes/stress_close.hpp"
#include "coronet/schemes/walls.hpp"
#include "coronet/surface/tension.hpp"

namespace coronet {

enum class ShiftVector { none, xu, jahanbakhsh, sun };

struct ShiftingSettings {
    ShiftVector vector = ShiftVector::none;
    double coefficient = 0;  ///< K
    double spacing = 0;      ///< of the particles at the start [m]
    SurfaceSettings surface;
    bool walls_move = false;  ///< then no liquid is held to its volume
};

/// For a shift found by itself: the scheme has its gradients from elsewhere.
struct NoGradients {
    double kernel_at_zero;

    template <class At, class Sums, class R, int D>
    void operator()(At const&, Sums const&, GradientCorrection<R, D> const&) const {}
};

template <int D>
class Shifting {
public:
    Shifting(ShiftingSettings const& settings, Kernel const& kernel, Precision precision)
        : settings_(settings), kernel_(kernel), precision_(precision) {}

    bool active() const { return settings_.vector != ShiftVector::none; }

    /// Finds the shift of a step of that length [s], and ends the corrected gradients of the scheme, of the same sweep,
    /// as `gradients` does: CorrectedClose, CorrectionClose or NoGradients. Neighbours must be up to date, and
    /// Position, Velocity, Density and Volume set, at wall particles and images, too. Walls may be none.
    template <class GradientClose>
    void find(Particles<D>& particles, Neighbours<D> const& neighbours, double step, Walls<D> const* walls,
              GradientClose const& gradients);
    void find(Particles<D>& particles, Neighbours<D> const& neighbours, double step, Walls<D> const* walls = nullptr) {
        find(particles, neighbours, step, walls, NoGradients{kernel_.at_zero()});
    }

    /// Moves the particles, at the end of the step.
    void apply(Particles<D>& particles) const;

private:
    void look_at_surface(Particles<D>& particles, Neighbours<D> const& neighbours);
    void note_volume(Particles<D>& particles, Neighbours<D> const& neighbours);
    void hold_volume(Particles<D>& particles) const;

    ShiftingSettings settings_;
    Kernel kernel_;
    Precision precision_;
    std::size_t listing_seen_ = 0;  ///< that the marks of the surface are of
    bool started_ = false;
    double closed_volume_ = 0;  ///< of liquid that had no free surface at the start, else 0 [m^D]
};

}  // namespace coronet
