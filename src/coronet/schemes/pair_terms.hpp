// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pair forces that a case may add to those every scheme has: to add one, name it here. A term that has coefficients
// describes them as keys of the case (see CONTRIBUTING.md); the schema and the schemes take everything else from this
// list.

#include <algorithm>
#include <limits>

#include "coronet/pairs/law.hpp"
#include "coronet/terms/artificial_viscosity.hpp"

namespace coronet {

using PairTerms = Sum<ArtificialViscosity>;

/// Whether a pair term does something: it may say active() = false, without coefficients set.
template <class Term>
bool is_active(Term const& term) {
    if constexpr (requires { term.active(); }) return term.active();
    return true;
}
template <class... Terms>
bool any_active(Sum<Terms...> const& sum) {
    return (is_active(static_cast<Terms const&>(sum)) || ...);
}

/// Whether one that does reads this field.
template <class Field, class... Terms>
bool any_reads(Sum<Terms...> const& sum) {
    return ((detail::has<Field, typename Terms::reads> && is_active(static_cast<Terms const&>(sum))) || ...);
}

/// The longest step the case's pair terms allow: a term may say step_limit(h, c), in s, for smoothing length h [m] and
/// sound speed c [m/s]; infinity where none does.
template <class... Terms>
double step_limit(Sum<Terms...> const& sum, double h, double c) {
    double step = std::numeric_limits<double>::infinity();
    [[maybe_unused]] auto const vote = [&]<class T>(T const& term) {
        if constexpr (requires { term.step_limit(h, c); }) step = std::min(step, term.step_limit(h, c));
    };
    (vote(static_cast<Terms const&>(sum)), ...);
    return step;
}

}  // namespace coronet
