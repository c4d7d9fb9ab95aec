// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The three moves of a pack that std::experimental::simd has no good words for: loading from scattered addresses,
// squeezing the lanes that pass a test to the front, and counting lanes. Each has a plain version that any machine runs.

#include <cstddef>

#include "coronet/core/real.hpp"

#if CORONET_SIMD && defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace coronet {

#if !defined(__CUDACC__) && CORONET_SIMD

inline constexpr int pack_size = static_cast<int>(Pack<double>::size());

inline Pack<double> load(double const* from) {
    return Pack<double>(from, std::experimental::element_aligned);
}

/// from[index[0]], from[index[1]], ...
inline Pack<double> gather(double const* from, Index const* index) {
#if defined(__AVX512F__)
    __m256i const lanes = _mm256_loadu_si256(reinterpret_cast<__m256i const*>(index));
    return Pack<double>(_mm512_i32gather_pd(lanes, from, 8));
#else
    return Pack<double>([&](auto lane) { return from[index[lane]]; });
#endif
}

/// Which lanes are below a limit, as bits; lane 0 is the lowest bit.
inline unsigned lanes_below(Pack<double> values, double limit) {
#if defined(__AVX512F__)
    return _mm512_cmp_pd_mask(static_cast<__m512d>(values), _mm512_set1_pd(limit), _CMP_LT_OQ);
#else
    unsigned held = 0;
    for (int lane = 0; lane < pack_size; ++lane) held |= unsigned{values[lane] < limit} << lane;
    return held;
#endif
}

/// Writes the lanes of `from` whose bit is set to `to`, one after another. May write a whole pack: leave room.
inline void squeeze(unsigned held, Pack<double> from, double* to) {
#if defined(__AVX512F__)
    _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(held), static_cast<__m512d>(from)));
#else
    for (int lane = 0; lane < pack_size; ++lane) {
        *to = from[lane];
        to += held >> lane & 1u;
    }
#endif
}

/// The same for the indices that stand at `from`; reads and may write a whole pack of them.
inline void squeeze(unsigned held, Index const* from, Index* to) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
    __m256i const lanes = _mm256_loadu_si256(reinterpret_cast<__m256i const*>(from));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(held), lanes));
#else
    for (int lane = 0; lane < pack_size; ++lane) {
        *to = from[lane];
        to += held >> lane & 1u;
    }
#endif
}

/// The same for the indices first, first + 1, ...
inline void squeeze_range(unsigned held, Index first, Index* to) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
    __m256i const lanes = _mm256_add_epi32(_mm256_set1_epi32(first), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(held), lanes));
#else
    for (int lane = 0; lane < pack_size; ++lane) {
        *to = first + lane;
        to += held >> lane & 1u;
    }
#endif
}

#else

inline constexpr int pack_size = 1;

CORONET_HD inline double load(double const* from) { return *from; }
CORONET_HD inline double gather(double const* from, Index const* index) { return from[*index]; }
CORONET_HD inline unsigned lanes_below(double value, double limit) { return value < limit; }
CORONET_HD inline void squeeze(unsigned, double from, double* to) { *to = from; }
CORONET_HD inline void squeeze(unsigned, Index const* from, Index* to) { *to = *from; }
CORONET_HD inline void squeeze_range(unsigned, Index first, Index* to) { *to = first; }

#endif

}  // namespace coronet
