// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How the gradient sweep ends at a particle: from its sums to velocity gradient, rate of density and stress, in the
// form that the force sweep reads. One close for each gradient; the same code on the host and on a GPU.

#include "coronet/fields/particles.hpp"
#include "coronet/materials/newtonian.hpp"
#include "coronet/terms/gradient_correction.hpp"

namespace coronet {

/// sph: the plain gradient; the force sweep reads Stress.
template <int D>
struct PlainClose {
    View<D> view;
    Newtonian liquid;

    template <class Sums>
    CORONET_HD void operator()(std::size_t i, Sums const& sums) const {
        view.template at<DensityRate>()[i] = -view.template at<Density>()[i] * trace(sums.v_slope);
        view.template set<Stress>(i, liquid.stress(view.template at<Pressure>()[i], sums.v_slope));
    }
};

/// fpm, and the exterior of cph: the corrected gradient; the force sweep reads sigma L and sigma q.
template <int D>
struct CorrectedClose {
    View<D> view;
    Newtonian liquid;
    double kernel_at_zero;

    template <class Sums>
    CORONET_HD void operator()(std::size_t i, Sums const& sums) const {
        GradientCorrection<D> const correction(sums.W0 + view.template at<Volume>()[i] * kernel_at_zero, sums.W1,
                                               sums.G0, sums.G1);
        auto const grad_v = correction.gradient(sums.v_slope, sums.v_jump);
        auto const sigma = liquid.stress(view.template at<Pressure>()[i], grad_v);
        view.template at<DensityRate>()[i] = -view.template at<Density>()[i] * trace(grad_v);
        view.template set<Stress>(i, sigma);
        view.template set<CorrectedStress>(i, product<double, D>(sigma, correction.L));
        view.template set<StressOffset>(i, sigma * correction.q);
        view.template at<FellBack>()[i] = correction.fell_back;
    }
};

/// The interior of cph: the plain gradient in the form of the corrected one, L = I and q = 0.
template <int D>
struct InteriorClose {
    View<D> view;
    Newtonian liquid;

    template <class Sums>
    CORONET_HD void operator()(std::size_t i, Sums const& sums) const {
        PlainClose<D>{view, liquid}(i, sums);
        auto const sigma = view.template get<Stress>(i);
        view.template set<CorrectedStress>(i, product<double, D>(sigma, identity<double, D>()));
        view.template set<StressOffset>(i, {});
        view.template at<FellBack>()[i] = 0;
    }
};

}  // namespace coronet
