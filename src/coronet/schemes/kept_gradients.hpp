// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The gradient of a velocity on particles that stand still, and its transpose, for operators that a solve applies a
// hundred times to the same arrangement. With the corrected gradient grad W~_ij = L_i grad W_ij - q_i W_ij
// (terms/gradient_correction.hpp) and g_i = sum_j V_j grad W~_ij over the neighbours, Fang et al. (2009) Eqs 46 and 52,
//     grad_i(v)       = sum_j V_j v_j (x) grad W~_ij - v_i (x) g_i,
//     (grad^T V S)_i  = -V_i (S_i g_i + sum_j ((V S L)_j grad W_ij + (V S q)_j W_ij)),
// S a symmetric tensor of each particle: sum V S : grad(v) = sum v . grad^T V S for every v. A force -grad^T V S keeps
// momentum to round-off, and with the corrected gradient angular momentum, too, but where it fell back to the plain
// one.
//
// The kernel and its gradient are kept for every pair: an application is then two passes over them, a tenth of the
// time of two sweeps that evaluate the kernel.

#include <span>
#include <vector>

#include "coronet/core/parallel.hpp"
#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

/// Plain SPH (L = I, q = 0), or exact for linear fields (the finite particle method).
enum class GradientKind { plain, corrected };

template <int D>
class KeptGradients {
public:
    struct Link {
        Vector<double, D> gradW;  ///< of i for its neighbour j [1/m^(D+1)]
        double W;                 ///< [1/m^D]
        double F;                 ///< W'/r [1/m^(D+2)]
        Index j;
    };
    /// What a particle is to its own row and to those of its neighbours.
    struct Correction {
        Matrix<double, D> L;
        Vector<double, D> q, g;  ///< [1/m]
    };

    /// Of the fields Position and Volume and the lists of now.
    void set_up(Particles<D> const& particles, Neighbours<D> const& neighbours, Kernel const& kernel,
                GradientKind kind);

    std::size_t size() const { return correction_.size(); }
    /// The neighbours of i inside the support.
    std::span<Link const> row(std::size_t i) const { return {&links_[begin_[i]], begin_[i + 1] - begin_[i]}; }
    Correction const& correction(std::size_t i) const { return correction_[i]; }
    /// What a neighbour's value adds to the gradient of i: grad W~_ij.
    Vector<double, D> weight(std::size_t i, Link const& link) const {
        return correction_[i].L * link.gradW - link.W * correction_[i].q;
    }
    /// Particles whose corrected gradient fell back to the plain one.
    std::size_t singular_matrices() const { return singular_matrices_; }

    /// grad_v(a, b) = dv_a/dx_b at i, of v(j).
    template <class Field>
    Matrix<double, D> gradient(std::size_t i, Field const& v) const {
        Matrix<double, D> slope;
        Vector<double, D> jump;
        for (Link const& link : row(i)) {
            auto const j = static_cast<std::size_t>(link.j);
            Vector<double, D> const Vv = volume_[j] * v(j);
            slope += outer(Vv, link.gradW);
            jump += link.W * Vv;
        }
        Correction const& at = correction_[i];
        return product<double, D>(slope, transpose(at.L)) - outer(jump, at.q) - outer(v(i), at.g);
    }

    /// give(i, -(grad^T V S)_i/V_i) for all particles, of stress(i), a Symmetric tensor S_i.
    template <class Stress, class Give>
    void transposed(Stress const& stress, Give const& give) {
        push_.resize(size());
        own_.resize(size());
        for_each(size(), [&](std::size_t i) {
            Symmetric<double, D> const S = stress(i), VS = volume_[i] * S;
            Correction const& at = correction_[i];
            push_[i] = {product<double, D>(VS, at.L), VS * at.q};
            own_[i] = S * at.g;
        });
        for_each(size(), [&](std::size_t i) {
            Vector<double, D> sum = own_[i];
            for (Link const& link : row(i)) {
                Push const& push = push_[static_cast<std::size_t>(link.j)];
                sum += push.VSL * link.gradW + link.W * push.VSq;
            }
            give(i, sum);
        });
    }

private:
    struct Push {
        Matrix<double, D> VSL;
        Vector<double, D> VSq;
    };

    void list(Particles<D> const& particles, Neighbours<D> const& neighbours, Kernel const& kernel);

    std::vector<double> volume_;
    std::vector<std::size_t> begin_;  ///< of the row of i in links_
    std::vector<Link> links_;
    std::vector<Correction> correction_;
    std::vector<Push> push_;
    std::vector<Vector<double, D>> own_;
    std::size_t singular_matrices_ = 0;
};

}  // namespace coronet
