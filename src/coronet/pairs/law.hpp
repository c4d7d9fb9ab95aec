// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A law is what neighbour j does to particle i, as a sum of terms. A term is a small value with
//     using reads = Fields<...>;   what it reads of both particles (only these are loaded)
//     using own   = Fields<...>;   what it reads of i alone
//     using gives = Fields<...>;   the fields to which it contributes
//     auto operator()(pair) const  the contribution, give<gives>(pair, ...)
// A force along the line of the pair is told by one number instead,
//     auto central(pair) const     a_ij of dv_i/dt = sum_j V_j a_ij grad W_ij
// with Volume among what it reads, and `gives` is Fields<Acceleration>. What all central terms of a law give is
// multiplied by the gradient once.
//
// A term changes nothing and knows no loop. Every contribution must carry the kernel or its gradient as a factor: both
// vanish at the edge of the support. Unused lanes of a sweep hold some other particle, moved beyond it.

#include "coronet/pairs/pair.hpp"

namespace coronet {

template <class T>
concept Term = requires {
    typename T::reads;
    typename T::own;
    typename T::gives;
};

template <class T, class P>
concept CentralTerm = requires(T const& term, P const& ij) {
    term.central(ij);
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
        if constexpr ((CentralTerm<Terms, P> || ...)) {
            Acceleration::of(total) += (central(ij) * (Volume::of(ij.j) * ij.F)) * ij.x;
        }
        add_others(total, ij);
    }

    /// Of the central terms together, and those that are not.
    template <class P>
    CORONET_HD auto central(P const& ij) const requires(CentralTerm<Terms, P> || ...) {
        return central_of(ij, static_cast<Terms const&>(*this)...);
    }
    template <class Total, class P>
    CORONET_HD void add_others(Total& total, P const& ij) const {
        (add_other(total, static_cast<Terms const&>(*this), ij), ...);
    }

private:
    template <class P, class First, class... Rest>
    CORONET_HD static auto central_of(P const& ij, First const& first, Rest const&... rest) {
        if constexpr (!CentralTerm<First, P>) return central_of(ij, rest...);
        else if constexpr ((CentralTerm<Rest, P> || ...)) return first.central(ij) + central_of(ij, rest...);
        else return first.central(ij);
    }
    template <class Total, class T, class P>
    CORONET_HD static void add_other(Total& total, T const& term, P const& ij) {
        if constexpr (requires { term.add_others(total, ij); }) term.add_others(total, ij);
        else if constexpr (!CentralTerm<T, P>) add(total, term(ij), typename T::gives{});
        else {
            static_assert(std::is_same_v<typename T::gives, Fields<Acceleration>>,
                          "a central term gives Fields<Acceleration> alone");
            static_assert(detail::has<Volume, typename T::reads>, "a central term must read Volume: V_j multiplies it");
            static_assert(
                !requires { term(ij); }, "a term is central or has operator(), not both");
        }
    }
    template <class Total, class Part, class... F>
    CORONET_HD static void add(Total& total, Part const& part, Fields<F...>) {
        ((F::of(total) += F::of(part)), ...);
    }
};
template <class... Terms>
Sum(Terms...) -> Sum<Terms...>;

}  // namespace coronet
