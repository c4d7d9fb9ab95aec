// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How many floating-point operations a law does for a pair: counted, by running the law itself with a number that
// counts. Each + - * /, root (plain or inverse), comparison, choice and extremum of numbers is one operation; a sign
// is none, since it melts into the operation that follows. What follows from particle i and from constants alone is
// the same for all neighbours and done once per particle: it is not counted.

#include <cmath>
#include <cstdint>

#include "coronet/kernels/kernel.hpp"
#include "coronet/pairs/law.hpp"

namespace coronet {

struct Counted {
    double value = 0;
    bool varies = false;  ///< from neighbour to neighbour

    Counted() = default;
    explicit Counted(double number, bool varies_between_neighbours = false)
        : value(number), varies(varies_between_neighbours) {}

    inline static std::int64_t operations = 0;

    /// The number `result` of an operation on `operands`.
    template <class... Operands>
    static Counted of(double result, Operands const&... operands) {
        bool const varies = (operands.varies || ...);
        operations += varies;
        return Counted(result, varies);
    }
    Counted& operator+=(Counted b) { return *this = of(value + b.value, *this, b); }
    Counted& operator-=(Counted b) { return *this = of(value - b.value, *this, b); }
    Counted& operator*=(Counted b) { return *this = of(value * b.value, *this, b); }
    Counted& operator/=(Counted b) { return *this = of(value / b.value, *this, b); }
};

inline Counted operator+(Counted a, Counted b) { return a += b; }
inline Counted operator-(Counted a, Counted b) { return a -= b; }
inline Counted operator*(Counted a, Counted b) { return a *= b; }
inline Counted operator/(Counted a, Counted b) { return a /= b; }
inline Counted operator-(Counted a) { return Counted(-a.value, a.varies); }

/// The outcome of a comparison.
struct CountedMask {
    bool value, varies;
};
inline CountedMask compared(bool outcome, Counted a, Counted b) { return {outcome, Counted::of(0, a, b).varies}; }
inline CountedMask operator<(Counted a, Counted b) { return compared(a.value < b.value, a, b); }
inline CountedMask operator>(Counted a, Counted b) { return compared(a.value > b.value, a, b); }
inline CountedMask operator<=(Counted a, Counted b) { return compared(a.value <= b.value, a, b); }
inline CountedMask operator>=(Counted a, Counted b) { return compared(a.value >= b.value, a, b); }

inline Counted select(CountedMask mask, Counted a, Counted b) {
    return Counted::of(mask.value ? a.value : b.value, mask, a, b);
}
inline Counted largest(Counted a, Counted b) { return Counted::of(a.value > b.value ? a.value : b.value, a, b); }
inline Counted smallest(Counted a, Counted b) { return Counted::of(a.value < b.value ? a.value : b.value, a, b); }
inline Counted square_root(Counted a) { return Counted::of(std::sqrt(a.value), a); }
inline Counted inverse_root(Counted a) { return Counted::of(1 / std::sqrt(a.value), a); }
inline Counted reciprocal(Counted a) { return Counted::of(1 / a.value, a); }

/// Operations that one neighbour inside the support costs particle i, from the two positions to the sums.
template <int D, class Law>
std::int64_t operations_per_pair(Kernel const& kernel, Law const& law) {
    using R = Counted;
    using Own = Unite<typename Law::own, typename Law::reads>;
    Pair<R, D, Own, typename Law::reads> ij;
    auto const fill = [](auto& values, auto fields, bool varies) {
        for_fields(fields, [&]<class F>(F) {
            for (int k = 0; k < components<F::rank, D>(); ++k) component(F::of(values), k) = R(1, varies);
        });
    };
    fill(ij.i, Own{}, false);
    fill(ij.j, typename Law::reads{}, true);
    ij.h = R(kernel.support / 3);
    Vector<R, D> x_i, x_j;
    for (int k = 0; k < D; ++k) x_j[k] = R(0.25 * kernel.support, true);

    Counted::operations = 0;
    ij.x = x_i - x_j;
    ij.r2 = norm2(ij.x);
    auto const [W, F] = kernel(ij.r2);
    ij.W = W;
    ij.gradW = F * ij.x;
    auto const part = law(ij);
    Values<R, D, typename Law::gives> total;
    for_fields(typename Law::gives{}, [&]<class G>(G) { G::of(total) += G::of(part); });
    return Counted::operations;
}

}  // namespace coronet
