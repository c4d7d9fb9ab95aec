// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The number types of the pair laws. A law is written once over a type R and runs with R = double: one
// neighbour at a time, as on a GPU; or with R = Pack<double>: as many neighbours at a time as the machine's vectors
// hold. Laws never branch on numbers; they use select(mask, a, b), which means the same for every R.
//
// This file and simd.hpp are, with pairs/, the only homes of #if for CUDA and SIMD.

#include <cmath>
#include <cstdint>

#if defined(__CUDACC__)
#define CORONET_HD __host__ __device__
#else
#define CORONET_HD
#endif

#if !defined(__CUDACC__) && CORONET_SIMD
#include <experimental/simd>
#endif

namespace coronet {

using Index = std::int32_t;

CORONET_HD inline double select(bool mask, double a, double b) { return mask ? a : b; }
CORONET_HD inline double largest(double a, double b) { return a > b ? a : b; }
CORONET_HD inline double smallest(double a, double b) { return a < b ? a : b; }
CORONET_HD inline double sum(double a) { return a; }
CORONET_HD inline double square_root(double a) { return std::sqrt(a); }
CORONET_HD inline double inverse_root(double a) { return 1 / std::sqrt(a); }

#if !defined(__CUDACC__) && CORONET_SIMD

template <class T>
using Pack = std::experimental::native_simd<T>;

// Declared here, before every template that calls them: argument-dependent lookup would search std::experimental only.
inline Pack<double> select(Pack<double>::mask_type mask, Pack<double> a, Pack<double> b) {
    std::experimental::where(mask, b) = a;
    return b;
}
inline Pack<double> largest(Pack<double> a, Pack<double> b) { return std::experimental::max(a, b); }
inline Pack<double> smallest(Pack<double> a, Pack<double> b) { return std::experimental::min(a, b); }
inline double sum(Pack<double> a) { return std::experimental::reduce(a); }
inline Pack<double> square_root(Pack<double> a) { return std::experimental::sqrt(a); }

#else

/// Without SIMD a pack holds one number, so the same loops serve.
template <class T>
using Pack = T;

#endif

}  // namespace coronet
