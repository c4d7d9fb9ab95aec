// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A pack: as many numbers as a vector register holds, with the arithmetic of one number, lane by lane. It wraps the
// vector types of g++ and clang; the moves that they have no words for are in simd.hpp. Without CORONET_SIMD a pack
// holds one number, so the same loops serve.

#include <algorithm>
#include <type_traits>

#include "coronet/core/real.hpp"

#if CORONET_SIMD && defined(__AVX__)
#include <immintrin.h>
#endif

namespace coronet {

#if !CORONET_SIMD
template <class T>
inline constexpr int pack_bytes = sizeof(T);
#elif defined(__AVX512F__)
template <class T>
inline constexpr int pack_bytes = 64;
#elif defined(__AVX__)
template <class T>
inline constexpr int pack_bytes = 32;
#else
template <class T>
inline constexpr int pack_bytes = 16;
#endif

template <class T>
inline constexpr int pack_size = pack_bytes<T> / static_cast<int>(sizeof(T));

template <class T>
struct Pack {
    typedef T Lanes __attribute__((vector_size(pack_bytes<T>)));
    using Mask = decltype(Lanes{} < Lanes{});

    Lanes lanes;

    Pack() = default;
    explicit Pack(Lanes const& values) : lanes(values) {}
    /// The same number in every lane.
    Pack(double number) : lanes(static_cast<T>(number) - Lanes{}) {}
    /// The same bits in every lane, whatever they stand for.
    static Pack copies(T const& bits) {
        using Whole = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
        typedef Whole Wholes __attribute__((vector_size(pack_bytes<T>)));
        return Pack(reinterpret_cast<Lanes>(__builtin_bit_cast(Whole, bits) - Wholes{}));
    }

    T operator[](int lane) const { return lanes[lane]; }

    Pack operator-() const { return Pack(-lanes); }
    Pack& operator+=(Pack const& b) { return *this = *this + b; }
    Pack& operator-=(Pack const& b) { return *this = *this - b; }
    Pack& operator*=(Pack const& b) { return *this = *this * b; }

