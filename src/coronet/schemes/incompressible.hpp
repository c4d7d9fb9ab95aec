// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Incompressible flow by projection: a step with every force but that of pressure, then the pressure whose force leaves
// the velocity without divergence (schemes/projection.hpp),
//     x_half = x + dt v/2,
//     v*     = v + dt (div tau/rho + f)     at x_half,
//     v_new  = v* + dt dv(p),               div v_new = 0 at x_half,
//     x_new  = x + dt (v + v_new)/2.
// It is Lobo (2011), section 3.3, with the forces where they conserve angular momentum: half a step on. Pressure,
// viscous stress and pair terms conserve momentum each by itself, and sum m x cross v then changes by nothing but
// round-off; so does tension on the boundary, that of curvatures does not. Density is a constant.
//
// Two pressure operators: `consistent`, whose force is the negative transpose of its divergence (Fang et al. 2009), and
// `thesis`, Lobo's (3.61)-(3.63). Viscous stress is as in the weakly compressible scheme, with the corrected gradient
// and its dual; its step is `explicit`, as above, or `implicit` (schemes/viscous_step.hpp): v* is then what both stress
// and f have done to v over dt, and viscosity limits no step. Surface tension is that of surface/tension.hpp; with the
// one that acts on the boundary the mean of the pressure does so, too (schemes/mean_on_boundary.hpp).
//
// Pressure, Stress = -p I + tau and Viscosity are those of the last step, half of it before the particles: what acted
// over it. Before the first step they are 0, but for Viscosity.

#include <functional>
#include <memory>
#include <optional>

#include "coronet/materials/generalised_newtonian.hpp"
#include "coronet/schemes/conserving_shift.hpp"
#include "coronet/schemes/mean_on_boundary.hpp"
#include "coronet/schemes/pair_terms.hpp"
#include "coronet/schemes/projection.hpp"
#include "coronet/schemes/scheme.hpp"
#include "coronet/schemes/shifting.hpp"
#include "coronet/schemes/thesis_pressure.hpp"
#include "coronet/schemes/viscous_step.hpp"
#include "coronet/surface/boundary_finder.hpp"
#include "coronet/surface/tension.hpp"
#include "coronet/terms/central_viscosity.hpp"

namespace coronet {

template <int D>
class Incompressible final : public Scheme<D> {
public:
    enum class Operator { consistent, thesis };
    enum class Viscous { explicit_step, implicit_step };

    struct Settings {
        Kernel kernel, pressure_kernel;  ///< of the same support
        double skin = 0;                 ///< [m]; 0: tuned
        GeneralisedNewtonian liquid;
        double density = 1000;               ///< [kg/m^3]
        double sound_speed = 0;              ///< [m/s], of artificial viscosity alone
        CentralViscosity central_viscosity;  ///< in an explicit step
        PairTerms pair_terms;
        Viscous viscous_step = Viscous::explicit_step;
        Operator pressure = Operator::consistent;
        double compact_share = 0;  ///< of the consistent operator: how much of a compact Laplacian damps checkerboards
        typename ThesisPressure<D>::Options thesis;
        Preconditioning preconditioning = Preconditioning::multigrid;
        SolveLimits solve;  ///< of pressure and implicit viscous step
        SurfaceSettings surface;
        ShiftingSettings shifting;
        double shift_range = 0;          ///< [m], of schemes/conserving_shift.hpp; 0: no shifting
        double courant = 0.25;           ///< safe factor on h/speed
        Vector<double, D> gravity = {};  ///< [m/s^2]
        /// Adds a body force per mass [m/s^2] at a time [s] to the field Acceleration of [begin, end); empty: none.
        std::function<void(double, View<D> const&, std::size_t begin, std::size_t end)> body_force;
    };

    /// Takes particles with Position, Velocity, Density, Mass set.
    Incompressible(Settings const& settings, Particles<D> particles);

    void begin_step(double time) override;
    StepLimit time_limit() const override;
    /// Throws RunError where a solve does not converge.
    void advance(double time, double step) override;
    void refresh() override {}
    Arrangement arrangement() override;

    Particles<D> const& particles() const override { return particles_; }
    Counters const& counters() const override { return counters_; }
    Phases& phases() override { return phases_; }
    std::vector<Reading> readings() const override;

private:
    bool has_tension() const { return settings_.surface.tension > 0; }
    bool needs_surface() const;
    void look_at_surface();
    void tension();
    void forces(double time);
    void push(double step);
    void project(double step);
    void set_stress();
    void add_works(double step);

    Settings settings_;
    Particles<D> particles_;
    Neighbours<D> neighbours_;
    Shifting<D> shifting_;
    BoundaryFinder<D> find_boundary_;
    Boundary<D> boundary_;                       ///< if tension acts on it
    std::vector<Vector<double, D>> resistance_;  ///< then the acceleration by viscous and artificial forces
    Works works_;                                ///< and what was done so far [J]
    ThesisPressure<D>* thesis_ = nullptr;        ///< the projection's, if it is that one
    MeanOnBoundary<D>* on_boundary_ = nullptr;   ///< around it, if there is one
    Projection<D> projection_;
    Counters counters_;
    Phases phases_;
    std::optional<ViscousStep<D>> viscous_step_;  ///< if it is implicit
    std::optional<ConservingShift<D>> shift_;
    Solved solved_, viscous_solved_;
    double divergence_ = 0;  ///< the largest that the last projection left [1/s]
};

}  // namespace coronet
