// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a law sees of two neighbours: the values of i and of j by name (ij.i.rho, ij.j.v), where they stand to each
// other, and the kernel between them. Same words in every term, so i and j cannot be crossed silently.

#include "coronet/fields/vocabulary.hpp"

namespace coronet {

template <class R, int D, class Own, class Reads>
struct Pair {
    using Number = R;
    static constexpr int dimension = D;

    Values<R, D, Own> i;
    Values<R, D, Reads> j;
    Vector<R, D> x;      ///< x_i - x_j [m]
    R r2;                ///< |x|^2 [m^2]
    R h;                 ///< smoothing length, a third of the support [m]
    R W;                 ///< kernel [1/m^D]
    R F;                 ///< W'/r [1/m^(D+2)]
    Vector<R, D> gradW;  ///< its gradient at x_i, F x [1/m^(D+1)]
};

namespace detail {
template <class V, class... F, class... T>
CORONET_HD void assign(V& values, Fields<F...>, T const&... value) {
    ((F::of(values) = value), ...);
}
}  // namespace detail

/// What a term gives for one pair: values of the fields `Gives`, in that order.
template <class Gives, class P, class... T>
CORONET_HD auto give(P const&, T const&... value) {
    static_assert(Gives::size == sizeof...(T), "a term must give one value for each field of its list `gives`");
    Values<typename P::Number, P::dimension, Gives> values;
    detail::assign(values, Gives{}, value...);
    return values;
}

}  // namespace coronet
