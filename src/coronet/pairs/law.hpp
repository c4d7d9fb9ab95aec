// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A law is what neighbour j does to particle i, as a sum of terms. A term is a small value with
//     using reads = Fields<...>;   what it reads of both particles (only these are loaded)
//     using own   = Fields<...>;   what it reads of i alone
//     using gives = Fields<...>;   the fields to which it contributes
//     auto operator()(pair) const  the contribution, give<gives>(pair, ...)
// It changes nothing and knows no loop. Every contribution must carry the kernel or its gradient as a factor: both
// vanish at the edge of the support. Unused lanes of a sweep hold some other particle, moved beyond it.

#include "coronet/pairs/pair.hpp"

namespace coronet {

template <class T>
concept Term = requires {
    typename T::reads;
    typename T::own;
    typename T::gives;
};

template <class... Terms>
struct Sum : Terms... {
    static_assert((Term<Terms> && ...),
                  "a term must say what it reads, owns and gives: using reads = Fields<Mass, Density>; ...");
    using reads = Unite<typename Terms::reads...>;
    using own = Unite<typename Terms::own...>;
    using gives = Unite<typename Terms::gives...>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        Values<typename P::Number, P::dimension, gives> total;
        add_to(total, ij);
        return total;
    }

    /// The same, term by term on top of what `total` holds: its last multiplication and the addition are then one.
    template <class Total, class P>
    CORONET_HD void add_to(Total& total, P const& ij) const {
        (add_term(total, static_cast<Terms const&>(*this), ij), ...);
    }

private:
    template <class Total, class T, class P>
    CORONET_HD static void add_term(Total& total, T const& term, P const& ij) {
        if constexpr (requires { term.add_to(total, ij); }) term.add_to(total, ij);
        else add(total, term(ij), typename T::gives{});
    }
    template <class Total, class Part, class... F>
    CORONET_HD static void add(Total& total, Part const& part, Fields<F...>) {
        ((F::of(total) += F::of(part)), ...);
    }
};
template <class... Terms>
Sum(Terms...) -> Sum<Terms...>;

}  // namespace coronet
