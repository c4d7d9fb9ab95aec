// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lays particles on concentric shells about the centre of a disc or ball, a spacing apart, as tension draws a drop
// round: a surface cut out of a lattice has steps, which give their energy to disorder of the particles when they
// smooth out. Each shell holds as many particles as there is volume in it, on the radius that halves it: in 2D at equal
// angles, in 3D on a spiral of Fibonacci's (Swinbank and Purser, Q. J. R. Meteorol. Soc. 132 (2006) 1769), turned at
// random. A drop with a wave is the ball carried by the potential flow of that mode, which keeps volumes: its wave is
// that of the case to first order in the amplitude.

#include "coronet/cases/fill.hpp"

namespace coronet {

/// For a case whose shapes are discs, balls or drops of one radius, without cuts.
template <int D>
Seeds<D> fill_shells(Case const& c);

}  // namespace coronet
