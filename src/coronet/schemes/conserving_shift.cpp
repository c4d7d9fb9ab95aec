// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/conserving_shift.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace coronet {

namespace {

/// The component of x cross v about axis k.
double moment(Vector<double, 2> const& x, Vector<double, 2> const& v, int) { return x[0] * v[1] - x[1] * v[0]; }
double moment(Vector<double, 3> const& x, Vector<double, 3> const& v, int k) {
    int const a = (k + 1) % 3, b = (k + 2) % 3;
    return x[a] * v[b] - x[b] * v[a];
}
/// Its derivative by x.
Vector<double, 2> turned(Vector<double, 2> const& v, int) { return {{v[1], -v[0]}}; }
Vector<double, 3> turned(Vector<double, 3> const& v, int k) {
    Vector<double, 3> derivative;
    derivative[(k + 1) % 3] = v[(k + 2) % 3];
    derivative[(k + 2) % 3] = -v[(k + 1) % 3];
    return derivative;
}

}  // namespace

template <int D>
void ConservingShift<D>::find(Particles<D> const& particles, Neighbours<D> const& neighbours) {
    auto const view = particles.view();
    shift_.resize(particles.size());
    for_each(shift_.size(), [&](std::size_t i) {
        auto const x = view.template get<Position>(i);
        double const m = view.template at<Mass>()[i];
        Vector<double, D> sum{};
        for (Index const at : neighbours.row(i)) {
            auto const j = static_cast<std::size_t>(at);
            auto const apart = x - view.template get<Position>(j);
            double const r2 = norm2(apart);
            if (r2 >= range_ * range_ || r2 == 0) continue;
            double const m_j = view.template at<Mass>()[j];
            sum += m_j / (m + m_j) * (range_ / std::sqrt(r2) - 1) * apart;
        }
        shift_[i] = sum;
    });
}

template <int D>
void ConservingShift<D>::apply(Particles<D>& particles, Boundary<D> const& boundary, double step) {
    constexpr int axes = D == 2 ? 1 : 3;
    auto const view = particles.view();
    std::size_t const n = shift_.size();
    double const* const m = view.template at<Mass>();
    double const mass = sum_over(n, 0.0, [&](std::size_t i) { return m[i]; });
    auto const mean = (1 / mass) * sum_over(n, Vector<double, D>{}, [&](std::size_t i) {
                          return m[i] * view.template get<Velocity>(i);
                      });
    auto const velocity = [&](std::size_t i) { return view.template get<Velocity>(i) - mean; };
    double const fastest = std::sqrt(max_over(n, 0, [&](std::size_t i) { return norm2(velocity(i)); }));
    double const k = std::min(fastest * step / spacing_, 0.5);
    if (k == 0) return;

    // Columns: size and content of each piece, then the components of the angular momentum. Only those of the same piece
    // and the angular momentum are not orthogonal.
    auto const pieces = static_cast<Eigen::Index>(boundary.pieces), size = 2 * pieces + axes;
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd along(size);
    auto const set = [&](Eigen::Index a, Eigen::Index b, double value) { gram(a, b) = gram(b, a) = value; };
    auto const per_piece = [&](auto const& part, auto const& store) {
        auto const sums = boundary.sums(part);
        for (Eigen::Index p = 0; p < pieces; ++p) store(p, sums[static_cast<std::size_t>(p)]);
    };
    auto const &S = boundary.of_size, &G = boundary.of_content;
    per_piece([&](std::size_t i) { return dot(S[i], S[i]) / m[i]; },
              [&](Eigen::Index p, double s) { set(2 * p, 2 * p, s); });
    per_piece([&](std::size_t i) { return dot(S[i], G[i]) / m[i]; },
              [&](Eigen::Index p, double s) { set(2 * p, 2 * p + 1, s); });
    per_piece([&](std::size_t i) { return dot(G[i], G[i]) / m[i]; },
              [&](Eigen::Index p, double s) { set(2 * p + 1, 2 * p + 1, s); });
    per_piece([&](std::size_t i) { return dot(S[i], shift_[i]); }, [&](Eigen::Index p, double s) { along(2 * p) = s; });
    per_piece([&](std::size_t i) { return dot(G[i], shift_[i]); },
              [&](Eigen::Index p, double s) { along(2 * p + 1) = s; });
    for (int a = 0; a < axes; ++a) {
        auto const row = 2 * pieces + a;
        per_piece([&](std::size_t i) { return moment(S[i], velocity(i), a); },
                  [&](Eigen::Index p, double s) { set(row, 2 * p, s); });
        per_piece([&](std::size_t i) { return moment(G[i], velocity(i), a); },
                  [&](Eigen::Index p, double s) { set(row, 2 * p + 1, s); });
        for (int b = 0; b <= a; ++b)
            set(row, 2 * pieces + b, sum_over(n, 0.0, [&](std::size_t i) {
                    return m[i] * dot(turned(velocity(i), a), turned(velocity(i), b));
                }));
        along(row) = sum_over(n, 0.0, [&](std::size_t i) { return m[i] * moment(shift_[i], velocity(i), a); });
    }
    // In units in which the columns have length one. On a circle size and content change alike: columns that hardly
    // differ count once.
    Eigen::VectorXd scale = gram.diagonal().cwiseMax(0).cwiseSqrt();
    scale = (scale.array() > 0).select(scale.cwiseInverse(), 0.0);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-9);
    solver.compute(scale.asDiagonal() * gram * scale.asDiagonal());
    Eigen::VectorXd const lambda = scale.asDiagonal() * solver.solve(scale.asDiagonal() * along);

    for_each(n, [&](std::size_t i) {
        auto const p = 2 * static_cast<Eigen::Index>(boundary.piece_of(i));
        auto d = shift_[i] + (-1 / m[i]) * (lambda(p) * S[i] + lambda(p + 1) * G[i]);
        for (int a = 0; a < axes; ++a) d += -lambda(2 * pieces + a) * turned(velocity(i), a);
        view.template set<Position>(i, view.template get<Position>(i) + k * d);
    });
}

template class ConservingShift<2>;
template class ConservingShift<3>;

}  // namespace coronet
