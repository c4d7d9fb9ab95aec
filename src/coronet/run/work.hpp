// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The least work that one particle costs in one evaluation of the right-hand side:
//   operations  those of the scheme's laws (run/counted.hpp) for the mean number of neighbours inside the support;
//   bytes       per sweep, what it reads of the particle, its record written once and read once (a neighbour then comes
//               from a cache), 4 bytes per neighbour of the row, and what the rest of the step needs of the results.
// A lower bound of both: neighbours in the skin, their listing, the state and the time stepping are left out. Bytes
// come from memory only as far as the caches do not hold the particles: for few of them, they are no bound.

#include "coronet/cases/case.hpp"

namespace coronet {

struct Work {
    double operations = 0;
    double bytes = 0;
};

/// `neighbours` is the mean number inside the support; `exterior` the share of particles that are marked as such: only
/// gradient cph asks for it.
template <int D>
Work work_per_evaluation(Case const& c, double neighbours, double exterior);

}  // namespace coronet