    friend Pack operator+(Pack const& a, Pack const& b) { return Pack(a.lanes + b.lanes); }
    friend Pack operator-(Pack const& a, Pack const& b) { return Pack(a.lanes - b.lanes); }
    friend Pack operator*(Pack const& a, Pack const& b) { return Pack(a.lanes * b.lanes); }
    friend Pack operator/(Pack const& a, Pack const& b) { return Pack(a.lanes / b.lanes); }
    friend Mask operator<(Pack const& a, Pack const& b) { return a.lanes < b.lanes; }
    friend Mask operator>(Pack const& a, Pack const& b) { return a.lanes > b.lanes; }
};

/// A pack from any address.
template <class T>
Pack<T> load(T const* from) {
    Pack<T> pack;
    __builtin_memcpy(&pack.lanes, from, sizeof pack.lanes);
    return pack;
}
template <class T>
void store(Pack<T> const& pack, T* to) {
    __builtin_memcpy(to, &pack.lanes, sizeof pack.lanes);
}

/// Packs that are zero in their first lanes and a number in those behind.
template <class T>
class ZerosThen {
public:
    explicit ZerosThen(double number) {
        std::fill_n(lanes_, pack_size<T>, T(0));
        std::fill_n(lanes_ + pack_size<T>, pack_size<T>, static_cast<T>(number));
    }
    /// Zero in the first `count` lanes, in all of them if there are fewer.
    Pack<T> after(std::size_t count) const {
        return load(lanes_ + pack_size<T> - std::min<std::size_t>(count, pack_size<T>));
    }

private:
    alignas(pack_bytes<T>) T lanes_[2 * pack_size<T>];
};

template <>
inline constexpr double nearest_square<Pack<float>> = 1e-14;

// What laws call on any number type, found by the type of its arguments. `sum` adds the lanes in double.

template <class T>
Pack<T> select(typename Pack<T>::Mask mask, Pack<T> const& a, Pack<T> const& b) {
    return Pack<T>(mask ? a.lanes : b.lanes);
}

template <class T, class Function>
Pack<T> lane_by_lane(Pack<T> a, Function const& f) {
    for (int lane = 0; lane < pack_size<T>; ++lane) a.lanes[lane] = static_cast<T>(f(a[lane]));
    return a;
}

#if CORONET_SIMD && defined(__AVX512F__)

inline Pack<double> largest(Pack<double> const& a, Pack<double> const& b) {
    return Pack<double>(_mm512_max_pd(a.lanes, b.lanes));
}
inline Pack<float> largest(Pack<float> const& a, Pack<float> const& b) {
    return Pack<float>(_mm512_max_ps(a.lanes, b.lanes));
}
inline Pack<double> smallest(Pack<double> const& a, Pack<double> const& b) {
    return Pack<double>(_mm512_min_pd(a.lanes, b.lanes));
}
inline Pack<float> smallest(Pack<float> const& a, Pack<float> const& b) {
    return Pack<float>(_mm512_min_ps(a.lanes, b.lanes));
}

inline double sum(Pack<double> const& a) { return _mm512_reduce_add_pd(a.lanes); }
inline double sum(Pack<float> const& a) {
    __m256 const low = _mm512_castps512_ps256(a.lanes);
    __m256 const high = _mm256_castpd_ps(_mm512_extractf64x4_pd(_mm512_castps_pd(a.lanes), 1));
    return _mm512_reduce_add_pd(_mm512_cvtps_pd(low) + _mm512_cvtps_pd(high));
}

inline Pack<double> square_root(Pack<double> const& a) { return Pack<double>(_mm512_sqrt_pd(a.lanes)); }
inline Pack<float> square_root(Pack<float> const& a) { return Pack<float>(_mm512_sqrt_ps(a.lanes)); }

/// The roots of a > 0 to a unit or two in the last place. From the 14 bits of 1/sqrt(a) that the processor
/// looks up, with e = 1 - a y^2: 1/sqrt(a) = y (1 + e/2 + 3 e^2/8 + 5 e^3/16 + O(e^4)); float needs one term less. A
/// root and a division would keep the divider busy for longer than the rest of a pair takes.
inline Roots<Pack<double>> roots(Pack<double> const& a) {
    Pack<double> const y(_mm512_rsqrt14_pd(a.lanes));
    Pack<double> const e = 1.0 - a * y * y;
    Pack<double> const inverse = y + y * (e * (0.5 + e * (0.375 + e * 0.3125)));
    return {a * inverse, inverse};
}
inline Roots<Pack<float>> roots(Pack<float> const& a) {
    Pack<float> const y(_mm512_rsqrt14_ps(a.lanes));
    Pack<float> const e = 1.0 - a * y * y;
    Pack<float> const inverse = y + y * (e * (0.5 + e * 0.375));
    return {a * inverse, inverse};
}

#elif CORONET_SIMD && defined(__AVX2__) && defined(__FMA__)

inline Pack<double> largest(Pack<double> const& a, Pack<double> const& b) {
    return Pack<double>(_mm256_max_pd(a.lanes, b.lanes));
}
inline Pack<float> largest(Pack<float> const& a, Pack<float> const& b) {
    return Pack<float>(_mm256_max_ps(a.lanes, b.lanes));
}
inline Pack<double> smallest(Pack<double> const& a, Pack<double> const& b) {
    return Pack<double>(_mm256_min_pd(a.lanes, b.lanes));
}
inline Pack<float> smallest(Pack<float> const& a, Pack<float> const& b) {
    return Pack<float>(_mm256_min_ps(a.lanes, b.lanes));
}

inline double sum(Pack<double> const& a) {
    __m128d const halves = _mm256_castpd256_pd128(a.lanes) + _mm256_extractf128_pd(a.lanes, 1);
    return halves[0] + halves[1];
}
inline double sum(Pack<float> const& a) {
    return sum(Pack<double>(_mm256_cvtps_pd(_mm256_castps256_ps128(a.lanes)) +
                            _mm256_cvtps_pd(_mm256_extractf128_ps(a.lanes, 1))));
}

inline Pack<double> square_root(Pack<double> const& a) { return Pack<double>(_mm256_sqrt_pd(a.lanes)); }
inline Pack<float> square_root(Pack<float> const& a) { return Pack<float>(_mm256_sqrt_ps(a.lanes)); }

#else

template <class T>
Pack<T> largest(Pack<T> const& a, Pack<T> const& b) {
    return select(a > b, a, b);
}
template <class T>
Pack<T> smallest(Pack<T> const& a, Pack<T> const& b) {
    return select(a < b, a, b);
}

template <class T>
double sum(Pack<T> const& a) {
    double total = 0;
    for (int lane = 0; lane < pack_size<T>; ++lane) total += static_cast<double>(a[lane]);
    return total;
}

template <class T>
Pack<T> square_root(Pack<T> a) {
    for (int lane = 0; lane < pack_size<T>; ++lane) a.lanes[lane] = std::sqrt(a[lane]);
    return a;
}
#endif

// The other instruction sets: there the divider is idle otherwise, and what can be looked up has fewer bits.
#if !(CORONET_SIMD && defined(__AVX512F__))
template <class T>
Roots<Pack<T>> roots(Pack<T> const& a) {
    Pack<T> const root = square_root(a);
    return {root, 1.0 / root};
}
#endif

}  // namespace coronet
