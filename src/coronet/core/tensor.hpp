// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Small vectors, symmetric tensors and square matrices of R in D = 1, 2 or 3 dimensions. Plain aggregates: they live in
// registers, on the host and on a GPU alike.

#include <utility>

#include "coronet/core/real.hpp"

namespace coronet {

template <class R, int D>
struct Vector {
    static constexpr int size = D;
    R c[D] = {};
    CORONET_HD constexpr R& operator[](int k) { return c[k]; }
    CORONET_HD constexpr R const& operator[](int k) const { return c[k]; }
};

/// A symmetric tensor, stored xx, yy, (zz,) xy, (yz, xz): the order in which VTK and ParaView expect the components.
template <class R, int D>
struct Symmetric {
    static constexpr int size = D * (D + 1) / 2;
    R c[size] = {};
    CORONET_HD static constexpr int at(int a, int b) {
        if (a == b) return a;
        if (D == 2) return 2;
        return a + b == 1 ? 3 : a + b == 3 ? 4 : 5;
    }
    CORONET_HD constexpr R& operator()(int a, int b) { return c[at(a, b)]; }
    CORONET_HD constexpr R const& operator()(int a, int b) const { return c[at(a, b)]; }
    CORONET_HD constexpr R& operator[](int k) { return c[k]; }
    CORONET_HD constexpr R const& operator[](int k) const { return c[k]; }
};

/// A square matrix, row by row.
template <class R, int D>
struct Matrix {
    static constexpr int size = D * D;
    R c[size] = {};
    CORONET_HD constexpr R& operator()(int a, int b) { return c[a * D + b]; }
    CORONET_HD constexpr R const& operator()(int a, int b) const { return c[a * D + b]; }
    CORONET_HD constexpr R& operator[](int k) { return c[k]; }
    CORONET_HD constexpr R const& operator[](int k) const { return c[k]; }
};

/// act(0), act(1), ..., act(n - 1) without a loop: loops over components hide from the compiler, until it is too late,
/// that each of them can live in a register.
template <int n, class Act>
CORONET_HD constexpr void unrolled(Act const& act) {
    [&]<int... k>(std::integer_sequence<int, k...>) { (act(k), ...); }
    (std::make_integer_sequence<int, n>{});
}

template <class T>
concept Tensor = requires(T t) {
    T::size;
    t.c[0];
};

template <Tensor T>
CORONET_HD constexpr T operator+(T a, T const& b) {
    unrolled<T::size>([&](int k) { a.c[k] += b.c[k]; });
    return a;
}
template <Tensor T>
CORONET_HD constexpr T operator-(T a, T const& b) {
    unrolled<T::size>([&](int k) { a.c[k] -= b.c[k]; });
    return a;
}
template <Tensor T>
CORONET_HD constexpr T& operator+=(T& a, T const& b) {
    unrolled<T::size>([&](int k) { a.c[k] += b.c[k]; });
    return a;
}
template <class S, Tensor T>
CORONET_HD constexpr T operator*(S const& s, T a) {
    unrolled<T::size>([&](int k) { a.c[k] = s * a.c[k]; });
    return a;
}
template <Tensor T>
CORONET_HD constexpr T operator-(T a) {
    unrolled<T::size>([&](int k) { a.c[k] = -a.c[k]; });
    return a;
}

/// A vector of doubles as one of another number type.
template <class R, int D>
CORONET_HD constexpr Vector<R, D> numbers(Vector<double, D> const& a) {
    Vector<R, D> r;
    unrolled<D>([&](int k) { r[k] = R(a[k]); });
    return r;
}

template <class R, int D>
CORONET_HD constexpr R dot(Vector<R, D> const& a, Vector<R, D> const& b) {
    R s = a[0] * b[0];
    unrolled<D - 1>([&](int k) { s += a[k + 1] * b[k + 1]; });
    return s;
}
template <class R, int D>
CORONET_HD constexpr R norm2(Vector<R, D> const& a) {
    return dot(a, a);
}

template <class R, int D>
CORONET_HD constexpr Vector<R, D> operator*(Symmetric<R, D> const& a, Vector<R, D> const& b) {
    Vector<R, D> r;
    unrolled<D>([&](int k) { r[k] = a(k, 0) * b[0]; });
    unrolled<D*(D - 1)>([&](int kl) { r[kl % D] += a(kl % D, kl / D + 1) * b[kl / D + 1]; });
    return r;
}
template <class R, int D>
CORONET_HD constexpr Vector<R, D> operator*(Matrix<R, D> const& a, Vector<R, D> const& b) {
    Vector<R, D> r;
    unrolled<D>([&](int k) { r[k] = a(k, 0) * b[0]; });
    unrolled<D*(D - 1)>([&](int kl) { r[kl % D] += a(kl % D, kl / D + 1) * b[kl / D + 1]; });
    return r;
}
/// Products of small matrices, of any two kinds with operator()(row, column).
template <class R, int D, class A, class B>
CORONET_HD constexpr Matrix<R, D> product(A const& a, B const& b) {
    Matrix<R, D> r;
    unrolled<D * D * D>([&](int n) {
        int const i = n / (D * D), k = n / D % D, l = n % D;
        r(i, k) += a(i, l) * b(l, k);
    });
    return r;
}
template <class R, int D>
CORONET_HD constexpr Matrix<R, D> outer(Vector<R, D> const& a, Vector<R, D> const& b) {
    Matrix<R, D> r;
    unrolled<D * D>([&](int kl) { r[kl] = a[kl / D] * b[kl % D]; });
    return r;
}
/// The same for parallel vectors, whose outer product is symmetric.
template <class R, int D>
CORONET_HD constexpr Symmetric<R, D> outer_of_parallels(Vector<R, D> const& a, Vector<R, D> const& b) {
    Symmetric<R, D> r;
    unrolled<D * D>([&](int kl) {
        if (kl / D <= kl % D) r(kl / D, kl % D) = a[kl / D] * b[kl % D];
    });
    return r;
}
template <class R, int D>
CORONET_HD constexpr Matrix<R, D> transpose(Matrix<R, D> const& a) {
    Matrix<R, D> r;
    unrolled<D * D>([&](int kl) { r[kl] = a(kl % D, kl / D); });
    return r;
}
template <class R, int D>
CORONET_HD constexpr R trace(Matrix<R, D> const& a) {
    R s = a(0, 0);
    unrolled<D - 1>([&](int k) { s += a(k + 1, k + 1); });
    return s;
}
template <class R, int D>
CORONET_HD constexpr Matrix<R, D> identity() {
    Matrix<R, D> r;
    unrolled<D>([&](int k) { r(k, k) = R(1); });
    return r;
}

template <class R, int D>
CORONET_HD constexpr R determinant(Matrix<R, D> const& a) {
    if constexpr (D == 1) {
        return a(0, 0);
    } else if constexpr (D == 2) {
        return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    } else {
        return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) - a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
               a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
    }
}

/// The transposed cofactors: a * adjugate(a) = determinant(a) * identity, also where a is singular.
template <class R, int D>
CORONET_HD constexpr Matrix<R, D> adjugate(Matrix<R, D> const& a) {
    if constexpr (D == 1) {
        return {{R(1)}};
    } else if constexpr (D == 2) {
        return {{a(1, 1), -a(0, 1), -a(1, 0), a(0, 0)}};
    } else {
        Matrix<R, D> r;
        unrolled<9>([&](int ik) {
            int const i = ik / 3, k = ik % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3, i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            r(i, k) = a(k1, i1) * a(k2, i2) - a(k1, i2) * a(k2, i1);
        });
        return r;
    }
}

/// The square of the Frobenius norm, the sum of squares.
template <class R, int D>
CORONET_HD R norm2(Matrix<R, D> const& a) {
    R s = a[0] * a[0];
    unrolled<D * D - 1>([&](int k) { s += a[k + 1] * a[k + 1]; });
    return s;
}

}  // namespace coronet
