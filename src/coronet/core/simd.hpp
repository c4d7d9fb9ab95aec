// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The moves of a pack that vector types have no words for: fetching and writing scattered numbers, comparing into bits,
// and writing the chosen of a range one after another. Each has a plain version that any machine runs.

#include <cstddef>

#include "coronet/core/pack.hpp"

namespace coronet {

#if CORONET_SIMD && defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)

/// Component c of the group of four numbers that lane l points to, for c = 0 ... 3: it stands at first + place[l],
/// aligned to four numbers. Wide loads and a transposition take a third of the time of gathering four packs.
inline void fetch_four(double const* first, Index const* place, Pack<double>* component) {
    auto const group = [&](int lane) { return _mm256_load_pd(first + place[lane]); };
    auto const two = [&](int lane) {
        return _mm512_insertf64x4(_mm512_castpd256_pd512(group(lane)), group(lane + 4), 1);
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
}
inline void fetch_four(float const* first, Index const* place, Pack<float>* component) {
    auto const group = [&](int lane) { return _mm_load_ps(first + place[lane]); };
    auto const four = [&](int lane) {
        __m512 quarters = _mm512_castps128_ps512(group(lane));
        quarters = _mm512_insertf32x4(quarters, group(lane + 4), 1);
        quarters = _mm512_insertf32x4(quarters, group(lane + 8), 2);
        return _mm512_insertf32x4(quarters, group(lane + 12), 3);
    };
    __m512 const a = four(0), b = four(1), c = four(2), d = four(3);
    auto const wide = [](__m512 pack) { return _mm512_castps_pd(pack); };
    __m512d const ab01 = wide(_mm512_unpacklo_ps(a, b)), ab23 = wide(_mm512_unpackhi_ps(a, b));
    __m512d const cd01 = wide(_mm512_unpacklo_ps(c, d)), cd23 = wide(_mm512_unpackhi_ps(c, d));
    component[0] = Pack<float>(_mm512_castpd_ps(_mm512_unpacklo_pd(ab01, cd01)));
    component[1] = Pack<float>(_mm512_castpd_ps(_mm512_unpackhi_pd(ab01, cd01)));
    component[2] = Pack<float>(_mm512_castpd_ps(_mm512_unpacklo_pd(ab23, cd23)));
    component[3] = Pack<float>(_mm512_castpd_ps(_mm512_unpackhi_pd(ab23, cd23)));
}

/// The number that lane l points to.
inline Pack<double> fetch_one(double const* first, Index const* place) {
    return Pack<double>(_mm512_i32gather_pd(_mm256_loadu_si256(reinterpret_cast<__m256i const*>(place)), first, 8));
}
inline Pack<float> fetch_one(float const* first, Index const* place) {
    return Pack<float>(_mm512_i32gather_ps(_mm512_loadu_si512(place), first, 4));
}

/// Writes the first `count` lanes to the places that they are given.
inline void scatter(Pack<double> const& a, double* first, Index const* place, int count) {
    auto const held = static_cast<__mmask8>((1u << count) - 1);
    _mm512_mask_i32scatter_pd(first, held, _mm256_loadu_si256(reinterpret_cast<__m256i const*>(place)), a.lanes, 8);
}

/// The sums of the lanes of eight packs, formed in double, in less than half of the time of eight single sums.
inline void sum_eight(Pack<double> const* a, double* sums) {
    auto const pairs = [&](int k) {
        return _mm512_unpacklo_pd(a[k].lanes, a[k + 1].lanes) + _mm512_unpackhi_pd(a[k].lanes, a[k + 1].lanes);
    };
    auto const blocks = [](__m512d p, __m512d q) {
        return _mm512_shuffle_f64x2(p, q, 0x88) + _mm512_shuffle_f64x2(p, q, 0xdd);
    };
    _mm512_storeu_pd(sums, blocks(blocks(pairs(0), pairs(2)), blocks(pairs(4), pairs(6))));
}
inline void sum_eight(Pack<float> const* a, double* sums) {
    Pack<double> halves[8];
    for (int k = 0; k < 8; ++k) {
        __m256 const low = _mm512_castps512_ps256(a[k].lanes);
        __m256 const high = _mm256_castpd_ps(_mm512_extractf64x4_pd(_mm512_castps_pd(a[k].lanes), 1));
        halves[k] = Pack<double>(_mm512_cvtps_pd(low) + _mm512_cvtps_pd(high));
    }
    sum_eight(halves, sums);
}

/// Which lanes are below a limit, as bits; lane 0 is the lowest bit.
inline unsigned lanes_below(Pack<double> const& values, double limit) {
    return _mm512_cmp_pd_mask(values.lanes, _mm512_set1_pd(limit), _CMP_LT_OQ);
}
inline unsigned lanes_below(Pack<float> const& values, float limit) {
    return _mm512_cmp_ps_mask(values.lanes, _mm512_set1_ps(limit), _CMP_LT_OQ);
}

/// Writes first + step l for every lane l of a pack of T whose bit is set to `to`, one after another. May write as many
/// as the pack has lanes: leave room.
template <class T, int step>
void squeeze_range(unsigned held, Index first, Index* to) {
    if constexpr (sizeof(T) == 8) {
        auto const lanes = _mm256_setr_epi32(0, step, 2 * step, 3 * step, 4 * step, 5 * step, 6 * step, 7 * step);
        auto const range = _mm256_add_epi32(_mm256_set1_epi32(first), lanes);
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                            _mm256_maskz_compress_epi32(static_cast<__mmask8>(held), range));
    } else {
        auto const lanes = _mm512_mullo_epi32(_mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15),
                                              _mm512_set1_epi32(step));
        auto const range = _mm512_add_epi32(_mm512_set1_epi32(first), lanes);
        _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(held), range));
    }
}

