// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lays particles on a lattice inside a case's shapes.

#include <vector>

#include "coronet/cases/case.hpp"
#include "coronet/core/tensor.hpp"

namespace coronet {

template <int D>
struct Seeds {
    std::vector<Vector<double, D>> position;  ///< [m]
    std::vector<char> surface;                ///< whether a neighbouring lattice point is outside the shapes
    double volume = 0;                        ///< of each [m^D]

    std::size_t size() const { return position.size(); }
};

/// The lattice points inside the shapes, jittered as the case says: the same for every machine and number of threads.
template <int D>
Seeds<D> fill(Case const& c);

/// About how many particles fill() would make, from the boxes around the shapes.
template <int D>
double expected_particles(Case const& c);

}  // namespace coronet
