// SPDX-License-Identifier: BSD-3-Clause

// The components are small whole numbers, so every sum and product is exact and every comparison too.
#include "coronet/core/tensor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace {

using coronet::Matrix, coronet::Symmetric, coronet::Vector;

template <class T>
T whole_numbers() {
    static std::mt19937 engine(1);
    static std::uniform_int_distribution<int> entry(-9, 9);
    T t;
    for (double& c : t.c) c = entry(engine);
    return t;
}

template <class Check>
void in_every_dimension(Check const& check) {
    for (int sample = 0; sample < 100; ++sample) {
        check.template operator()<1>();
        check.template operator()<2>();
        check.template operator()<3>();
    }
}

template <class T>
void expect_same(T const& a, T const& b) {
    for (int k = 0; k < T::size; ++k) EXPECT_EQ(a.c[k], b.c[k]) << "component " << k;
}

/// The determinant as Leibniz has it: a signed product for every permutation of the columns.
template <int D>
double leibniz(Matrix<double, D> const& a) {
    std::array<int, D> column;
    std::iota(column.begin(), column.end(), 0);
    double total = 0;
    do {
        double part = 1;
        for (int i = 0; i < D; ++i) {
            part *= a(i, column[i]);
            for (int k = 0; k < i; ++k)
                if (column[k] > column[i]) part = -part;
        }
        total += part;
    } while (std::next_permutation(column.begin(), column.end()));
    return total;
}

template <int D>
void expect_adjugate(Matrix<double, D> const& a) {
    auto const expected = coronet::determinant(a) * coronet::identity<double, D>();
    expect_same(coronet::product<double, D>(a, adjugate(a)), expected);
    expect_same(coronet::product<double, D>(adjugate(a), a), expected);
}

TEST(Tensor, TimesItsAdjugateIsItsDeterminant) {
    in_every_dimension([]<int D>() { expect_adjugate(whole_numbers<Matrix<double, D>>()); });
}

TEST(Tensor, TimesItsAdjugateIsZeroWhereItIsSingular) {
    in_every_dimension([]<int D>() {
        expect_adjugate(Matrix<double, D>{});
        if constexpr (D > 1) {
            auto const dyad = outer(whole_numbers<Vector<double, D>>(), whole_numbers<Vector<double, D>>());
            EXPECT_EQ(determinant(dyad), 0);
            expect_adjugate(dyad);
            auto flat = whole_numbers<Matrix<double, D>>();
            for (int k = 0; k < D; ++k) flat(D - 1, k) = D == 2 ? 3 * flat(0, k) : flat(0, k) - 2 * flat(1, k);
            EXPECT_EQ(determinant(flat), 0);
            expect_adjugate(flat);
        }
    });
}

TEST(Tensor, OfRankTwoHasAnAdjugateThatIsNotZero) {
    // What distinguishes the adjugate from any other matrix whose product with a singular one vanishes.
    Matrix<double, 3> const flat{{1, 0, 0, 0, 2, 0, 0, 0, 0}};
    expect_same(adjugate(flat), Matrix<double, 3>{{0, 0, 0, 0, 0, 0, 0, 0, 2}});
}

TEST(Tensor, HasTheDeterminantOfLeibniz) {
    in_every_dimension([]<int D>() {
        auto const a = whole_numbers<Matrix<double, D>>();
        EXPECT_EQ(determinant(a), leibniz(a));
        EXPECT_EQ(determinant(transpose(a)), leibniz(a));
    });
}

TEST(Tensor, SymmetricKeepsItsComponentsInTheOrderOfVtk) {
    using S2 = Symmetric<double, 2>;
    using S3 = Symmetric<double, 3>;
    EXPECT_EQ((std::array{S2::at(0, 0), S2::at(1, 1), S2::at(0, 1)}), (std::array{0, 1, 2}));
    EXPECT_EQ((std::array{S3::at(0, 0), S3::at(1, 1), S3::at(2, 2), S3::at(0, 1), S3::at(1, 2), S3::at(0, 2)}),
              (std::array{0, 1, 2, 3, 4, 5}));
}

