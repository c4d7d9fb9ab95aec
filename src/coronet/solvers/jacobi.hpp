// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The preconditioner of Jacobi, division by the diagonal. Where that is zero (a particle alone: nothing acts on it) the
// row is empty, and left as it is.

#include <span>

#include "coronet/core/parallel.hpp"

namespace coronet {

struct Jacobi {
    std::span<double const> diagonal;

    void operator()(std::span<double const> r, std::span<double> z) const {
        for_each(r.size(), [&](std::size_t i) { z[i] = diagonal[i] > 0 ? r[i] / diagonal[i] : r[i]; });
    }
};

}  // namespace coronet
