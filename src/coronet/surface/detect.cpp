// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/detect.hpp"

#include <fmt/format.h>

#include <array>
#include <type_traits>

#include "coronet/core/error.hpp"
#include "coronet/surface/arc_coverage.hpp"
#include "coronet/surface/sphere_coverage.hpp"

namespace coronet {

namespace {

/// Neighbours are taken in rings, up to these shares of the reach, the nearest first: they cover the most. In 3D a
/// particle inside is done with few; in 2D the question costs as much as the answer.
template <int D>
constexpr std::array<double, D == 2 ? 1 : 2> rings;
template <>
constexpr std::array<double, 1> rings<2> = {1};
template <>
constexpr std::array<double, 2> rings<3> = {0.6, 1};

}  // namespace

void check_coverage_radius(double radius, double known) {
    if (!(2 * radius <= known))
        throw CaseError(
            fmt::format("the free surface is sought with circles of radius {:g} m, which meet up to {:g} m "
                        "apart, but neighbours are known up to {:g} m: choose a coverage radius of at "
                        "most half the support of the kernel, or a wider kernel",
                        radius, 2 * radius, known));
}

template <int D>
void mark_surface(Particles<D>& particles, Neighbours<D> const& neighbours, double radius) {
    check_coverage_radius(radius, neighbours.support());
    double const reach = 2 * radius;
    particles.allocate(Fields<Surface>{});
    auto const view = particles.view();
    Targets const& all = neighbours.all();
    for_blocks(all.blocks(), [&](std::size_t block) {
        static thread_local std::conditional_t<D == 2, ArcCoverage, SphereCoverage> coverage;
        for (std::size_t i = all.begin[block]; i < all.begin[block + 1]; ++i) {
            auto const x_i = view.template get<Position>(i);
            coverage.clear();
            bool covered = false;
            double from2 = -1;
            for (double const share : rings<D>) {
                double const to2 = share * share * reach * reach;
                for (Index const j : neighbours.row(i)) {
                    auto const x = view.template get<Position>(static_cast<std::size_t>(j)) - x_i;
                    double const r2 = norm2(x);
                    if (r2 > from2 && r2 <= to2) coverage.add(Cap<D>(x, radius, radius), j);
                }
                if (share == 1) covered = coverage.covered();
                else if constexpr (D == 3) covered = coverage.seems_covered();
                if (covered) break;
                from2 = to2;
            }
            view.template at<Surface>()[i] = covered ? 0 : 1;
        }
    });
}

template void mark_surface(Particles<2>&, Neighbours<2> const&, double);
template void mark_surface(Particles<3>&, Neighbours<3> const&, double);

}  // namespace coronet
