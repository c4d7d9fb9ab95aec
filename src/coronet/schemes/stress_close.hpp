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

/// The stress in the form that the corrected force sweep reads of neighbours: V sigma L and V sigma q.
template <int D>
CORONET_HD void set_corrected_stress(View<D> const& view, std::size_t i, Matrix<double, D> const& T,
                                     Vector<double, D> const& s) {
    double const V = view.template at<Volume>()[i];
    view.template set<CorrectedStress>(i, V * T);
    view.template set<StressOffset>(i, V * s);
}
/// What particle i adds to its own acceleration there, from its sums over the neighbours.
template <int D, class Sums>
CORONET_HD void set_own_acceleration(View<D> const& view, std::size_t i, Matrix<double, D> const& T,
                                     Vector<double, D> const& s, Sums const& sums) {
    double const rho = view.template at<Density>()[i];
    view.template set<OwnAcceleration>(i, CorrectedStressDivergence::own_part(T, s, rho, sums.G0, sums.W0));
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
        auto const T = product<double, D>(sigma, correction.L);
        auto const s = sigma * correction.q;
        set_corrected_stress(view, i, T, s);
        set_own_acceleration(view, i, T, s, sums);
        view.template at<FellBack>()[i] = correction.fell_back;
    }
};

/// The interior of cph near its exterior: the plain gradient, L = I and q = 0, in the form of the corrected one, too;
/// `borders` says whether particle i will use that form itself, and its law has summed what that takes.
template <int D, bool borders>
struct NearClose {
    View<D> view;
    Newtonian liquid;

    template <class Sums>
    CORONET_HD void operator()(std::size_t i, Sums const& sums) const {
        PlainClose<D>{view, liquid}(i, sums);
        auto const T = product<double, D>(view.template get<Stress>(i), identity<double, D>());
        set_corrected_stress(view, i, T, {});
        if constexpr (borders) set_own_acceleration(view, i, T, {}, sums);
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
