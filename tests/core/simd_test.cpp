// SPDX-License-Identifier: BSD-3-Clause

// Every move of a pack does what a plain loop over its lanes does, for every choice of lanes. The same tests hold for
// the vector instructions of the processor and for the plain versions, of packs of any size down to one number.
#include "coronet/core/simd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "coronet/core/coordinate.hpp"

namespace {

using coronet::Index, coronet::Pack, coronet::pack_size, coronet::Coordinate;

template <class T>
class PackOf : public testing::Test {};
using Numbers = testing::Types<double, float>;
TYPED_TEST_SUITE(PackOf, Numbers);

/// Numbers that no two lanes share, exact in float.
template <class T>
std::vector<T> distinct(std::size_t size) {
    std::vector<T> numbers(size);
    for (std::size_t k = 0; k < size; ++k) numbers[k] = static_cast<T>(0.5 + static_cast<double>(k));
    return numbers;
}

TYPED_TEST(PackOf, IsLoadedFromAnyAddress) {
    using T = TypeParam;
    auto const numbers = distinct<T>(3 * pack_size<T>);
    for (int start = 0; start < 2 * pack_size<T>; ++start) {
        auto const pack = coronet::load(numbers.data() + start);
        for (int k = 0; k < pack_size<T>; ++k) EXPECT_EQ(pack[k], numbers[start + k]);
    }
}

TYPED_TEST(PackOf, IsFetchedFromTheGroupsItsPlacesPointTo) {
    using T = TypeParam;
    constexpr std::size_t groups = 300;
    auto const numbers = distinct<T>(4 * groups);
    alignas(64) static T first[4 * groups];
    std::ranges::copy(numbers, first);
    std::mt19937 engine(1);
    std::uniform_int_distribution<Index> group(0, groups - 1);
    std::vector<Index> place(100 + pack_size<T>);
    for (Index& at : place) at = 4 * group(engine);
    place[0] = place[1] = 0;  // the ends, and a group twice
    place[2] = 4 * (groups - 1);
    for (int start = 0; start < 100; ++start) {
        Pack<T> component[4];
        coronet::fetch_four(first, place.data() + start, component);
        for (int c = 0; c < 4; ++c)
            for (int k = 0; k < pack_size<T>; ++k) EXPECT_EQ(component[c][k], first[place[start + k] + c]);
    }
}

TYPED_TEST(PackOf, RootsAreRightToUnitsInTheLastPlace) {
    using T = TypeParam;
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> exponent(-30, 30);
    for (int n = 0; n < 10000; ++n) {
        T numbers[pack_size<T>];
        for (T& number : numbers) number = static_cast<T>(std::pow(10.0, exponent(engine)));
        auto const [root, inverse] = coronet::roots(coronet::load(numbers));
        double const eps = std::numeric_limits<T>::epsilon();
        for (int k = 0; k < pack_size<T>; ++k) {
            double const exact = std::sqrt(static_cast<double>(numbers[k]));
            EXPECT_NEAR(static_cast<double>(inverse[k]) * exact, 1, 2.25 * eps) << numbers[k];
            EXPECT_NEAR(static_cast<double>(root[k]) / exact, 1, 2.75 * eps) << numbers[k];  // a product more
        }
    }
}

TYPED_TEST(PackOf, TellsWhichLanesAreBelowALimit) {
    using T = TypeParam;
    using Limits = std::numeric_limits<T>;
    T const one = 1;
    std::vector<T> const numbers{0,
                                 -T(0),
                                 one,
                                 std::nextafter(one, T(0)),
                                 std::nextafter(one, T(2)),
                                 -1,
                                 Limits::quiet_NaN(),
                                 Limits::infinity(),
                                 -Limits::infinity(),
                                 Limits::denorm_min()};
    for (T const limit : {T(0), one, -one, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), T(1e-30)})
        for (std::size_t start = 0; start < numbers.size(); ++start) {
            T lanes[pack_size<T>];
            unsigned expected = 0;
            for (int k = 0; k < pack_size<T>; ++k) {
                lanes[k] = numbers[(start + static_cast<std::size_t>(k)) % numbers.size()];
                if (lanes[k] < limit) expected |= 1u << k;
            }
            EXPECT_EQ(coronet::lanes_below(coronet::load(lanes), limit), expected) << limit;
        }
}