#elif CORONET_SIMD && defined(__AVX2__) && !defined(__AVX512F__)

inline void fetch_four(double const* first, Index const* place, Pack<double>* component) {
    auto const group = [&](int lane) { return _mm256_load_pd(first + place[lane]); };
    __m256d const a = group(0), b = group(1), c = group(2), d = group(3);
    __m256d const ab02 = _mm256_unpacklo_pd(a, b), ab13 = _mm256_unpackhi_pd(a, b);
    __m256d const cd02 = _mm256_unpacklo_pd(c, d), cd13 = _mm256_unpackhi_pd(c, d);
    component[0] = Pack<double>(_mm256_permute2f128_pd(ab02, cd02, 0x20));
    component[1] = Pack<double>(_mm256_permute2f128_pd(ab13, cd13, 0x20));
    component[2] = Pack<double>(_mm256_permute2f128_pd(ab02, cd02, 0x31));
    component[3] = Pack<double>(_mm256_permute2f128_pd(ab13, cd13, 0x31));
}
inline void fetch_four(float const* first, Index const* place, Pack<float>* component) {
    auto const group = [&](int lane) { return _mm_load_ps(first + place[lane]); };
    auto const two = [&](int lane) {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(group(lane)), group(lane + 4), 1);
    };
    __m256 const a = two(0), b = two(1), c = two(2), d = two(3);
    auto const wide = [](__m256 pack) { return _mm256_castps_pd(pack); };
    __m256d const ab01 = wide(_mm256_unpacklo_ps(a, b)), ab23 = wide(_mm256_unpackhi_ps(a, b));
    __m256d const cd01 = wide(_mm256_unpacklo_ps(c, d)), cd23 = wide(_mm256_unpackhi_ps(c, d));
    component[0] = Pack<float>(_mm256_castpd_ps(_mm256_unpacklo_pd(ab01, cd01)));
    component[1] = Pack<float>(_mm256_castpd_ps(_mm256_unpackhi_pd(ab01, cd01)));
    component[2] = Pack<float>(_mm256_castpd_ps(_mm256_unpacklo_pd(ab23, cd23)));
    component[3] = Pack<float>(_mm256_castpd_ps(_mm256_unpackhi_pd(ab23, cd23)));
}

