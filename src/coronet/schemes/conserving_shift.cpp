// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/conserving_shift.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace coronet {

namespace {

/// The velocity at x of a rotation about axis k.
Vector<double, 2> rotation(Vector<double, 2> const& x, int) { return {{-x[1], x[0]}}; }
Vector<double, 3> rotation(Vector<double, 3> const& x, int k) {
    Vector<double, 3> v;
    v[k] = 0;
    v[(k + 1) % 3] = -x[(k + 2) % 3];
    v[(k + 2) % 3] = x[(k + 1) % 3];
    return v;
}

/// Whether a body in the box may turn about that axis: not where this would tear it from its next period.
template <int D>
bool can_turn(PeriodicBox<D> const& box, int axis) {
    for (int k = 0; k < D; ++k)
        if (box.periodic[k] && (D == 2 || k != axis)) return false;
    return true;
}

/// Momentum and moment about an origin of the particles of one piece.
template <int D>
struct Motion {
    static constexpr int axes = D == 2 ? 1 : 3;
    double mass = 0;
    Vector<double, D> centre{}, momentum{};            // both times mass
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // the first `axes` entries
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();

    void add(double m, Vector<double, D> const& x, Vector<double, D> const& v) {
        mass += m;
        centre += m * x;
        momentum += m * v;
        for (int a = 0; a < axes; ++a) {
            moment(a) += m * dot(rotation(x, a), v);
            for (int b = 0; b < axes; ++b) inertia(a, b) += m * dot(rotation(x, a), rotation(x, b));
        }
    }
};

/// The motion of each piece, with positions relative to `origin`.
template <int D>
std::vector<Motion<D>> motions(Particles<D> const& particles, Boundary<D> const& boundary,
                               Vector<double, D> const& origin) {
    std::vector<Motion<D>> motions(boundary.pieces);
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.owned(); ++i)
        motions[boundary.piece_of(i)].add(view.template at<Mass>()[i], view.template get<Position>(i) - origin,
                                          view.template get<Velocity>(i));
    return motions;
}

}  // namespace

template <int D>
void ConservingShift<D>::find(Particles<D> const& particles, Neighbours<D> const& neighbours) {
    auto const view = particles.view();
    shift_.resize(particles.owned());
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

/// Takes from the shifts what would change the size or the content of a piece. On a circle both change alike: where
/// their gradients hardly differ, they count as one.
template <int D>
void ConservingShift<D>::keep_size_and_content(Particles<D> const& particles, Boundary<D> const& boundary) {
    double const* const m = particles.view().template at<Mass>();
    auto const &S = boundary.of_size, &G = boundary.of_content;
    // No particle of the surface is pushed out: a surface so roughened costs the flow what smoothing it takes, and
    // damps waves. Inwards they go, which is how a surface that grows shorter gets rid of particles. Then nothing moves
    // on average.
    auto const mass = boundary.sums([&](std::size_t i) { return m[i]; });
    for_each(shift_.size(), [&](std::size_t i) {
        double const outwards = dot(G[i], shift_[i]);
        if (outwards > 0) shift_[i] += (-outwards / norm2(G[i])) * G[i];
    });
    std::vector<Vector<double, D>> mean(boundary.pieces);
    for (int a = 0; a < D; ++a) {
        auto const sums = boundary.sums([&](std::size_t i) { return m[i] * shift_[i][a]; });
        for (std::size_t k = 0; k < mean.size(); ++k) mean[k][a] = sums[k] / mass[k];
    }
    for_each(shift_.size(), [&](std::size_t i) { shift_[i] += -1.0 * mean[boundary.piece_of(i)]; });
    auto const SS = boundary.sums([&](std::size_t i) { return norm2(S[i]) / m[i]; });
    auto const SG = boundary.sums([&](std::size_t i) { return dot(S[i], G[i]) / m[i]; });
    auto const GG = boundary.sums([&](std::size_t i) { return norm2(G[i]) / m[i]; });
    auto const Sd = boundary.sums([&](std::size_t i) { return dot(S[i], shift_[i]); });
    auto const Gd = boundary.sums([&](std::size_t i) { return dot(G[i], shift_[i]); });
    std::vector<double> of_size(boundary.pieces, 0), of_content(boundary.pieces, 0);
    for (std::size_t k = 0; k < boundary.pieces; ++k) {
        double const determinant = SS[k] * GG[k] - SG[k] * SG[k];
        if (determinant > 1e-9 * SS[k] * GG[k]) {
            of_size[k] = (GG[k] * Sd[k] - SG[k] * Gd[k]) / determinant;
            of_content[k] = (SS[k] * Gd[k] - SG[k] * Sd[k]) / determinant;
        } else if (GG[k] > 0) {
            of_content[k] = Gd[k] / GG[k];
        }
    }
    for_each(shift_.size(), [&](std::size_t i) {
        std::size_t const k = boundary.piece_of(i);
        shift_[i] += (-1 / m[i]) * (of_size[k] * S[i] + of_content[k] * G[i]);
    });
}

/// grad v at a particle, exact for linear fields; 0 where its neighbours do not span space.
template <int D>
Matrix<double, D> ConservingShift<D>::gradient(View<D> const& view, Neighbours<D> const& neighbours, std::size_t i) {
    double const H2 = neighbours.support() * neighbours.support();
    auto const x = view.template get<Position>(i), v = view.template get<Velocity>(i);
    Eigen::Matrix<double, D, D> moments = Eigen::Matrix<double, D, D>::Zero(), slopes = moments;
    for (Index const at : neighbours.row(i)) {
        auto const j = static_cast<std::size_t>(at);
        auto const r = view.template get<Position>(j) - x, dv = view.template get<Velocity>(j) - v;
        double const w = 1 - norm2(r) / H2;
        if (w <= 0) continue;
        for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b) {
                moments(a, b) += w * r[a] * r[b];
                slopes(a, b) += w * dv[a] * r[b];
            }
    }
    Matrix<double, D> gradient{};
    double const scale = moments.trace() / D;
    if (!(moments.determinant() > 1e-6 * std::pow(scale, D))) return gradient;
    Eigen::Matrix<double, D, D> const solved = slopes * moments.inverse();
    for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) gradient(a, b) = solved(a, b);
    return gradient;
}

