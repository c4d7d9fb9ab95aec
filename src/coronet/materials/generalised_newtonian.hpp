// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The stress of a generalised Newtonian liquid,
//     sigma = -p I + 2 mu(g) d,   g = sqrt(2 d:d),
// with d the traceless symmetric part of the velocity gradient (Fang et al. 2009, Eqs 5, 6 and 62; bulk viscosity is
// zero) and mu the viscosity of its rheology (materials/rheology.hpp). Newtonian is the stress for a given viscosity.

#include "coronet/materials/rheology.hpp"

namespace coronet {

template <class R>
struct Newtonian {
    R viscosity;  ///< dynamic shear viscosity [Pa s]

    /// grad_v(a, b) = dv_a/dx_b [1/s], p [Pa] -> sigma [Pa].
    template <int D>
    CORONET_HD Symmetric<R, D> stress(R const& p, Matrix<R, D> const& grad_v) const {
        Symmetric<R, D> sigma;
        R const mean = R(1. / D) * trace(grad_v);
        unrolled<D * D>([&](int ab) {
            int const a = ab / D, b = ab % D;
            if (a <= b) sigma(a, b) = viscosity * (grad_v(a, b) + grad_v(b, a));
        });
        unrolled<D>([&](int a) { sigma(a, a) -= p + (viscosity + viscosity) * mean; });
        return sigma;
    }
};
template <class R>
Newtonian(R) -> Newtonian<R>;

struct GeneralisedNewtonian {
    Rheology rheology = {.viscosity = 0};

    CORONET_HD bool is_newtonian() const { return rheology.model == Rheology::Model::newtonian; }
    bool is_inviscid() const { return is_newtonian() && rheology.viscosity == 0; }

    /// mu [Pa s] where the velocity gradient is grad_v [1/s].
    template <class R, int D>
    CORONET_HD R viscosity(Matrix<R, D> const& grad_v) const {
        if (is_newtonian()) return R(rheology.viscosity);
        return lane_by_lane(shear_rate(grad_v), [&](double rate) { return rheology.viscosity_at(rate); });
    }
};

}  // namespace coronet
