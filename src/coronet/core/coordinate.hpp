// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A coordinate as numbers of type T hold it, when only differences between neighbours are wanted. A double holds the
// coordinate itself. A float holds a fixed-point number instead: the bits of an integer, in units that the user of it
// chooses, without what lies beyond 32 bits. Such coordinates repeat after 2^32 units, and their difference is exact
// between particles nearer than half of that, wherever they are, while a float coordinate would lose digits with the
// distance from the origin.

#include <cmath>
#include <cstdint>
#include <cstring>

#include "coronet/core/pack.hpp"

namespace coronet {

template <class T>
struct Coordinate;

template <>
struct Coordinate<double> {
    explicit Coordinate(double /*unit*/) {}
    double stored(double x) const { return x; }
    Pack<double> difference(Pack<double> const& a, Pack<double> const& b) const { return a - b; }
};

template <>
struct Coordinate<float> {
    explicit Coordinate(double unit) : per_metre_(1 / unit), unit_(unit) {}

    /// `x` in m.
    float stored(double x) const {
        auto const steps = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(x * per_metre_ + 0.5)));
        float bits;
        std::memcpy(&bits, &steps, sizeof bits);
        return bits;
    }
    /// a - b in m, of stored coordinates.
    Pack<float> difference(Pack<float> const& a, Pack<float> const& b) const { return unit_ * steps(a, b); }
    /// The same in units.
    static Pack<float> steps(Pack<float> const& a, Pack<float> const& b) {
        typedef std::uint32_t Bits __attribute__((vector_size(sizeof(a.lanes))));
        typedef std::int32_t Steps __attribute__((vector_size(sizeof(a.lanes))));
        auto const apart = reinterpret_cast<Bits>(a.lanes) - reinterpret_cast<Bits>(b.lanes);
        return Pack<float>(__builtin_convertvector(reinterpret_cast<Steps>(apart), Pack<float>::Lanes));
    }

private:
    double per_metre_;
    Pack<float> unit_;
};

}  // namespace coronet
