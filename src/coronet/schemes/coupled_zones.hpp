// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The zones of the coupled method (Fang et al. 2009, section 3.5.3), by distance from the particles marked by Surface:
// those of the start, or, with surface tension, those found last. A particle is exterior if one of the surface lies in
// its support: there the gradient is corrected. Forces need it in the corrected form wherever an exterior particle may
// come into the support (`border`), and of all that may come into the supports of those (`near`); in the `deep`
// everything is plain. The zones hold until the next listing: meanwhile no pair comes nearer or parts by more than the
// skin, and whoever may come near is in the row.

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

template <int D>
struct CoupledZones {
    Targets exterior, border, near, deep;
    Targets corrected, plain;  ///< exterior and border, near and deep

    /// Sets Exterior, too, and clears FellBack; after neighbours have been listed.
    void mark(Particles<D>& particles, Neighbours<D> const& neighbours);
};

}  // namespace coronet
