// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/kept_gradients.hpp"

#include <algorithm>

#include "coronet/core/parallel.hpp"
#include "coronet/terms/gradient_correction.hpp"

namespace coronet {

template <int D>
struct KeptGradients<D>::Records {
    static constexpr int q = D * D, volume = q + D, conductance = volume + 1, groups = (conductance + 4) / 4;

    double* first;
    std::size_t stride;

    double* group(int g) const { return first + static_cast<std::size_t>(g) * stride; }
    double& position(std::size_t i, int k) const { return first[4 * i + static_cast<std::size_t>(k)]; }
    double& correction(std::size_t i, int k) const { return group(1 + k / 4)[4 * i + static_cast<std::size_t>(k % 4)]; }
};

namespace {

/// V_i V_j grad W~_ij, written once: the same numbers give the same bits in the rows of both.
template <int D, class R>
Vector<R, D> weighted(R const& VV, R const* Lq, Vector<R, D> const& gradW, R const& W) {
    Vector<R, D> G;
    unrolled<D>([&](int a) {
        R sum = Lq[D * a] * gradW[0];
        unrolled<D - 1>([&](int b) { sum += Lq[D * a + b + 1] * gradW[b + 1]; });
        G[a] = VV * (sum - Lq[D * D + a] * W);
    });
    return G;
}

}  // namespace

/// Room for the rows, as long as they are listed: what lies between support and skin is little, and weighs nothing.
template <int D>
void KeptGradients<D>::lay(Neighbours<D> const& neighbours, std::size_t n, bool with_slopes) {
    begin_.resize(n + 1);
    own_.resize(n);
    push_of_constant_.resize(n);
    begin_[0] = 0;
    for (std::size_t i = 0; i < n; ++i) begin_[i + 1] = begin_[i] + (neighbours.places(i).size() + lanes - 1) / lanes;
    std::size_t const packs = begin_[n];
    index_.resize(packs * lanes);
    gradient_.resize(packs * lanes * D);
    push_.resize(packs * lanes * D);
    slope_.resize(with_slopes ? packs * lanes : 0);
    sum_of_slopes_.resize(with_slopes ? n : 0);
}

/// The row of i with grad W, W and W'/r where G_ij, G_ji and the slope will stand, and its correction to the records.
/// Returns whether that fell back.
template <int D>
template <bool polynomial>
[[gnu::flatten]] bool KeptGradients<D>::list(std::size_t i, Records const& records, Neighbours<D> const& neighbours,
                                             Kernel const& kernel, ZerosThen<double> const& far, GradientKind kind) {
    Vector<Lanes, D> x_i;
    unrolled<D>([&](int a) { x_i[a] = Lanes(records.position(i, a)); });
    auto const places = neighbours.places(i);

    using Moments = Symmetric<Lanes, D>;
    constexpr int sums = 1 + 2 * D + Moments::size, room = (sums + 7) / 8 * 8;
    Lanes total[room] = {};  // W0, W1, G0, G1 of terms/gradient_correction.hpp
    for (std::size_t k = 0, at = begin_[i]; k < places.size(); k += lanes, ++at) {
        Lanes number[4];
        fetch_four(records.first, places.data() + k, number);
        Vector<Lanes, D> x;
        unrolled<D>([&](int a) { x[a] = x_i[a] - number[a]; });
        Lanes r2 = far.after(places.size() - k);
        unrolled<D>([&](int a) { r2 += x[a] * x[a]; });
        auto const [W, F] = kernel.template at<polynomial>(r2);
        Vector<Lanes, D> const gradW = F * x;
        write(gradW, gradient_, at);
        store(W, &push_[at * lanes * D]);
        if (!slope_.empty()) store(F, &slope_[at * lanes]);
        Lanes const V = number[D], VW = V * W;
        Vector<Lanes, D> const VG = V * gradW;
        Moments const G1 = outer_of_parallels(VG, x);
        total[0] += VW;
        unrolled<D>([&](int a) { total[1 + a] -= VW * x[a]; });
        unrolled<D>([&](int a) { total[1 + D + a] += VG[a]; });
        unrolled<Moments::size>([&](int m) { total[1 + 2 * D + m] -= G1[m]; });
    }
    Index* const row = &index_[begin_[i] * lanes];
    auto const end = static_cast<std::size_t>(&index_[begin_[i + 1] * lanes] - row);
    for (std::size_t k = 0; k < places.size(); ++k) row[k] = places[k] / Neighbours<D>::place;
    for (std::size_t k = places.size(); k < end; ++k) row[k] = static_cast<Index>(i);
    double sum[room];
    for (int s = 0; s < room; s += 8) sum_eight(total + s, sum + s);
    Vector<double, D> W1, G0;
    Symmetric<double, D> G1;
    unrolled<D>([&](int a) { W1[a] = sum[1 + a], G0[a] = sum[1 + D + a]; });
    unrolled<Moments::size>([&](int m) { G1[m] = sum[1 + 2 * D + m]; });

    double const V_i = records.position(i, D);
    Matrix<double, D> L = identity<double, D>();
    Vector<double, D> q;
    bool fell_back = false;
    if (kind == GradientKind::corrected) {
        GradientCorrection<double, D> const c(sum[0] + V_i * kernel.at_zero(), W1, G0, G1);
        L = c.L, q = c.q, fell_back = c.fell_back > 0;
    }
    unrolled<D * D>([&](int ab) { records.correction(i, ab) = L[ab]; });
    unrolled<D>([&](int a) { records.correction(i, Records::q + a) = q[a]; });
    records.correction(i, Records::volume) = V_i;
    return fell_back;
}

/// Puts what the row of i keeps in the place of the kernels.
template <int D>
[[gnu::flatten]] void KeptGradients<D>::weigh(std::size_t i, Records const& records, Neighbours<D> const& neighbours) {
    constexpr int numbers = Records::conductance + 1;
    bool const with_slopes = !slope_.empty();
    Lanes mine[numbers], its[4 * Records::groups], slopes(0.0);
    unrolled<numbers>([&](int k) { mine[k] = Lanes(records.correction(i, k)); });
    Vector<Lanes, D> out, in;
    Index const* place = neighbours.places(i).data();
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k, place += lanes) {
        unrolled<Records::groups>([&](int g) { fetch_four(records.group(1 + g), place, its + 4 * g); });
        Lanes const VV = mine[Records::volume] * its[Records::volume], W = load(&push_[k * lanes * D]);
        Vector<Lanes, D> const gradW = read(gradient_, k), G = weighted<D>(VV, mine, gradW, W),
                               push = weighted<D>(VV, its, -gradW, W);
        write(G, gradient_, k);
        write(push, push_, k);
        if (with_slopes) {
            Lanes const c = mine[Records::conductance] + its[Records::conductance],
                        slope = VV * c * load(&slope_[k * lanes]);
            store(slope, &slope_[k * lanes]);
            slopes += slope;
        }
        out += G;
        in += push;
    }
    if (with_slopes) sum_of_slopes_[i] = sum(slopes);
    unrolled<D>([&](int a) {
        own_[i][a] = -sum(out[a]);
        push_of_constant_[i][a] = sum(in[a]) + own_[i][a];
    });
}

