// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The finite particle method's gradient (Fang et al. 2009, Eqs 36-38) with its (D+1) x (D+1) matrix
//     ( W0  W1^T )     W0 = sum V W,       W1 = sum V (x_j - x_i) W
//     ( G0  G1   )     G0 = sum V grad W,  G1 = sum V grad W (x_j - x_i)^T
// eliminated by hand: with S = G1 - G0 W1^T / W0 (D x D), L = S^-1 and q = L G0 / W0, the corrected kernel gradient is
//     grad W~_ij = L grad W_ij - q W_ij,
// exact for linear functions on any arrangement of particles. The plain SPH gradient is L = I, q = 0.
//
// Where the neighbours do not span the space (a lone particle, a row of them) S is singular, and where they are few and
// far it is tiny: L then weighs them so strongly that explicit steps of the usual size are unstable. A particle whose
// amplification |L|/sqrt(D) (Frobenius norm) exceeds `largest_amplification` falls back to the plain gradient, which
// always exists, and says so: schemes count such particles. The amplification is about 1 inside, 2 at a flat surface
// and 2^D at a right-angled corner.

#include "coronet/core/tensor.hpp"

namespace coronet {

/// 5 in 2D, 10 in 3D: a quarter more than at a right-angled corner. Colliding drops
/// (tests/statements/collision_test.cpp) gain energy with 1.4 times as much and blow up with twice; a drop stretched
/// to 2.3 times its length stays below.
template <int D>
inline constexpr double largest_amplification = 1.25 * (1 << D);

template <class R, int D>
struct GradientCorrection {
    Matrix<R, D> L;
    Vector<R, D> q;
    R fell_back;  ///< 1 where the gradient is the plain one, else 0

    /// The moments with i itself: it adds V_i W(0) to W0.
    CORONET_HD GradientCorrection(R const& W0, Vector<R, D> const& W1, Vector<R, D> const& G0,
                                  Symmetric<R, D> const& G1) {
        Vector<R, D> const G0_over_W0 = (R(1) / W0) * G0;
        Matrix<R, D> S;
        unrolled<D * D>([&](int ab) { S[ab] = G1(ab / D, ab % D) - G0_over_W0[ab / D] * W1[ab % D]; });
        auto const cofactors = adjugate(S);
        R const det = determinant(S);
        // |adj S| = |det S| |L|: compared before the division. A NaN falls back, too.
        constexpr double limit = largest_amplification<D>;
        auto const sound = norm2(cofactors) < R(limit * limit * D) * det * det;
        fell_back = select(sound, R(0), R(1));
        R const per_det = R(1) / det;
        unrolled<D * D>([&](int ab) { L[ab] = select(sound, per_det * cofactors[ab], R(ab / D == ab % D ? 1 : 0)); });
        Vector<R, D> const q_of_L = L * G0_over_W0;
        unrolled<D>([&](int a) { q[a] = select(sound, q_of_L[a], R(0)); });
    }

    /// Gradient of a vector field from sum V (v_j - v_i) grad W and sum V (v_j - v_i) W: grad_v(a, b) = dv_a/dx_b.
    CORONET_HD Matrix<R, D> gradient(Matrix<R, D> const& slope, Vector<R, D> const& jump) const {
        return product<R, D>(slope, transpose(L)) - outer(jump, q);
    }

    /// Gradient of a scalar field from sum V (f_j - f_i) grad W and sum V (f_j - f_i) W.
    CORONET_HD Vector<R, D> gradient(Vector<R, D> const& slope, R const& jump) const { return L * slope - jump * q; }
};

}  // namespace coronet
