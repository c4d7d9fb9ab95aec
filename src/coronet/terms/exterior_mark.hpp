// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The exterior mark of the coupled method (Fang et al. 2009, section 3.5.3): a particle is exterior if at least one
// particle of the free surface lies in its support. The surface particles are those of the initial surface, as there.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct ExteriorMark {
    using reads = Fields<Surface>;
    using own = Fields<>;
    using gives = Fields<Exterior>;

    /// Gives the number of surface neighbours; any above zero marks the particle.
    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        return give<gives>(ij, select(ij.W > R(0), ij.j.surface, R(0)));
    }
};

}  // namespace coronet
