// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The gradient on particles that stand still, and its transpose, for operators that a solve applies a hundred times to
// the same arrangement: G = V grad as a matrix of vectors. With the corrected gradient grad W~_ij = L_i grad W_ij - q_i
// W_ij (terms/gradient_correction.hpp), Fang et al. (2009) Eqs 46 and 52,
//     V_i grad_i(v) = sum_j v_j (x) G_ij + v_i (x) G_ii,     G_ij = V_i V_j grad W~_ij,  G_ii = -sum_j G_ij,
//     (G^T S)_i     = sum_j S_j G_ji + S_i G_ii,
// j over the neighbours. A constant has no gradient, and what G^T gives has no sum: a force G^T S keeps momentum to
// round-off, and with the corrected gradient angular momentum, too, but where it fell back to the plain one.
//
// Both G_ij and G_ji are kept in the row of i, each rounded the same in both rows, pack by pack of neighbours: an
// application streams through them and fetches of j only what it acts on. Units: G is in m^(D-1).

#include <cstddef>
#include <span>
#include <vector>

#include "coronet/core/simd.hpp"
#include "coronet/core/tensor.hpp"
#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

/// Plain SPH (L = I, q = 0), or exact for linear fields (the finite particle method).
enum class GradientKind { plain, corrected };

template <int D>
class KeptGradients {
public:
    using Lanes = Pack<double>;

    /// Of the fields Position and Volume and the lists of now. With a conductance c of each particle rows have slopes
    /// s_ij = (c_i + c_j) V_i V_j W'/r, in units of c times m^(D-2), too.
    void set_up(Particles<D> const& particles, Neighbours<D> const& neighbours, Kernel const& kernel, GradientKind kind,
                std::span<double const> conductance = {});

    std::size_t size() const { return own_.size(); }
    /// Particles whose corrected gradient fell back to the plain one.
    std::size_t singular_matrices() const { return singular_matrices_; }
    bool fell_back(std::size_t i) const { return fell_back_[i]; }

    /// G_ii.
    Vector<double, D> const& own(std::size_t i) const { return own_[i]; }
    /// (G^T 1)_i: the force of a constant pressure of one.
    Vector<double, D> const& push_of_constant(std::size_t i) const { return push_of_constant_[i]; }

    /// act(j, G_ij) for every pack of neighbours j of i. The last is filled up with i itself and zeros, and so are
    /// neighbours beyond the support.
    template <class Act>
    void for_gradients(std::size_t i, Act const& act) const {
        for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) act(&index_[k * lanes], read(gradient_, k));
    }
    /// act(j, G_ji).
    template <class Act>
    void for_pushes(std::size_t i, Act const& act) const {
        for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) act(&index_[k * lanes], read(push_, k));
    }
    /// sum_j s_ij.
    double sum_of_slopes(std::size_t i) const { return sum_of_slopes_[i]; }
    /// act(j, G_ji, s_ij).
    template <class Act>
    void for_pushes_and_slopes(std::size_t i, Act const& act) const {
        for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
            act(&index_[k * lanes], read(push_, k), load(&slope_[k * lanes]));
    }

private:
    static constexpr std::size_t lanes = pack_size<double>;
    using Rows = std::vector<double>;

    Vector<Lanes, D> read(Rows const& rows, std::size_t k) const {
        Vector<Lanes, D> w;
        unrolled<D>([&](int a) { w[a] = load(&rows[(k * D + static_cast<std::size_t>(a)) * lanes]); });
        return w;
    }
    void write(Vector<Lanes, D> const& w, Rows& rows, std::size_t k) {
        unrolled<D>([&](int a) { store(w[a], &rows[(k * D + static_cast<std::size_t>(a)) * lanes]); });
    }

    /// What a pair reads of its particles, in groups of four numbers that the places of the lists point to: group 0 is
    /// position and volume, those behind it L, q, volume and conductance.
    struct Records;

    void lay(Neighbours<D> const& neighbours, std::size_t n, bool with_slopes);
    template <bool polynomial>
    bool list(std::size_t i, Records const& records, Neighbours<D> const& neighbours, Kernel const& kernel,
              ZerosThen<double> const& far, GradientKind kind);
    void weigh(std::size_t i, Records const& records, Neighbours<D> const& neighbours);

    std::vector<std::size_t> begin_;  ///< of the packs of the row of i
    std::vector<Index> index_;
    Rows gradient_, push_, slope_;
    std::vector<Vector<double, D>> own_, push_of_constant_;
    std::vector<double> sum_of_slopes_;
    std::vector<char> fell_back_;
    std::size_t singular_matrices_ = 0;
};

}  // namespace coronet