template <int D>
void ConservingShift<D>::apply(Particles<D>& particles, Neighbours<D> const& neighbours, Boundary<D> const& boundary) {
    keep_size_and_content(particles, boundary);
    neighbours.images().refresh(particles, Fields<Position, Velocity>{});
    auto const view = particles.view();
    std::size_t const n = shift_.size();
    Vector<double, D> const origin = view.template get<Position>(0);
    auto const before = motions(particles, boundary, origin);
    change_.resize(n);
    for_each(n, [&](std::size_t i) {
        change_[i] = norm2(shift_[i]) > 0 ? share * (gradient(view, neighbours, i) * shift_[i]) : Vector<double, D>{};
    });
    for_each(n, [&](std::size_t i) {
        view.template set<Position>(i, view.template get<Position>(i) + share * shift_[i]);
        view.template set<Velocity>(i, view.template get<Velocity>(i) + change_[i]);
    });

    // A rigid motion of each piece gives back the momentum and the moment that it had.
    auto const after = motions(particles, boundary, origin);
    constexpr int axes = Motion<D>::axes;
    std::vector<Vector<double, D>> centre(after.size()), drift(after.size());
    std::vector<Eigen::Vector3d> spin(after.size());
    for (std::size_t k = 0; k < after.size(); ++k) {
        auto const& now = after[k];
        centre[k] = (1 / now.mass) * now.centre;
        drift[k] = (1 / now.mass) * (before[k].momentum - now.momentum);
        Motion<D> whole;
        whole.add(now.mass, centre[k], drift[k]);
        Eigen::Matrix3d inertia = now.inertia - whole.inertia;
        Eigen::Vector3d lack = before[k].moment - now.moment - whole.moment;
        for (int a = 0; a < axes; ++a)
            if (!can_turn(neighbours.images().box(), a)) {
                inertia.row(a).setZero();
                inertia.col(a).setZero();
                inertia(a, a) = 1;
                lack(a) = 0;
            }
        spin[k] = inertia.trace() > 0 ? Eigen::Vector3d(inertia.ldlt().solve(lack)) : Eigen::Vector3d(0, 0, 0);
    }
    for_each(n, [&](std::size_t i) {
        std::size_t const k = boundary.piece_of(i);
        auto v = view.template get<Velocity>(i) + drift[k];
        auto const x = view.template get<Position>(i) - origin - centre[k];
        for (int a = 0; a < axes; ++a) v += spin[k](a) * rotation(x, a);
        view.template set<Velocity>(i, v);
    });
}

template class ConservingShift<2>;
template class ConservingShift<3>;

}  // namespace coronet
