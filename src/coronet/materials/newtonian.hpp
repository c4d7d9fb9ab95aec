// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The stress of a Newtonian liquid, sigma = -p I + 2 eta d, with d the traceless symmetric part of the velocity
// gradient: Fang et al. (2009) Eqs 5, 6 and 62. Bulk viscosity is zero.

#include "coronet/core/tensor.hpp"

namespace coronet {

struct Newtonian {
    double viscosity = 0;  ///< dynamic shear viscosity eta [Pa s]

    /// grad_v(a, b) = dv_a/dx_b [1/s], p [Pa] -> sigma [Pa].
    template <class R, int D>
    CORONET_HD Symmetric<R, D> stress(R const& p, Matrix<R, D> const& grad_v) const {
        Symmetric<R, D> sigma;
        R const mean = R(1. / D) * trace(grad_v), eta = R(viscosity);
        unrolled<D * D>([&](int ab) {
            int const a = ab / D, b = ab % D;
            if (a <= b) sigma(a, b) = eta * (grad_v(a, b) + grad_v(b, a));
        });
        unrolled<D>([&](int a) { sigma(a, a) -= p + (eta + eta) * mean; });
        return sigma;
    }
};

}  // namespace coronet
