// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Slow flow through a simple cubic array of spheres: the drag on one is F = 6 pi mu a U K, U the mean velocity over the
// whole cell, spheres and all, and K a function of the volume fraction c of the spheres alone. A. S. Sangani and A.
// Acrivos, Int. J. Multiphase Flow 8 (1982) 343, have the series K = sum q_s chi^s, chi^3 = 6 c/pi (1 where spheres
// touch), Eq 60 and Table 1; A. A. Zick and G. M. Homsy, J. Fluid Mech. 115 (1982) 13, Table 2, values from integral
// equations. Both agree within 0.02 % up to c = 0.216; beyond, the series to chi^30 runs away (0.9 % at 0.343), so that
// there the values of Zick and Homsy alone are known.

namespace coronet {

/// K; NaN where it is not known.
double sphere_array_drag(double volume_fraction);

}  // namespace coronet
