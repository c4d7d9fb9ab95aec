// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How the gradient sweep ends at a particle: from its sums to velocity gradient, rate of density and stress, in the
// form that the force sweep reads. One close for each gradient; the same code on the host and on a GPU.

#include "coronet/fields/particles.hpp"
#include "coronet/materials/newtonian.hpp"
#include "coronet/terms/gradient_correction.hpp"
#include "coronet/terms/stress_divergence.hpp"

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

/// The stress in the form that the corrected force sweep reads, V sigma L and V sigma q, and what particle i adds to its
/// own acceleration. W0 and G0 are sums over the neighbours.
template <int D>
CORONET_HD void set_corrected_stress(View<D> const& view, std::size_t i, Symmetric<double, D> const& sigma,
                                     Matrix<double, D> const& L, Vector<double, D> const& q,
                                     Vector<double, D> const& G0, double W0) {
    double const V = view.template at<Volume>()[i], rho = view.template at<Density>()[i];
    auto const T = product<double, D>(sigma, L);
    auto const s = sigma * q;
    view.template set<CorrectedStress>(i, V * T);
    view.template set<StressOffset>(i, V * s);
    view.template set<OwnAcceleration>(i, CorrectedStressDivergence::own_part(T, s, rho, G0, W0));
}

/// fpm, and the exterior of cph: the corrected gradient.
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
        set_corrected_stress(view, i, sigma, correction.L, correction.q, sums.G0, sums.W0);
        view.template at<FellBack>()[i] = correction.fell_back;
    }
};

/// The interior of cph near its exterior: the plain gradient, L = I and q = 0, in the form of the corrected one, too.
template <int D>
struct NearClose {
    View<D> view;
    Newtonian liquid;

    template <class Sums>
    CORONET_HD void operator()(std::size_t i, Sums const& sums) const {
        PlainClose<D>{view, liquid}(i, sums);
        set_corrected_stress(view, i, view.template get<Stress>(i), identity<double, D>(), {}, sums.G0, sums.W0);
    }
};

/// How the force sweep ends: stress forces in the corrected form lack what i adds itself.
template <int D>
struct PlainForceClose {
    View<D> view;
    Vector<double, D> gravity;

    template <class Sums>
    CORONET_HD void operator()(std::size_t i, Sums const& sums) const {
        view.template set<Acceleration>(i, sums.dv + gravity);
    }
};
template <int D>
struct CorrectedForceClose {
    View<D> view;
    Vector<double, D> gravity;

    template <class Sums>
    CORONET_HD void operator()(std::size_t i, Sums const& sums) const {
        view.template set<Acceleration>(i, sums.dv + view.template get<OwnAcceleration>(i) + gravity);
    }
};

}  // namespace coronet
