// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/fields/particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <string_view>
#include <type_traits>
#include <vector>

namespace {

using namespace coronet;

// One field of each rank.
using OfEveryRank = Fields<Density, Velocity, Stress, CorrectedStress>;

template <class Check>
void in_every_dimension(Check const& check) {
    check.template operator()<1>();
    check.template operator()<2>();
    check.template operator()<3>();
}

/// A number that no other component of any field of any particle has.
double mark(std::int64_t id, int field, int component) {
    return 1000.0 * static_cast<double>(id) + 10.0 * field + component + 1;
}

template <int D, class Check>
void for_components(Check const& check) {
    for_fields(OfEveryRank{}, [&]<class F>(F) {
        for (int k = 0; k < components<F::rank, D>(); ++k) check.template operator()<F>(k);
    });
}

template <int D>
Particles<D> marked(std::size_t count) {
    Particles<D> particles(count);
    particles.allocate(OfEveryRank{});
    for_components<D>([&]<class F>(int k) {
        for (std::size_t i = 0; i < count; ++i) particles.template get<F>(k)[i] = mark(particles.id[i], F::number, k);
    });
    return particles;
}

template <int D>
void expect_marked(Particles<D> const& particles) {
    for_components<D>([&]<class F>(int k) {
        auto const values = particles.template get<F>(k);
        ASSERT_EQ(values.size(), particles.size());
        for (std::size_t i = 0; i < particles.size(); ++i)
            ASSERT_EQ(values[i], mark(particles.id[i], F::number, k)) << "particle " << i << ", component " << k;
    });
}

constexpr std::size_t counts[] = {0, 1, 7, 8, 9, items_per_block, 2 * items_per_block + 1};

TEST(Particles, AreNumberedInTheOrderTheyAreMade) {
    Particles<2> const particles(9);
    for (std::int64_t i = 0; i < 9; ++i) EXPECT_EQ(particles.id[static_cast<std::size_t>(i)], i);
    EXPECT_EQ(particles.size(), 9u);
}

TEST(Particles, KeepEveryFieldWithItsIdentityWhenReordered) {
    in_every_dimension([]<int D>() {
        std::mt19937 engine(1);
        for (std::size_t const count : counts) {
            auto particles = marked<D>(count);
            std::vector<Index> from(count);
            std::iota(from.begin(), from.end(), 0);
            for (int repetition = 0; repetition < 2; ++repetition) {
                std::shuffle(from.begin(), from.end(), engine);
                auto const before = particles.id;
                particles.reorder(from);
                for (std::size_t i = 0; i < count; ++i)
                    EXPECT_EQ(particles.id[i], before[static_cast<std::size_t>(from[i])]);
                expect_marked(particles);
            }
        }
    });
}

TEST(Particles, HaveZeroInNewFieldsAndKeepTheOldOnes) {
    in_every_dimension([]<int D>() {
        auto particles = marked<D>(9);
        EXPECT_FALSE(particles.template has<Pressure>());
        particles.allocate(Fields<Density, Pressure, Velocity, Position>{});
        EXPECT_TRUE(particles.template has<Pressure>());
        EXPECT_TRUE(particles.has(Position::number));
        EXPECT_FALSE(particles.has(Mass::number));
        expect_marked(particles);
        for (double const p : particles.template get<Pressure>()) EXPECT_EQ(p, 0);
        for (int k = 0; k < D; ++k)
            for (double const x : particles.template get<Position>(k)) EXPECT_EQ(x, 0);
    });
}

TEST(Particles, KeepFieldsMadeLaterWithTheRestWhenReordered) {
    auto particles = marked<2>(3);
    particles.allocate(Fields<Pressure>{});
    for (std::size_t i = 0; i < 3; ++i) particles.get<Pressure>()[i] = mark(particles.id[i], Pressure::number, 0);
    particles.reorder(std::vector<Index>{2, 0, 1});
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(particles.get<Pressure>()[i], mark(particles.id[i], Pressure::number, 0));
    EXPECT_EQ(particles.id, (std::vector<std::int64_t>{2, 0, 1}));
}

TEST(Particles, AreSeenThroughAViewAsTheyAre) {
    in_every_dimension([]<int D>() {
        auto const particles = marked<D>(11);
        auto const view = particles.view();
        for_fields(OfEveryRank{}, [&]<class F>(F) {
            for (std::size_t i = 0; i < 11; ++i) {
                auto const value = view.template get<F>(i);
                for (int k = 0; k < components<F::rank, D>(); ++k) {
                    EXPECT_EQ(component(value, k), mark(particles.id[i], F::number, k));
                    EXPECT_EQ(view.template at<F>(k)[i], mark(particles.id[i], F::number, k));
                }
            }
        });
    });
}

TEST(Particles, ChangeThroughAViewWhereItIsSetAndNowhereElse) {
    in_every_dimension([]<int D>() {
        auto particles = marked<D>(11);
        auto const view = particles.view();
        for_fields(OfEveryRank{}, [&]<class F>(F) {
            ValueOf<F, double, D> value{};
            for (int k = 0; k < components<F::rank, D>(); ++k) component(value, k) = -1 - k;
            auto const before = view.template get<F>(5);
            view.template set<F>(5, value);
            for (int k = 0; k < components<F::rank, D>(); ++k) EXPECT_EQ(particles.template get<F>(k)[5], -1 - k);
            view.template set<F>(5, before);
        });
        expect_marked(particles);
    });
}

TEST(Particles, HaveEveryComponentOnACacheLineOfItsOwn) {
    in_every_dimension([]<int D>() {
        for (std::size_t const count : counts) {
            auto particles = marked<D>(count);
            for_components<D>([&]<class F>(int k) {
                EXPECT_EQ(reinterpret_cast<std::uintptr_t>(particles.template get<F>(k).data()) % 64, 0u);
            });
        }
    });
}

TEST(Vocabulary, UnitesListsOfFieldsNamingEachOnce) {
    static_assert(std::is_same_v<Unite<>, Fields<>>);
    static_assert(std::is_same_v<Unite<Fields<Mass>>, Fields<Mass>>);
    static_assert(std::is_same_v<Unite<Fields<>, Fields<Mass>, Fields<>>, Fields<Mass>>);
    static_assert(std::is_same_v<Unite<Fields<Mass, Density>, Fields<Density, Mass>>, Fields<Mass, Density>>);
    static_assert(std::is_same_v<Unite<Fields<Mass>, Fields<Velocity, Mass>, Fields<Density, Velocity>>,
                                 Fields<Mass, Velocity, Density>>);
    SUCCEED();
}

TEST(Vocabulary, TellsOfEachFieldWhatItsTagSays) {
    EXPECT_EQ(field_info[Density::number].name, "Density");
    EXPECT_EQ(field_info[SampleSlope::number].name, "SampleSlope");  // the last
    for_fields(OfEveryRank{}, []<class F>(F) { EXPECT_EQ(field_info[F::number].rank, F::rank); });
    std::set<std::string_view> names, symbols;
    for (auto const& field : field_info) {
        names.insert(field.name);
        symbols.insert(field.symbol);
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(field_count));
    EXPECT_EQ(symbols.size(), static_cast<std::size_t>(field_count));
}

TEST(Vocabulary, HasAsManyComponentsAsTheValueHolds) {
    in_every_dimension([]<int D>() {
        static_assert(components<Rank::scalar, D>() == 1);
        static_assert(components<Rank::vector, D>() == Vector<double, D>::size);
        static_assert(components<Rank::symmetric, D>() == Symmetric<double, D>::size);
        static_assert(components<Rank::matrix, D>() == Matrix<double, D>::size);
    });
}

}  // namespace
