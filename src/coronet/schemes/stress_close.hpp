// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How the gradient sweep ends at a particle: from its sums to velocity gradient, rate of density and stress, in the
// form that the force sweep reads. One close for each gradient; the same code on the host and on a GPU.

#include "coronet/fields/particles.hpp"
#include "coronet/materials/generalised_newtonian.hpp"
#include "coronet/terms/gradient_correction.hpp"
#include "coronet/terms/stress_divergence.hpp"

namespace coronet {

/// sigma [Pa], its viscous part times `share`; where viscosity differs from particle to particle, it is kept.
template <class At, class R, int D>
CORONET_HD Symmetric<R, D> stress(At const& at, GeneralisedNewtonian const& liquid, R const& p,
                                  Matrix<R, D> const& grad_v, R const& share = R(1)) {
    R const mu = liquid.viscosity(grad_v);
    if (!liquid.is_newtonian()) at.template set<Viscosity>(mu);
    return Newtonian<R>{share * mu}.stress(p, grad_v);
}

/// The pressure that pushes over a step: with symplectic steps that at its end, after the rate of density that has just
/// been found, p + dt c^2 drho/dt; else, with dt = 0, p as it is.
template <class At, class R>
CORONET_HD R pressure_after(double dt, At const& at, R const& density_rate) {
    R p = at.template get<Pressure>();
    if (dt == 0) return p;
    R const c = at.template get<SoundSpeed>();
    p += R(dt) * c * c * density_rate;
    at.template set<Pressure>(p);
    return p;
}

/// sph: the plain gradient; the force sweep reads Stress.
struct PlainClose {
    GeneralisedNewtonian liquid;
    double dt = 0;  ///< [s], of pressure_after()

    template <class At, class Sums>
    CORONET_HD void operator()(At const& at, Sums const& sums) const {
        auto const rate = -at.template get<Density>() * trace(sums.v_slope);
        at.template set<DensityRate>(rate);
        at.template set<Stress>(stress(at, liquid, pressure_after(dt, at, rate), sums.v_slope));
    }
};

/// Ends a gradient in the form that the corrected force sweep reads of neighbours, V sigma L and V sigma q.
template <class At, class R, int D>
CORONET_HD void set_corrected_stress(At const& at, Matrix<R, D> const& T, Vector<R, D> const& s) {
    R const V = at.template get<Volume>();
    at.template set<CorrectedStress>(V * T);
    at.template set<StressOffset>(V * s);
}
/// What a particle adds to its own acceleration there, from its sums over the neighbours.
template <class At, class R, int D, class Sums>
CORONET_HD void set_own_acceleration(At const& at, Matrix<R, D> const& T, Vector<R, D> const& s, Sums const& sums) {
    at.template set<OwnAcceleration>(
        CorrectedStressDivergence::own_part(T, s, at.template get<Density>(), sums.G0, sums.W0));
}

/// From the moments over the neighbours, to which a particle itself adds V W(0).
template <class At, class Sums>
CORONET_HD auto correction_of(At const& at, Sums const& sums, double kernel_at_zero) {
    using R = typename At::Number;
    return GradientCorrection<R, At::dimension>(sums.W0 + R(kernel_at_zero) * at.template get<Volume>(), sums.W1,
                                                sums.G0, sums.G1);
}

/// fpm, and the exterior of cph: the corrected gradient. Without pressure the stress is the viscous one alone. A
/// particle that fell back to the plain gradient, which takes a rotation for a shear, has no viscous stress: so no
/// stress has a torque. Of the viscous stress, `central_share` does not act here but between particles.
struct CorrectedClose {
    GeneralisedNewtonian liquid;
    double kernel_at_zero;
    bool with_pressure = true;
    double dt = 0;  ///< [s], of pressure_after()
    double central_share = 0;

    template <class At, class Sums>
    CORONET_HD void operator()(At const& at, Sums const& sums) const {
        (*this)(at, sums, correction_of(at, sums, kernel_at_zero));
    }
    template <class At, class Sums, class R, int D>
    CORONET_HD void operator()(At const& at, Sums const& sums, GradientCorrection<R, D> const& correction) const {
        auto const grad_v = correction.gradient(sums.v_slope, sums.v_jump);
        R const rate = -at.template get<Density>() * trace(grad_v);
        at.template set<DensityRate>(rate);
        R const p = with_pressure ? pressure_after(dt, at, rate) : R(0);
        auto const sigma = stress(at, liquid, p, grad_v, R(1) - correction.fell_back);
        at.template set<Stress>(sigma);
        auto acting = R(1 - central_share) * sigma;
        unrolled<D>([&](int a) { acting(a, a) -= R(central_share) * p; });
        auto const T = product<R, D>(acting, correction.L);
        auto const s = acting * correction.q;
        set_corrected_stress(at, T, s);
        set_own_acceleration(at, T, s, sums);
        at.template set<FellBack>(correction.fell_back);
    }
};

/// fpm with the viscous force of Morris: the force sweep reads pressures and the correction itself.
struct CorrectionClose {
    double kernel_at_zero;
    double dt = 0;  ///< [s], of pressure_after()

    template <class At, class Sums>
    CORONET_HD void operator()(At const& at, Sums const& sums) const {
        (*this)(at, sums, correction_of(at, sums, kernel_at_zero));
    }
    template <class At, class Sums, class R, int D>
    CORONET_HD void operator()(At const& at, Sums const& sums, GradientCorrection<R, D> const& correction) const {
        R const rate = -at.template get<Density>() * trace(correction.gradient(sums.v_slope, sums.v_jump));
        at.template set<DensityRate>(rate);
        pressure_after(dt, at, rate);
        at.template set<SlopeCorrection>(correction.L);
        at.template set<ValueCorrection>(correction.q);
        at.template set<FellBack>(correction.fell_back);
    }
};

/// The interior of cph near its exterior: the plain gradient, L = I and q = 0, in the form of the corrected one, too;
/// `borders` says whether a particle will use that form itself, and its law has summed what that takes.
template <bool borders>
struct NearClose {
    PlainClose plain;

    template <class At, class Sums>
    CORONET_HD void operator()(At const& at, Sums const& sums) const {
        using R = typename At::Number;
        plain(at, sums);
        auto const sigma = at.template get<Stress>();
        constexpr int D = At::dimension;
        auto const T = product<R, D>(sigma, identity<R, D>());
        Vector<R, D> const s{};
        set_corrected_stress(at, T, s);
        if constexpr (borders) set_own_acceleration(at, T, s, sums);
    }
};

/// How the force sweep ends: stress forces in the corrected form lack what a particle adds itself.
template <int D>
struct PlainForceClose {
    Vector<double, D> gravity;

    template <class At, class Sums>
    CORONET_HD void operator()(At const& at, Sums const& sums) const {
        at.template set<Acceleration>(sums.dv + numbers<typename At::Number>(gravity));
    }
};
template <int D>
struct CorrectedForceClose {
    Vector<double, D> gravity;

    template <class At, class Sums>
    CORONET_HD void operator()(At const& at, Sums const& sums) const {
        at.template set<Acceleration>(sums.dv + at.template get<OwnAcceleration>() +
                                      numbers<typename At::Number>(gravity));
    }
};

/// How the one sweep of plain SPH ends.
template <int D>
struct PlainRatesClose {
    Vector<double, D> gravity;

    template <class At, class Sums>
    CORONET_HD void operator()(At const& at, Sums const& sums) const {
        at.template set<Acceleration>(sums.dv + numbers<typename At::Number>(gravity));
        at.template set<DensityRate>(sums.drho);
    }
};

}  // namespace coronet
