// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Preconditioned conjugate gradients for A x = b with a symmetric positive semi-definite A (Hestenes and Stiefel, J.
// Res. Nat. Bur. Stand. 49 (1952) 409), from the x that is given. A and the preconditioner are callables (in, out) on
// spans; the preconditioner must be symmetric and positive definite. If b lies in the range of A, so do all residuals,
// and what A cannot see keeps the value it had in the first x. Sums are formed in fixed blocks: the same bits for any
// number of threads.

#include <cmath>
#include <span>
#include <vector>

#include "coronet/core/parallel.hpp"

namespace coronet {

struct SolveLimits {
    double tolerance = 1e-8;     ///< of the residual's norm over that of b
    int most_iterations = 1000;  ///< an iteration applies A once
};

struct Solved {
    bool converged = false;
    /// Not for want of iterations: a direction with p . A p <= 0 (A is not definite where b is), or a number that is
    /// not finite.
    bool broke_down = false;
    int iterations = 0;
    double residual = 0;  ///< |b - A x|/|b| as the iteration knows it
};

inline double inner_product(std::span<double const> a, std::span<double const> b) {
    return sum_over(a.size(), 0.0, [&](std::size_t i) { return a[i] * b[i]; });
}

/// The vectors of a solve, kept from call to call.
class ConjugateGradients {
public:
    /// Improves x until |b - A x| <= tolerance |b|. Failing to is no error here: the caller knows what was solved for.
    template <class Operator, class Preconditioner>
    Solved solve(Operator&& A, Preconditioner&& precondition, std::span<double const> b, std::span<double> x,
                 SolveLimits const& limits = {}) {
        std::size_t const n = b.size();
        for (auto* v : {&r_, &z_, &p_, &Ap_}) v->resize(n);
        double const b2 = inner_product(b, b), goal2 = limits.tolerance * limits.tolerance * b2;
        Solved result;
        if (b2 == 0) {
            for_each(n, [&](std::size_t i) { x[i] = 0; });
            result.converged = true;
            return result;
        }
        A(std::span<double const>(x), std::span(r_));
        double r2 = sum_over(n, 0.0, [&](std::size_t i) {
            r_[i] = b[i] - r_[i];
            return r_[i] * r_[i];
        });
        double rz_before = 0;
        auto const good = [&] { return std::isfinite(r2) && r2 <= goal2; };
        while (!good() && result.iterations < limits.most_iterations) {
            precondition(std::span<double const>(r_), std::span(z_));
            double const rz = inner_product(r_, z_), beta = rz_before > 0 ? rz / rz_before : 0;
            for_each(n, [&](std::size_t i) { p_[i] = z_[i] + beta * p_[i]; });
            A(std::span<double const>(p_), std::span(Ap_));
            double const pAp = inner_product(p_, Ap_);
            ++result.iterations;
            if (!(pAp > 0 && std::isfinite(pAp) && std::isfinite(rz))) {
                result.broke_down = true;
                break;
            }
            double const alpha = rz / pAp;
            r2 = sum_over(n, 0.0, [&](std::size_t i) {
                x[i] += alpha * p_[i];
                r_[i] -= alpha * Ap_[i];
                return r_[i] * r_[i];
            });
            rz_before = rz;
        }
        result.converged = good();
        result.residual = std::sqrt(r2 / b2);
        return result;
    }

private:
    std::vector<double> r_, z_, p_, Ap_;
};

}  // namespace coronet