inline Pack<double> fetch_one(double const* first, Index const* place) {
    return Pack<double>(_mm256_setr_pd(first[place[0]], first[place[1]], first[place[2]], first[place[3]]));
}
inline Pack<float> fetch_one(float const* first, Index const* place) {
    return Pack<float>(_mm256_setr_ps(first[place[0]], first[place[1]], first[place[2]], first[place[3]],
                                      first[place[4]], first[place[5]], first[place[6]], first[place[7]]));
}

inline void scatter(Pack<double> const& a, double* first, Index const* place, int count) {
    for (int lane = 0; lane < count; ++lane) first[place[lane]] = a[lane];
}

inline void sum_eight(Pack<double> const* a, double* sums) {
    auto const pairs = [&](int k) {
        return _mm256_unpacklo_pd(a[k].lanes, a[k + 1].lanes) + _mm256_unpackhi_pd(a[k].lanes, a[k + 1].lanes);
    };
    auto const four = [&](int k) {
        __m256d const p = pairs(k), q = pairs(k + 2);
        return _mm256_permute2f128_pd(p, q, 0x20) + _mm256_permute2f128_pd(p, q, 0x31);
    };
    _mm256_storeu_pd(sums, four(0));
    _mm256_storeu_pd(sums + 4, four(4));
}
inline void sum_eight(Pack<float> const* a, double* sums) {
    Pack<double> halves[8];
    for (int k = 0; k < 8; ++k)
        halves[k] = Pack<double>(_mm256_cvtps_pd(_mm256_castps256_ps128(a[k].lanes)) +
                                 _mm256_cvtps_pd(_mm256_extractf128_ps(a[k].lanes, 1)));
    sum_eight(halves, sums);
}

inline unsigned lanes_below(Pack<double> const& values, double limit) {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(values.lanes, _mm256_set1_pd(limit), _CMP_LT_OQ)));
}
inline unsigned lanes_below(Pack<float> const& values, float limit) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(values.lanes, _mm256_set1_ps(limit), _CMP_LT_OQ)));
}

/// For every set of eight lanes, the numbers of its lanes one after another, a byte each.
inline constexpr auto squeezed_lanes = [] {
    struct {
        std::uint64_t of[256] = {};
    } table;
    for (unsigned held = 0; held < 256; ++held)
        for (unsigned lane = 0, next = 0; lane < 8; ++lane)
            if (held >> lane & 1u) table.of[held] |= static_cast<std::uint64_t>(lane) << 8 * next++;
    return table;
}();

template <class T, int step>
void squeeze_range(unsigned held, Index first, Index* to) {
    auto const lanes = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(squeezed_lanes.of[held])));
    auto const numbers = _mm256_add_epi32(_mm256_set1_epi32(first), _mm256_mullo_epi32(lanes, _mm256_set1_epi32(step)));
    if constexpr (sizeof(T) == 8) _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm256_castsi256_si128(numbers));
    else _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), numbers);
}

#else

template <class T>
void fetch_four(T const* first, Index const* place, Pack<T>* component) {
    for (int c = 0; c < 4; ++c)
        for (int lane = 0; lane < pack_size<T>; ++lane) component[c].lanes[lane] = first[place[lane] + c];
}
template <class T>
Pack<T> fetch_one(T const* first, Index const* place) {
    Pack<T> pack;
    for (int lane = 0; lane < pack_size<T>; ++lane) pack.lanes[lane] = first[place[lane]];
    return pack;
}
inline void scatter(Pack<double> const& a, double* first, Index const* place, int count) {
    for (int lane = 0; lane < count; ++lane) first[place[lane]] = a[lane];
}
template <class T>
void sum_eight(Pack<T> const* a, double* sums) {
    for (int k = 0; k < 8; ++k) sums[k] = sum(a[k]);
}
template <class T>
unsigned lanes_below(Pack<T> const& values, T limit) {
    unsigned held = 0;
    for (int lane = 0; lane < pack_size<T>; ++lane) held |= unsigned{values[lane] < limit} << lane;
    return held;
}
template <class T, int step>
void squeeze_range(unsigned held, Index first, Index* to) {
    for (int lane = 0; lane < pack_size<T>; ++lane) {
        *to = first + step * lane;
        to += held >> lane & 1u;
    }
}

#endif

}  // namespace coronet
