// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/reconstruct.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "coronet/core/error.hpp"
#include "coronet/surface/frame.hpp"

namespace coronet {

namespace {

template <int D>
constexpr int coefficients = D == 2 ? 3 : 6;
template <int D>
using Coefficients = Eigen::Matrix<double, coefficients<D>, 1>;

// Of the normal equations, whose numbers are of size 1 for points that span the width. The least pivot falls as the
// fourth power of what they span.
constexpr double least_pivot = 1e-6;

// Two sheets of surface face each other; the two faces of an edge are at right angles, or nearly.
constexpr double opposite = -0.5;

// Of the width: a mean of the neighbours that is nearer tells no direction.
constexpr double nearest_mean = 1e-6;

/// 1, x, x^2; or 1, x, y, x^2, xy, y^2.
template <int D>
Coefficients<D> basis(double const (&t)[D - 1]) {
    if constexpr (D == 2) return Coefficients<2>(1, t[0], t[0] * t[0]);
    else return (Coefficients<3>() << 1, t[0], t[1], t[0] * t[0], t[0] * t[1], t[1] * t[1]).finished();
}

/// The coefficients of the height over the plane at right angles to n, all lengths in widths.
template <int D>
std::optional<Coefficients<D>> fit_height(std::span<Vector<double, D> const> points, Vector<double, D> const& n,
                                          SurfaceFit const& fit) {
    auto const t = tangents(n);
    Eigen::Matrix<double, coefficients<D>, coefficients<D>> A;
    A.setZero();
    A(0, 0) = 1;  // the particle itself
    Coefficients<D> b = Coefficients<D>::Zero();
    int count = 1;
    for (auto const& x : points) {
        double const weight = fit.weight(norm2(x));
        if (weight == 0) continue;
        double along[D - 1];
        for (int k = 0; k < D - 1; ++k) along[k] = dot(x, t[static_cast<std::size_t>(k)]) / fit.width;
        Coefficients<D> const p = basis<D>(along);
        A += weight * p * p.transpose();
        b += weight * dot(x, n) / fit.width * p;
        ++count;
    }
    if (count < coefficients<D>) return {};
    auto const factors = A.ldlt();
    if (!(factors.vectorD().minCoeff() > least_pivot)) return {};
    return factors.solve(b);
}

template <int D>
Vector<double, D> turned(Vector<double, D> const& n, Coefficients<D> const& c) {
    auto const t = tangents(n);
    Vector<double, D> normal = n;
    for (int k = 0; k < D - 1; ++k) normal = normal - c[k + 1] * t[static_cast<std::size_t>(k)];
    return 1 / std::sqrt(norm2(normal)) * normal;
}

/// In units of 1/width.
template <int D>
double curvature(Coefficients<D> const& c) {
    if constexpr (D == 2) return curvature_of_graph(c[1], 2 * c[2]);
    else return curvature_of_graph(c[1], c[2], 2 * c[3], c[4], 2 * c[5]);
}

/// The unit vector from the mean of the neighbours to i, or 0.
template <int D>
Vector<double, D> away_from_neighbours(View<D> const& view, Neighbours<D> const& neighbours, std::size_t i,
                                       SurfaceFit const& fit) {
    auto const x_i = view.template get<Position>(i);
    Vector<double, D> sum;
    double weights = 0;
    for (Index const j : neighbours.row(i)) {
        auto const x = view.template get<Position>(static_cast<std::size_t>(j)) - x_i;
        double const weight = fit.weight(norm2(x));
        sum += weight * x;
        weights += weight;
    }
    double const length = std::sqrt(norm2(sum));
    if (!(length > nearest_mean * fit.width * weights)) return {};
    return -1 / length * sum;
}

}  // namespace

template <int D>
LocalSurface<D> fit_surface(std::span<Vector<double, D> const> points, Vector<double, D> const& outward,
                            SurfaceFit const& fit) {
    auto const first = fit_height<D>(points, outward, fit);
    if (!first) return {outward};
    auto const n = turned<D>(outward, *first);
    auto const second = fit_height<D>(points, n, fit);
    if (!second) return {outward};
    return {turned<D>(n, *second), curvature<D>(*second) / fit.width, true};
}

template <int D>
void reconstruct_surface(Particles<D>& particles, Neighbours<D> const& neighbours, SurfaceFit const& fit) {
    if (!(fit.width <= neighbours.support()))
        throw CaseError(
            fmt::format("the surface is fitted to particles within {:g} m, but neighbours are known up to "
                        "{:g} m: choose a narrower fit, or a kernel of wider support",
                        fit.width, neighbours.support()));
    particles.allocate(Fields<SurfaceNormal, Curvature, SurfaceArea, SurfaceFitted>{});
    auto const view = particles.view();
    auto const of_surface = [&](std::size_t i) { return view.template at<Surface>()[i] > 0; };
    for_each(particles.owned(), [&](std::size_t i) {
        view.template set<SurfaceNormal>(
            i, of_surface(i) ? away_from_neighbours(view, neighbours, i, fit) : Vector<double, D>{});
        view.template at<Curvature>()[i] = view.template at<SurfaceArea>()[i] = view.template at<SurfaceFitted>()[i] =
            0;
    });

    neighbours.images().refresh(particles, Fields<Surface, SurfaceNormal>{});

    Targets const surface = neighbours.targets(of_surface);
    std::vector<LocalSurface<D>> fits(surface.particles.size());
    SurfaceFit const compact{fit.width};
    double const norm = D == 2 ? 35 / (32 * fit.width) : 4 / (std::numbers::pi * fit.width * fit.width);
    for_blocks(surface.blocks(), [&](std::size_t block) {
        std::vector<Vector<double, D>> points;
        for (std::size_t k = surface.begin[block]; k < surface.begin[block + 1]; ++k) {
            std::size_t const i = surface[k];
            auto const x_i = view.template get<Position>(i), outward = view.template get<SurfaceNormal>(i);
            if (norm2(outward) == 0) continue;
            points.clear();
            for (Index const place : neighbours.row(i)) {
                auto const j = static_cast<std::size_t>(place);
                if (of_surface(j) && dot(view.template get<SurfaceNormal>(j), outward) > opposite)
                    points.push_back(view.template get<Position>(j) - x_i);
            }
            fits[k] = fit_surface<D>(points, outward, fit);
            double per_area = norm;
            for (auto const& x : points) per_area += norm * compact.weight(norm2(x));
            view.template at<SurfaceArea>()[i] = 1 / per_area;
        }
    });
    for_each(fits.size(), [&](std::size_t k) {
        view.template set<SurfaceNormal>(surface[k], fits[k].normal);
        view.template at<Curvature>()[surface[k]] = fits[k].curvature;
        view.template at<SurfaceFitted>()[surface[k]] = fits[k].fitted;
    });
}

#define CORONET_INSTANTIATE(D)                                                                         \
    template LocalSurface<D> fit_surface(std::span<Vector<double, D> const>, Vector<double, D> const&, \
                                         SurfaceFit const&);                                           \
    template void reconstruct_surface(Particles<D>&, Neighbours<D> const&, SurfaceFit const&);
CORONET_INSTANTIATE(2)
CORONET_INSTANTIATE(3)
#undef CORONET_INSTANTIATE

}  // namespace coronet
