// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How many floating-point operations a law does for a pair: counted, by running the law itself with a number that
// remembers how it came about. Each + - * /, root, comparison, choice and extremum of numbers is one
// operation; a sign is none, since it melts into the operation that follows. As a compiler would, the count takes an
// expression that occurs twice once, and one that no result needs not at all; what follows from particle i and from
// constants alone is the same for all neighbours, done once per particle, and not counted.

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "coronet/kernels/kernel.hpp"
#include "coronet/pairs/law.hpp"

namespace coronet {

/// A number that knows the operation and the operands it came from.
struct Counted {
    using Operands = std::array<int, 4>;  ///< what is done, and to which numbers

    double value = 0;
    int number = 0;       ///< equal for equal expressions
    bool varies = false;  ///< from neighbour to neighbour

    Counted() : Counted(0.0) {}
    Counted(double constant) : value(constant), number(known(constant)) {}

    /// A quantity of particle i, or one that varies from neighbour to neighbour.
    static Counted quantity(double value, bool varies) {
        Counted q;
        q.value = value;
        q.number = static_cast<int>(came_from().size());
        q.varies = varies;
        came_from().push_back({});
        return q;
    }
    template <class... C>
    static Counted of(char operation, double result, C const&... operands) {
        static std::map<Operands, int> seen;
        Counted c;
        c.value = result;
        c.varies = (operands.varies || ...);
        auto const [at, is_new] = seen.try_emplace({operation, operands.number...}, came_from().size());
        c.number = at->second;
        if (is_new) came_from().push_back(c.varies ? at->first : Operands{});
        return c;
    }

    /// Operations on what varies that lead to any of the numbers.
    static std::int64_t operations_for(std::vector<Counted> const& results) {
        std::set<int> reached;
        std::int64_t count = 0;
        std::vector<int> open;
        for (Counted const& c : results) open.push_back(c.number);
        while (!open.empty()) {
            int const number = open.back();
            open.pop_back();
            if (!reached.insert(number).second) continue;
            auto const [operation, a, b, c] = came_from()[static_cast<std::size_t>(number)];
            if (operation == 0) continue;
            count += operation != sign;
            open.insert(open.end(), {a, b, c});
        }
        return count;
    }

    Counted& operator+=(Counted const& b) { return *this = of('+', value + b.value, *this, b); }
    Counted& operator-=(Counted const& b) { return *this = of('-', value - b.value, *this, b); }
    Counted& operator*=(Counted const& b) { return *this = of('*', value * b.value, *this, b); }
    Counted& operator/=(Counted const& b) { return *this = of('/', value / b.value, *this, b); }
    static constexpr char sign = 's';

private:
    /// The operation behind each number; none for constants and quantities.
    static std::vector<Operands>& came_from() {
        static std::vector<Operands> list(1);
        return list;
    }
    static int known(double constant) {
        static std::map<double, int> numbers{{0, 0}};
        auto const [at, is_new] = numbers.try_emplace(constant, came_from().size());
        if (is_new) came_from().push_back({});
        return at->second;
    }
};

inline Counted operator+(Counted a, Counted const& b) { return a += b; }
inline Counted operator-(Counted a, Counted const& b) { return a -= b; }
inline Counted operator*(Counted a, Counted const& b) { return a *= b; }
inline Counted operator/(Counted a, Counted const& b) { return a /= b; }
inline Counted operator-(Counted const& a) { return Counted::of(Counted::sign, -a.value, a); }

// The outcome of a comparison is a number, too: 1 or 0.
inline Counted operator<(Counted const& a, Counted const& b) { return Counted::of('<', a.value < b.value, a, b); }
inline Counted operator>(Counted const& a, Counted const& b) { return b < a; }

inline Counted select(Counted const& mask, Counted const& a, Counted const& b) {
    return Counted::of('?', mask.value != 0 ? a.value : b.value, mask, a, b);
}
inline Counted largest(Counted const& a, Counted const& b) {
    return Counted::of('M', a.value > b.value ? a.value : b.value, a, b);
}
inline Counted smallest(Counted const& a, Counted const& b) {
    return Counted::of('m', a.value < b.value ? a.value : b.value, a, b);
}
inline Counted square_root(Counted const& a) { return Counted::of('r', std::sqrt(a.value), a); }
inline Roots<Counted> roots(Counted const& a) {
    Counted const root = square_root(a);
    return {root, 1.0 / root};
}

/// Operations that one neighbour inside the support costs particle i, from the two positions to the sums.
template <int D, class Law>
std::int64_t operations_per_pair(Kernel const& kernel, Law const& law) {
    using R = Counted;
    using Own = Unite<typename Law::own, typename Law::reads>;
    Pair<R, D, Own, typename Law::reads> ij;
    auto const fill = [](auto& values, auto fields, bool varies) {
        for_fields(fields, [&]<class F>(F) {
            for (int k = 0; k < components<F::rank, D>(); ++k) component(F::of(values), k) = R::quantity(1, varies);
        });
    };
    fill(ij.i, Own{}, false);
    fill(ij.j, typename Law::reads{}, true);
    ij.h = R(kernel.support / 3);
    for (int k = 0; k < D; ++k) ij.x[k] = R::quantity(0, false) - R::quantity(0.25 * kernel.support, true);
    ij.r2 = norm2(ij.x);
    auto const [W, F] = kernel(ij.r2);
    ij.W = W;
    ij.F = F;
    ij.gradW = F * ij.x;

    Values<R, D, typename Law::gives> total;
    std::vector<R> results;
    for_fields(typename Law::gives{}, [&]<class G>(G) {
        for (int k = 0; k < components<G::rank, D>(); ++k) component(G::of(total), k) = R::quantity(0, false);
    });
    law.add_to(total, ij);
    for_fields(typename Law::gives{}, [&]<class G>(G) {
        for (int k = 0; k < components<G::rank, D>(); ++k) results.push_back(component(G::of(total), k));
    });
    return R::operations_for(results);
}

}  // namespace coronet
