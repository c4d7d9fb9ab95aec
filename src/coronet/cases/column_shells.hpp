// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lays particles of a column on coaxial shells, as shells.hpp does those of a drop: each holds as many as there is
// volume in it, on the radius that halves it. On the unrolled shell they are a lattice, the k-th of n at x = k L/n and
// the angle 2 pi k m/n, which goes on across the period L as around the axis; m is the one that keeps them farthest
// apart. A wave is the cylinder carried by the potential flow of that wave, grad (I_0(k r) cos k x), which keeps
// volumes.

#include "coronet/cases/fill.hpp"

namespace coronet {

/// For a case with one shape, a column along x as long as its periodic box.
Seeds<3> fill_column(Case const& c);

}  // namespace coronet
