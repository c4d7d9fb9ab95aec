// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The moves of a pack that std::experimental::simd has no good words for: fetching scattered records, squeezing the
// lanes that pass a test to the front, and a fast inverse root. Each has a plain version that any machine runs.

#include <cstddef>

#include "coronet/core/real.hpp"

#if CORONET_SIMD && defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace coronet {

#if !defined(__CUDACC__) && CORONET_SIMD

inline constexpr int pack_size = static_cast<int>(Pack<double>::size());

inline Pack<double> load(double const* from) { return Pack<double>(from, std::experimental::element_aligned); }

/// 1/sqrt(a) to a unit or two in the last place for a > 0. From the 14 bits that the processor
/// looks up, one step of fourth order: with e = 1 - a y^2, 1/sqrt(a) = y (1 + e/2 + 3 e^2/8 + 5 e^3/16 + O(e^4)).
inline Pack<double> inverse_root(Pack<double> a) {
#if defined(__AVX512F__)
    Pack<double> const y(_mm512_rsqrt14_pd(static_cast<__m512d>(a)));
    Pack<double> const e = 1.0 - a * y * y;
    return y + y * (e * (0.5 + e * (0.375 + e * 0.3125)));
#else
    return 1.0 / square_root(a);
#endif
}

/// Component c of the record of lane l, for c = 0 ... 3: records of `width` doubles stand one after another from
/// `first`, aligned to 32 bytes, and index[l] says which is the lane's. Four wide loads and a transposition take a
/// third of the time of gathering four packs.
inline void fetch_four(double const* first, Index const* index, std::size_t width, Pack<double>* component) {
#if defined(__AVX512F__)
    auto const record = [&](int lane) { return _mm256_load_pd(first + static_cast<std::size_t>(index[lane]) * width); };
    auto const two = [&](int lane) {
        return _mm512_insertf64x4(_mm512_castpd256_pd512(record(lane)), record(lane + 4), 1);
    };
    __m512d const l04 = two(0), l15 = two(1), l26 = two(2), l37 = two(3);
    __m512d const even01 = _mm512_unpacklo_pd(l04, l15), odd01 = _mm512_unpackhi_pd(l04, l15);
    __m512d const even23 = _mm512_unpacklo_pd(l26, l37), odd23 = _mm512_unpackhi_pd(l26, l37);
    __m512i const low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13),
                  high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    component[0] = Pack<double>(_mm512_permutex2var_pd(even01, low, even23));
    component[1] = Pack<double>(_mm512_permutex2var_pd(odd01, low, odd23));
    component[2] = Pack<double>(_mm512_permutex2var_pd(even01, high, even23));
    component[3] = Pack<double>(_mm512_permutex2var_pd(odd01, high, odd23));
#else
    for (int c = 0; c < 4; ++c)
        component[c] = Pack<double>([&](auto lane) {
            return first[static_cast<std::size_t>(index[lane]) * width + static_cast<std::size_t>(c)];
        });
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

/// Writes those of the indices at `from` whose lane's bit is set to `to`, one after another. Reads a whole pack of
/// indices and may write as many: leave room.
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

inline void fetch_four(double const* first, Index const* index, std::size_t width, double* component) {
    for (std::size_t c = 0; c < 4; ++c) component[c] = first[static_cast<std::size_t>(*index) * width + c];
}
CORONET_HD inline unsigned lanes_below(double value, double limit) { return value < limit; }
CORONET_HD inline void squeeze(unsigned, Index const* from, Index* to) { *to = *from; }
CORONET_HD inline void squeeze_range(unsigned, Index first, Index* to) { *to = first; }

#endif

}  // namespace coronet