template <int D>
void KeptGradients<D>::set_up(Particles<D> const& particles, Neighbours<D> const& neighbours, Kernel const& kernel,
                              GradientKind kind, std::span<double const> conductance) {
    std::size_t const n = particles.owned(), stride = 4 * n;
    auto const view = particles.view();
    Records const records{particles.template scratch<double>((1 + Records::groups) * stride), stride};
    lay(neighbours, n, !conductance.empty());
    for_each(n, [&](std::size_t i) {
        unrolled<D>([&](int a) { records.position(i, a) = view.template at<Position>(a)[i]; });
        records.position(i, D) = view.template at<Volume>()[i];
        records.correction(i, Records::conductance) = conductance.empty() ? 0 : conductance[i];
    });
    // Work is divided by pairs.
    Targets const& all = neighbours.all();
    auto const for_rows = [&](auto const& act) {
        for_blocks(all.blocks(), [&](std::size_t block) {
            for (std::size_t i = all.begin[block]; i < all.begin[block + 1]; ++i) act(i);
        });
    };
    fell_back_.resize(n);
    ZerosThen<double> const far(4 * kernel.support * kernel.support);
    for_rows([&](std::size_t i) {
        fell_back_[i] = kernel.is_polynomial ? list<true>(i, records, neighbours, kernel, far, kind)
                                             : list<false>(i, records, neighbours, kernel, far, kind);
    });
    for_rows([&](std::size_t i) { weigh(i, records, neighbours); });
    singular_matrices_ = static_cast<std::size_t>(std::count(fell_back_.begin(), fell_back_.end(), true));
}

template class KeptGradients<2>;
template class KeptGradients<3>;

}  // namespace coronet
