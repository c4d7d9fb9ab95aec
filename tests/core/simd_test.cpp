// SPDX-License-Identifier: BSD-3-Clause

// Every move of a pack does what a plain loop over its lanes does, for every choice of lanes. The same tests
// hold for the vector instructions of the processor and for the plain versions, of packs of any size down to
// one number.
#include "coronet/core/simd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using coronet::Index, coronet::Pack, coronet::pack_size;

constexpr unsigned all_lanes = (1u << pack_size) - 1;

template <class P>
double lane(P const& pack, int k) {
    if constexpr (pack_size == 1) return pack;
    else return pack[k];
}

/// Numbers that no two lanes share.
std::vector<double> distinct(std::size_t size) {
    std::vector<double> numbers(size);
    for (std::size_t k = 0; k < size; ++k) numbers[k] = 0.5 + static_cast<double>(k);
    return numbers;
}

TEST(Pack, IsLoadedFromAnyAddress) {
    auto const numbers = distinct(3 * pack_size);
    for (int start = 0; start < 2 * pack_size; ++start) {
        auto const pack = coronet::load(numbers.data() + start);
        for (int k = 0; k < pack_size; ++k) EXPECT_EQ(lane(pack, k), numbers[start + k]);
    }
}

TEST(Pack, IsFetchedFromTheRecordsItsIndicesPointTo) {
    constexpr std::size_t records = 200, width = 12;
    auto const numbers = distinct(records * width + 4);
    alignas(64) static double first[records * width];
    std::copy_n(numbers.begin(), records * width, first);
    std::mt19937 engine(1);
    std::uniform_int_distribution<Index> place(0, records - 1);
    std::vector<Index> index(100 + pack_size);
    for (Index& i : index) i = place(engine);
    index[0] = index[1] = 0;  // the ends, and a record twice
    index[2] = records - 1;
    for (std::size_t group = 0; group < width; group += 4)
        for (int start = 0; start < 100; ++start) {
            Pack<double> component[4];
            coronet::fetch_four(first + group, index.data() + start, width, component);
            for (std::size_t c = 0; c < 4; ++c)
                for (int k = 0; k < pack_size; ++k)
                    EXPECT_EQ(lane(component[c], k),
                              first[static_cast<std::size_t>(index[start + k]) * width + group + c]);
        }
}

TEST(Pack, InverseRootIsRightToTwoUnitsInTheLastPlace) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> exponent(-60, 60);
    for (int n = 0; n < 10000; ++n) {
        double numbers[pack_size];
        for (double& number : numbers) number = std::pow(10.0, exponent(engine));
        auto const root = coronet::inverse_root(coronet::load(numbers));
        for (int k = 0; k < pack_size; ++k) EXPECT_NEAR(lane(root, k) * std::sqrt(numbers[k]), 1, 5e-16) << numbers[k];
    }
}

TEST(Pack, TellsWhichLanesAreBelowALimit) {
    std::vector<double> const numbers{0.0,      -0.0,      1.0,   std::nextafter(1, 0), std::nextafter(1, 2), -1, NAN,
                                      INFINITY, -INFINITY, 5e-324};
    for (double const limit : std::vector<double>{0.0, 1.0, -1.0, INFINITY, -INFINITY, NAN, 1e-300})
        for (std::size_t start = 0; start < numbers.size(); ++start) {
            double lanes[pack_size];
            unsigned expected = 0;
            for (int k = 0; k < pack_size; ++k) {
                lanes[k] = numbers[(start + k) % numbers.size()];
                if (lanes[k] < limit) expected |= 1u << k;
            }
            EXPECT_EQ(coronet::lanes_below(coronet::load(lanes), limit), expected) << limit;
        }
}

/// Squeezing may write a whole pack, but nothing behind it, and first the chosen lanes in their order.
template <class T, class Squeeze, class Lane>
void expect_squeezed(Squeeze const& squeeze, Lane const& value_of) {
    for (unsigned held = 0; held <= all_lanes; ++held) {
        T const untouched = -7;
        std::vector<T> to(2 * pack_size, untouched);
        squeeze(held, to.data());
        int count = 0;
        for (int k = 0; k < pack_size; ++k)
            if (held >> k & 1u) {
                EXPECT_EQ(to[count], value_of(k)) << "of lanes " << held;
                ++count;
            }
        for (int k = pack_size; k < 2 * pack_size; ++k) EXPECT_EQ(to[k], untouched) << "of lanes " << held;
    }
}

TEST(Pack, SqueezesTheChosenIndicesToTheFront) {
    std::vector<Index> index(pack_size);
    for (int k = 0; k < pack_size; ++k) index[k] = 2'000'000'000 - 1000 * k;
    expect_squeezed<Index>([&](unsigned held, Index* to) { coronet::squeeze(held, index.data(), to); },
                           [&](int k) { return index[k]; });
}

TEST(Pack, SqueezesTheChosenOfARangeToTheFront) {
    for (Index const first : {0, 5, 2'000'000'000})
        expect_squeezed<Index>([&](unsigned held, Index* to) { coronet::squeeze_range(held, first, to); },
                               [&](int k) { return first + k; });
}

TEST(Pack, SelectsComparesAndSumsLaneByLane) {
    std::vector<double> a = distinct(pack_size), b(pack_size);
    double total = 0;
    for (int k = 0; k < pack_size; ++k) {
        b[k] = k % 2 ? a[k] + 1 : a[k] - 1;
        total += a[k];
    }
    auto const x = coronet::load(a.data()), y = coronet::load(b.data());
    for (int k = 0; k < pack_size; ++k) {
        EXPECT_EQ(lane(coronet::select(x < y, 3.0 * x, -y), k), a[k] < b[k] ? 3 * a[k] : -b[k]);
        EXPECT_EQ(lane(coronet::largest(x, y), k), std::fmax(a[k], b[k]));
        EXPECT_EQ(lane(coronet::smallest(x, y), k), std::fmin(a[k], b[k]));
        EXPECT_EQ(lane(coronet::square_root(x), k), std::sqrt(a[k]));
    }
    EXPECT_EQ(coronet::sum(x), total);  // halves: exact in any order
}

}  // namespace
