// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Numbers without a pattern that are the same on every machine and for any number of threads: each depends on three
// integers alone (splitmix64 of D. Lea, G. L. Steele and S. Vigna).

#include <cstdint>

namespace coronet {

/// In [0, 1).
inline double random(std::uint64_t seed, std::uint64_t particle, std::uint64_t axis) {
    std::uint64_t z = seed * 0x9E3779B97F4A7C15u + particle * 0xD1B54A32D192ED03u + axis * 0x8CB92BA72F3D8DD7u;
    for (int round = 0; round < 2; ++round) {
        z += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        z ^= z >> 31;
    }
    return static_cast<double>(z >> 11) * 0x1p-53;
}

}  // namespace coronet
