// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The weakly compressible scheme of Fang, Parriaux, Rentschler and Ancey, Appl. Numer. Math. 59 (2009) 251:
//     drho/dt = -rho div v        (60)
//     dv/dt   = (1/rho) div sigma (61), the dual of (60), plus gravity, body force and the case's pair terms
//     p       = p(rho),  sigma = -p I + 2 mu d   (8, 5, 6, 62), mu by the rheology
// with one of three gradients: sph (plain), fpm (corrected everywhere), cph (corrected near the free surface).
// Where surface tension acts on the boundary of the liquid, the mean pressure does so, too, and continuity gives each
// piece of liquid the rate of volume of its boundary (surface/boundary.hpp): with V the volumes and a bar for their
// mean,
//     drho/dt = -rho (div v - mean div v + (d content/dt)/sum V),   m dv/dt = ... (p - mean p) ... + (mean p) grad
//     content,
// dual to each other as (60) and (61) are.
// In time the predictor-corrector (88)-(89): half a step with the rates at the start, a whole step with those at the
// half; or symplectic Euler, with one evaluation a step:
//     rho_new = rho + dt drho/dt(x, v),   v_new = v + dt dv/dt(x, p(rho_new)),   x_new = x + dt v_new.

#include <functional>
#include <optional>

#include "coronet/kernels/kernel.hpp"
#include "coronet/materials/equation_of_state.hpp"
#include "coronet/materials/generalised_newtonian.hpp"
#include "coronet/neighbours/neighbours.hpp"
#include "coronet/schemes/conserving_shift.hpp"
#include "coronet/schemes/coupled_zones.hpp"
#include "coronet/schemes/implicit_viscosity.hpp"
#include "coronet/schemes/pair_terms.hpp"
#include "coronet/schemes/scheme.hpp"
#include "coronet/schemes/shifting.hpp"
#include "coronet/schemes/walls.hpp"
#include "coronet/surface/boundary_finder.hpp"
#include "coronet/surface/tension.hpp"
#include "coronet/terms/central_viscosity.hpp"

namespace coronet {

enum class Gradient { sph, cph, fpm };

enum class ViscousForce {
    stress,  ///< the dual of the velocity gradient, Fang et al. (2009) Eq 61
    morris   ///< Morris, Fox and Zhu (1997), between velocities: with sph and fpm
};

enum class Stepping { predictor_corrector, symplectic_euler };

/// How the corrector moves the particles over a whole step.
enum class PositionUpdate {
    mean_velocity,     ///< by the mean of old and new velocity: conserves angular momentum to round-off
    midpoint_velocity  ///< by the predicted velocity, as printed in the paper: conserves it to the square of the step
};

template <int D>
class WeaklyCompressible final : public Scheme<D> {
public:
    struct Settings {
        Kernel kernel;
        double skin = 0;  ///< [m]; 0: tuned
        Precision precision = Precision::full;
        Gradient gradient = Gradient::fpm;
        ViscousForce viscous_force = ViscousForce::stress;
        Stepping stepping = Stepping::predictor_corrector;
        PositionUpdate position_update = PositionUpdate::mean_velocity;  ///< of the predictor-corrector
        double courant = 0.25;                                           ///< safe factor on h/c
        EquationOfState equation_of_state;
        GeneralisedNewtonian liquid;
        CentralViscosity central_viscosity;  ///< with fpm and viscous_force = stress
        PairTerms pair_terms;
        SurfaceSettings surface;
        ShiftingSettings shifting;
        double shift_range = 0;          ///< [m], of schemes/conserving_shift.hpp; 0: none
        Vector<double, D> gravity = {};  ///< [m/s^2]
        /// Adds a body force per mass [m/s^2] at a time [s] to the field Acceleration of [begin, end); empty: none.
        std::function<void(double, View<D> const&, std::size_t begin, std::size_t end)> body_force;
        bool implicit_viscosity = false;
        SolveLimits solve;  ///< of an implicit viscosity
        PeriodicBox<D> box;
        double lattice_slope_moment = 1;                         ///< see WallSettings
        double wall_contact = 1;                                 ///< contact_range there [m]
        std::function<void(double, Particles<D>&)> wall_motion;  ///< see WallSettings
    };

    /// Takes particles with Position, Velocity, Density, Mass (and Surface for cph) set, and at wall particles
    /// Position, Mass, WallVelocity, ToMirror and Slip.
    WeaklyCompressible(Settings const& settings, Particles<D> particles);

    void begin_step(double time) override;
    StepLimit time_limit() const override;
    void advance(double time, double step) override;
    void refresh() override;
    Arrangement arrangement() override;
    std::vector<Reading> readings() const override;

    Particles<D> const& particles() const override { return particles_; }
    Counters const& counters() const override { return counters_; }
    Phases& phases() override { return phases_; }

    /// The rates of change of velocity and density for the state as it is; with dt > 0 under the pressure that density
    /// has after so long a step [s]; with shift > 0, and shifting, the shift of so long a step, too.
    void evaluate(double time, double dt = 0, double shift = 0);

private:
    template <class... Parts>
    void sweep_parts(Parts const&... parts);
    void update_neighbours();
    void update_state();
    void update_surroundings();
    void look_ahead(double dt);
    void count_singular();
    void refresh_images();
    void find_boundary_and_mean_pressure(double dt);
    void look_ahead_on_boundary(double dt, std::vector<double> const& volume, std::vector<double>& excess);
    void act_on_boundary(double dt);
    void look_at_dissipation();
    std::vector<double> content_rates() const;
    Works rates_of_work(double dt) const;
    double power() const;
    void predict_and_correct(double time, double step);
    void symplectic_step(double time, double step);
    void damp(double step);
    void gradients_and_stress(double dt, double shift = 0);
    void forces();
    bool one_sweep() const;
    bool variable_morris() const;
    bool corrected_morris() const;
    bool corrected_between() const;
    void rates_in_one_sweep();

    Settings settings_;
    Particles<D> particles_;
    Neighbours<D> neighbours_;
    Walls<D> walls_;
    BoundaryFinder<D> find_boundary_;
    // If tension acts on the boundary: it, the mean pressure of each piece, the work done so far [J] and the power of
    // friction in the last evaluation [W].
    Boundary<D> boundary_;
    std::vector<double> mean_pressure_;
    Works works_;
    double dissipation_ = 0;
    // With symplectic steps, of each piece: the mean rate at which continuity between particles raises pressure [Pa/s],
    // and what the content would have gained on the way of the last step at the rates where that began.
    std::vector<double> mean_gain_;
    struct {
        double step = 0;           // [s]
        std::vector<double> gain;  // [m^D]
    } last_way_;
    Shifting<D> shifting_;
    std::optional<ConservingShift<D>> conserving_shift_;
    CoupledZones<D> zones_;  // of cph
    std::optional<ImplicitViscosity<D>> implicit_viscosity_;
    Solved viscous_solved_;
    Vector<double, D> wall_force_;  // on all walls [N]
    Counters counters_;
    Phases phases_;
};

}  // namespace coronet
