// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/detect.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "coronet/core/error.hpp"
#include "coronet/surface/arc_coverage.hpp"
#include "coronet/surface/cover.hpp"
#include "coronet/surface/sphere_coverage.hpp"

namespace coronet {

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
    particles.allocate(Fields<Surface>{});
    auto const view = particles.view();
    Targets const& all = neighbours.all();
    for_blocks(all.blocks(), [&](std::size_t block) {
        static thread_local std::conditional_t<D == 2, ArcCoverage, SphereCoverage> coverage;
        for (std::size_t i = all.begin[block]; i < all.begin[block + 1]; ++i)
            view.template at<Surface>()[i] = cover(coverage, particles, neighbours, i, radius, radius) ? 0 : 1;
    });
}

template void mark_surface(Particles<2>&, Neighbours<2> const&, double);
template void mark_surface(Particles<3>&, Neighbours<3> const&, double);

}  // namespace coronet
