// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The number types of the pair laws. A law is written once over a type R and runs with R = double: one neighbour at a
// time, as on a GPU; or with R = Pack<double> or Pack<float> (core/pack.hpp): as many neighbours at a time as the
// machine's vectors hold. Laws never branch on numbers; they use select(mask, a, b), which means the same for every R.
//
// This file, pack.hpp and simd.hpp are, with pairs/, the only homes of #if for CUDA and SIMD.

#include <cmath>
#include <cstdint>

#if defined(__CUDACC__)
#define CORONET_HD __host__ __device__
#else
#define CORONET_HD
#endif

namespace coronet {

using Index = std::int32_t;

/// The numbers of a sweep over pairs: doubles throughout, or pairs in float and what is kept of them in double.
enum class Precision { full, mixed };

CORONET_HD inline double select(bool mask, double a, double b) { return mask ? a : b; }
CORONET_HD inline double largest(double a, double b) { return a > b ? a : b; }
CORONET_HD inline double smallest(double a, double b) { return a < b ? a : b; }
CORONET_HD inline double sum(double a) { return a; }
CORONET_HD inline double square_root(double a) { return std::sqrt(a); }
/// f of a number; of every lane of a pack, for what has no arithmetic of packs.
template <class Function>
CORONET_HD double lane_by_lane(double a, Function const& f) {
    return f(a);
}

/// The root of a number above zero, and the inverse of it.
template <class R>
struct Roots {
    R root, inverse;
};
CORONET_HD inline Roots<double> roots(double a) {
    double const root = std::sqrt(a);
    return {root, 1 / root};
}

/// Squares of distances count as at least this share of the support's square, so that no root is of zero.
template <class R>
inline constexpr double nearest_square = 1e-24;

}  // namespace coronet