TEST(Tensor, SymmetricHasOnePlaceForBothOrdersOfIndices) {
    in_every_dimension([]<int D>() {
        std::set<int> places;
        for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b) {
                places.insert(Symmetric<double, D>::at(a, b));
                EXPECT_EQ((Symmetric<double, D>::at(a, b)), (Symmetric<double, D>::at(b, a)));
            }
        EXPECT_EQ(places.size(), (Symmetric<double, D>::size));
        EXPECT_EQ(*places.begin(), 0);
        EXPECT_EQ(*places.rbegin(), (Symmetric<double, D>::size) - 1);
    });
}

template <class T>
void expect_arithmetic() {
    auto const a = whole_numbers<T>(), b = whole_numbers<T>();
    auto sum = a;
    sum += b;
    for (int k = 0; k < T::size; ++k) {
        EXPECT_EQ((a + b).c[k], a.c[k] + b.c[k]);
        EXPECT_EQ(sum.c[k], a.c[k] + b.c[k]);
        EXPECT_EQ((a - b).c[k], a.c[k] - b.c[k]);
        EXPECT_EQ((3.0 * a).c[k], 3 * a.c[k]);
        EXPECT_EQ((-a).c[k], -a.c[k]);
    }
}

TEST(Tensor, AddsAndScalesComponentByComponent) {
    in_every_dimension([]<int D>() {
        expect_arithmetic<Vector<double, D>>();
        expect_arithmetic<Symmetric<double, D>>();
        expect_arithmetic<Matrix<double, D>>();
    });
}

template <int D, class A>
void expect_times_vector(A const& a) {
    auto const x = whole_numbers<Vector<double, D>>();
    for (int k = 0; k < D; ++k) {
        double row = 0;
        for (int l = 0; l < D; ++l) row += a(k, l) * x[l];
        EXPECT_EQ((a * x)[k], row);
    }
}

template <int D, class A, class B>
void expect_product(A const& a, B const& b) {
    auto const ab = coronet::product<double, D>(a, b);
    for (int i = 0; i < D; ++i)
        for (int k = 0; k < D; ++k) {
            double entry = 0;
            for (int l = 0; l < D; ++l) entry += a(i, l) * b(l, k);
            EXPECT_EQ(ab(i, k), entry);
        }
}

TEST(Tensor, MultipliesAsRowsTimesColumns) {
    in_every_dimension([]<int D>() {
        auto const m = whole_numbers<Matrix<double, D>>(), n = whole_numbers<Matrix<double, D>>();
        auto const s = whole_numbers<Symmetric<double, D>>(), t = whole_numbers<Symmetric<double, D>>();
        expect_times_vector<D>(m);
        expect_times_vector<D>(s);
        expect_product<D>(m, n);
        expect_product<D>(s, m);
        expect_product<D>(m, s);
        expect_product<D>(s, t);
    });
}

TEST(Tensor, MakesDyadsOfVectors) {
    in_every_dimension([]<int D>() {
        auto const a = whole_numbers<Vector<double, D>>(), b = whole_numbers<Vector<double, D>>();
        double scalar = 0, length2 = 0;
        for (int k = 0; k < D; ++k) {
            scalar += a[k] * b[k];
            length2 += a[k] * a[k];
            for (int l = 0; l < D; ++l) {
                EXPECT_EQ(outer(a, b)(k, l), a[k] * b[l]);
                EXPECT_EQ(outer_of_parallels(a, a)(k, l), a[k] * a[l]);
            }
        }
        EXPECT_EQ(dot(a, b), scalar);
        EXPECT_EQ(norm2(a), length2);
    });
}

TEST(Tensor, HasTransposeTraceAndNorm) {
    in_every_dimension([]<int D>() {
        auto const a = whole_numbers<Matrix<double, D>>();
        double diagonal = 0, squares = 0;
        for (int k = 0; k < D; ++k) {
            diagonal += a(k, k);
            for (int l = 0; l < D; ++l) {
                squares += a(k, l) * a(k, l);
                EXPECT_EQ(transpose(a)(k, l), a(l, k));
                EXPECT_EQ((coronet::identity<double, D>()(k, l)), k == l ? 1 : 0);
            }
        }
        EXPECT_EQ(trace(a), diagonal);
        EXPECT_EQ(norm2(a), squares);
    });
}

}  // namespace
