// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/operators.hpp"

#include "coronet/pairs/sweep.hpp"
#include "coronet/terms/gradient_correction.hpp"
#include "coronet/terms/moments.hpp"
#include "coronet/terms/sampled_function.hpp"

namespace coronet {

template <int D>
std::vector<Interpolated<D>> interpolate(Particles<D> const& particles, Neighbours<D> const& neighbours,
                                         Kernel const& kernel) {
    std::vector<Interpolated<D>> all(particles.owned());
    auto const view = particles.view();
    auto const close = [&](std::size_t i, auto const& sums) {
        double const own = view.template get<Volume>(i) * kernel.at_zero();
        double const W0 = sums.W0 + own;
        GradientCorrection<double, D> const correction(W0, sums.W1, sums.G0, sums.G1);
        Interpolated<D>& at = all[i];
        at.sph = sums.f0 + own * view.template get<Sample>(i);
        at.shepard = at.sph / W0;
        at.sph_gradient = sums.f_slope;
        for (int k = 0; k < D; ++k) at.axis_gradient[k] = sums.f_slope[k] / sums.G1(k, k);
        at.fpm_gradient = correction.gradient(sums.f_slope, sums.f_jump);
        at.fpm = (at.sph - dot(sums.W1, at.fpm_gradient)) / W0;
        at.fell_back = correction.fell_back > 0;
    };
    sweep(particles, neighbours, kernel, Precision::full,
          Part{neighbours.all(), Sum<Moments, SampledFunction>{}, OneByOne{close}});
    return all;
}

#define CORONET_INSTANTIATE(D) \
    template std::vector<Interpolated<D>> interpolate(Particles<D> const&, Neighbours<D> const&, Kernel const&);
CORONET_INSTANTIATE(1)
CORONET_INSTANTIATE(2)
CORONET_INSTANTIATE(3)
#undef CORONET_INSTANTIATE

}  // namespace coronet