TYPED_TEST(PackOf, IsZeroInItsFirstLanesAndANumberBehind) {
    using T = TypeParam;
    coronet::ZerosThen<T> const zeros_then(-7);
    for (std::size_t count = 0; count < 300; ++count) {
        auto const pack = zeros_then.after(count);
        for (std::size_t k = 0; k < pack_size<T>; ++k) EXPECT_EQ(pack[static_cast<int>(k)], k < count ? 0 : -7);
    }
}

/// Squeezing may write a whole pack, but nothing behind it, and first the chosen lanes in their order.
TYPED_TEST(PackOf, SqueezesTheChosenOfARangeToTheFront) {
    using T = TypeParam;
    constexpr unsigned all_lanes = (1u << pack_size<T>)-1;
    Index const untouched = -7;
    for (Index const first : {0, 5, 2'000'000'000})
        for (unsigned held = 0; held <= all_lanes; held += 1 + held / 1000) {
            std::vector<Index> to(2 * pack_size<T>, untouched);
            coronet::squeeze_range<T, 4>(held, first, to.data());
            std::size_t count = 0;
            for (int k = 0; k < pack_size<T>; ++k)
                if (held >> k & 1u) {
                    ASSERT_EQ(to[count], first + 4 * k) << "of lanes " << held;
                    ++count;
                }
            for (std::size_t k = pack_size<T>; k < to.size(); ++k) ASSERT_EQ(to[k], untouched) << "of lanes " << held;
        }
}

TYPED_TEST(PackOf, SelectsComparesAndSumsLaneByLane) {
    using T = TypeParam;
    std::vector<T> a = distinct<T>(pack_size<T>), b(pack_size<T>);
    double total = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        b[k] = k % 2 ? a[k] + 1 : a[k] - 1;
        total += static_cast<double>(a[k]);
    }
    auto const x = coronet::load(a.data()), y = coronet::load(b.data());
    for (int k = 0; k < pack_size<T>; ++k) {
        T const p = a[static_cast<std::size_t>(k)], q = b[static_cast<std::size_t>(k)];
        EXPECT_EQ(coronet::select(x < y, 3.0 * x, -y)[k], p < q ? 3 * p : -q);
        EXPECT_EQ(coronet::largest(x, y)[k], std::fmax(p, q));
        EXPECT_EQ(coronet::smallest(x, y)[k], std::fmin(p, q));
        EXPECT_EQ(coronet::square_root(x)[k], std::sqrt(p));
        EXPECT_EQ((x / y)[k], p / q);
    }
    EXPECT_EQ(coronet::sum(x), total);  // halves: exact in any order
}

/// The sum of a pack of floats keeps what a float could not.
TEST(PackOfFloats, IsSummedInDouble) {
    if (pack_size<float> < 2) GTEST_SKIP() << "a pack holds one number";
    std::vector<float> numbers(pack_size<float>, 0);
    numbers[0] = 1;
    numbers[1] = 0x1p-30f;
    EXPECT_EQ(coronet::sum(coronet::load(numbers.data())), 1 + 0x1p-30);
}

TEST(FixedPointCoordinate, HasExactDifferencesFarFromTheOrigin) {
    double const unit = 0x1p-30;
    Coordinate<float> const coordinate(unit);
    std::mt19937_64 engine(1);
    std::uniform_int_distribution<std::int64_t> far(-(1ll << 50), 1ll << 50), near(-(1ll << 23), 1ll << 23);
    for (int n = 0; n < 10000; ++n) {
        std::int64_t const a = far(engine), apart = near(engine);
        auto const x = Pack<float>::copies(coordinate.stored(static_cast<double>(a) * unit));
        auto const y = Pack<float>::copies(coordinate.stored(static_cast<double>(a + apart) * unit));
        for (int k = 0; k < pack_size<float>; ++k)
            ASSERT_EQ(coordinate.difference(y, x)[k], static_cast<double>(apart) * unit) << a << " + " << apart;
    }
}

}  // namespace
