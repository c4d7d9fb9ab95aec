// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/thesis_pressure.hpp"

#include <cmath>
#include <stdexcept>

namespace coronet {

template <int D>
ThesisPressure<D>::ThesisPressure(Kernel const& kernel, Options const& options)
    : kernel_(kernel), options_(options), plain_(kernel, GradientKind::plain) {
    if (!options.lattice_diagonal) return;
    double const dx = options.spacing;
    int const far = static_cast<int>(kernel.support / dx);
    for (int a = -far; a <= far; ++a)
        for (int b = -far; b <= far; ++b)
            for (int c = D == 3 ? -far : 0; c <= (D == 3 ? far : 0); ++c) {
                double const r2 = dx * dx * (a * a + b * b + c * c);
                if (r2 > 0) lattice_sum_ -= std::pow(dx, D) * kernel(r2).F;
            }
}

/// -F(r') between i and the image of j, both ways round the same: of the plane of whichever is of the surface, or the
/// mean of both planes; zero where neither is.
template <int D>
double ThesisPressure<D>::image(std::size_t i, std::size_t j, Vector<double, D> const& x_ij) const {
    double const r2 = norm2(x_ij);
    // Of s and a point that is `inward` deeper below its plane: r'^2 = r^2 - inward^2 + (spacing + inward)^2.
    auto const behind = [&](double inward) {
        double const d = options_.spacing + inward;
        return -kernel_(std::max(r2 - inward * inward, 0.0) + d * d).F;
    };
    double sum = 0;
    int planes = 0;
    if (is_surface_[i]) sum += behind(dot(x_ij, normals_[i])), ++planes;
    if (is_surface_[j] && j != i) sum += behind(-dot(x_ij, normals_[j])), ++planes;
    return planes == 0 ? 0 : sum / planes;
}

template <int D>
void ThesisPressure<D>::set_up(Particles<D>& particles, Neighbours<D> const& neighbours) {
    particles_ = &particles;
    plain_.set_up(particles, neighbours);
    std::size_t const n = particles.size();
    auto const view = particles.view();
    is_surface_.assign(n, 0);
    if (options_.surface != SurfacePressure::free)
        for (std::size_t i = 0; i < n; ++i) is_surface_[i] = view.template at<Surface>()[i] > 0;
    bool const mirrors = options_.surface == SurfacePressure::mirrored;
    if (mirrors && normals_.size() != n)
        throw std::invalid_argument("a mirrored surface pressure needs a normal for each particle");

    double const H2 = kernel_.support * kernel_.support;
    auto const far = [&](std::size_t i, std::size_t j) {
        return !(norm2(view.template get<Position>(i) - view.template get<Position>(j)) < H2);
    };
    rows_.begin.assign(n + 1, 0);
    for_each(n, [&](std::size_t i) {
        if (taken_out(i)) return;
        for (Index const j : neighbours.row(i))
            rows_.begin[i + 1] += !taken_out(static_cast<std::size_t>(j)) && !far(i, static_cast<std::size_t>(j));
    });
    for (std::size_t i = 0; i < n; ++i) rows_.begin[i + 1] += rows_.begin[i];
    rows_.column.resize(rows_.begin[n]);
    rows_.value.resize(rows_.begin[n]);
    diagonal_.resize(n);

    for_each(n, [&](std::size_t i) {
        double const V_i = view.template at<Volume>()[i], rho_i = view.template at<Density>()[i];
        auto const x_i = view.template get<Position>(i);
        if (taken_out(i)) {
            diagonal_[i] = 1;
            return;
        }
        std::size_t next = rows_.begin[i];
        double sum = 0;
        for (Index const at : neighbours.row(i)) {
            auto const j = static_cast<std::size_t>(at);
            auto const x = x_i - view.template get<Position>(j);
            double const r2 = norm2(x);
            if (!(r2 < H2)) continue;
            double const weight = V_i * view.template at<Volume>()[j] * 4 / (rho_i + view.template at<Density>()[j]);
            double const a = -weight * kernel_(r2).F, a_image = mirrors ? weight * image(i, j, x) : 0;
            sum += a + a_image;
            if (taken_out(j)) continue;
            rows_.column[next] = at;
            rows_.value[next++] = a_image - a;
        }
        if (mirrors) sum += 2 * (V_i * V_i * 2 / rho_i) * image(i, i, {});
        if (options_.lattice_diagonal) sum = std::max(sum, V_i * 2 / rho_i * lattice_sum_);
        diagonal_[i] = sum;
    });
}

template <int D>
void ThesisPressure<D>::source(double step, std::span<double> b) {
    plain_.source(step, b);
    for_each(b.size(), [&](std::size_t i) {
        if (taken_out(i)) b[i] = 0;
    });
}

template <int D>
void ThesisPressure<D>::divergence(std::vector<Vector<double, D>> const& v, std::span<double> to) {
    plain_.divergence(v, to);
    for_each(to.size(), [&](std::size_t i) {
        if (taken_out(i)) to[i] = 0;
    });
}

template <int D>
void ThesisPressure<D>::apply(std::span<double const> p, std::span<double> Ap) {
    for_each(p.size(), [&](std::size_t i) {
        double sum = diagonal_[i] * p[i];
        for (std::size_t k = rows_.begin[i]; k < rows_.begin[i + 1]; ++k) sum += rows_.value[k] * p[rows_.column[k]];
        Ap[i] = sum;
    });
}

/// p^T A p = 1/2 sum_ij a_ij (p_i - p_j)^2 + sum_i (A 1)_i p_i^2 for any symmetric matrix.
template <int D>
SmoothEnergy ThesisPressure<D>::smooth_energy() {
    auto const view = particles_->view();
    std::size_t const n = particles_->size();
    SmoothEnergy energy{std::vector<double>(n), std::vector<double>(n)};
    apply(std::vector<double>(n, 1.0), energy.e);
    for_each(n, [&](std::size_t i) {
        if (taken_out(i)) energy.e[i] = 0;
        else energy.a[i] = view.template at<Volume>()[i] / view.template at<Density>()[i];
        energy.e[i] = std::max(energy.e[i], 0.0);
    });
    return energy;
}

template class ThesisPressure<2>;
template class ThesisPressure<3>;

}  // namespace coronet
