// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pairs of neighbours with random values of every field a term reads, and the same pair seen from the other side: to
// test what a term does to two particles without any loop.

#include <random>
#include <vector>

#include "coronet/kernels/kernel.hpp"
#include "coronet/pairs/law.hpp"

namespace coronet {

/// i and j of equal type, so that they can change places.
template <int D, class Term>
using TestPair =
    Pair<double, D, Unite<typename Term::own, typename Term::reads>, Unite<typename Term::own, typename Term::reads>>;

/// Scalars lie in [0.5, 1.5] (they may be densities or masses), components of vectors and tensors in [-1, 1].
template <int D, class Term>
std::vector<TestPair<D, Term>> random_pairs(int count) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Kernel const kernel = make_kernel("wendland-c2", D, 1.0);
    std::vector<TestPair<D, Term>> pairs(static_cast<std::size_t>(count));
    for (auto& ij : pairs) {
        auto const fill = [&](auto& values) {
            for_fields(Unite<typename Term::own, typename Term::reads>{}, [&]<class F>(F) {
                for (int k = 0; k < components<F::rank, D>(); ++k)
                    component(F::of(values), k) =
                        uniform(engine) * (F::rank == Rank::scalar ? 0.5 : 1) + (F::rank == Rank::scalar);
            });
        };
        fill(ij.i);
        fill(ij.j);
        do {
            for (int k = 0; k < D; ++k) ij.x[k] = uniform(engine);
        } while (norm2(ij.x) >= 1 || norm2(ij.x) == 0);
        ij.r2 = norm2(ij.x);
        ij.h = kernel.support / 3;
        auto const [W, F] = kernel(ij.r2);
        ij.W = W;
        ij.F = F;
        ij.gradW = F * ij.x;
    }
    return pairs;
}

/// The pair as j sees it: particles exchanged, x and the gradient turned round.
template <class P>
P swapped(P pair) {
    std::swap(pair.i, pair.j);
    pair.x = -pair.x;
    pair.gradW = -pair.gradW;
    return pair;
}

}  // namespace coronet
