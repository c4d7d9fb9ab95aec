// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The velocity and pressure of a frame's liquid, anywhere: linear regression on the liquid around the point x, weighted
// with p_j = V_j W(x_j - x)/sum V W,
//     f(x) = sum_j w_j f_j,   w_j = p_j (1 - (x_j - c) . C^-1 (c - x)),
// c = sum p_j x_j the centre of the weights and C = sum p_j (x_j - c)(x_j - c)^T. It meets linear fields exactly,
// beyond the outermost particles too (moving least squares: Lancaster and Salkauskas, Math. Comput. 37 (1981) 141). The
// gradient correction of the schemes would do the same inside; made for explicit steps, it gives up half a spacing off
// a wall, where the particles of a finer lattice lie.
//   - The kernel's radius is three spacings of the frame's own particles, their mean volume to the power 1/D: that is
//     the same for any lattice, while the nearest neighbours of particles in disorder are nearer than their spacing.
//   - The variance of f is at most 1 + (c - x) . C^-1 (c - x) times that of independent errors of the f_j. Where this
//     is beyond `most_amplified`, or the neighbours do not span the space, f is the mean sum p_j f_j; where there are
//     none, that of the nearest particle.
//   - What regression takes off a curved field is found at the frame's particles and given to them beforehand, values
//     f + (f - S f) for the smoothing S (twicing: Tukey, Exploratory Data Analysis, 1977): without it a flow of
//     forty spacings a wavelength would lose some percent of its energy.
// Lengths in m, velocity in m/s, pressure in Pa.

#include "coronet/io/frame.hpp"
#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/cell_grid.hpp"
#include "coronet/neighbours/images.hpp"

namespace coronet {

template <int D>
class FrameFlow {
public:
    static constexpr double radius_in_spacings = 3;  ///< of the kernel

    /// `frame` holds liquid alone, of a field velocity, a volume above 0, and a pressure where that is known (else 0).
    FrameFlow(Frame const& frame, PeriodicBox<D> const& box);

    struct Value {
        Vector<double, D> velocity;
        double pressure = 0;
        bool beyond = false;  ///< of the nearest particle: none is within the kernel's radius
    };
    Value at(Vector<double, D> const& x) const;

private:
    static constexpr double most_amplified = 100;  ///< the variance: errors ten times

    Value nearest(Vector<double, D> const& x) const;

    Kernel kernel_;
    Particles<D> particles_;
    CellGrid<D> grid_;
};

/// Mean volume of the frame's particles to the power 1/D [m].
double spacing_of(Frame const& frame, int dimension);

}  // namespace coronet
