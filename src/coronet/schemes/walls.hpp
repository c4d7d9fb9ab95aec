// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Walls as particles that fill the solid as deep as the liquid can see. Each has a mirror image beyond the wall's
// surface, x' = x + to_mirror, where liquid is looked at: with the Shepard mean <f> of the liquid around x', its centre
// <x> and the corrected gradient there (terms/gradient_correction.hpp),
//     v' = <v> + grad v (x' - <x>)       exact for a linear flow; <v> alone where the matrix is singular,
//     v  = 2 v_wall - v'                 no slip,
//     v  = v' - 2 n n . (v' - v_wall)    slip, n along to_mirror,
//     p  = <p> + rho0 (g + f - a_wall) . (x - <x>)
// the last after Adami, Hu and Adams, J. Comput. Phys. 231 (2012) 7057, Eq 27. Density follows from the equation of
// state, viscosity from the shear rate at the mirror, so that liquid feels a wall particle as one of its own. Nothing
// is extrapolated: the mirror stands among the liquid. Where it sees none the wall particle moves with the wall and has
// no pressure. Viscous stress is not for walls: a flow under a force would set off the alternating motions that the
// gradient does not see, and a stress from the gradient at the mirror even feeds them. The viscous force between
// velocities sees them.

#include <functional>

#include "coronet/kernels/kernel.hpp"
#include "coronet/materials/equation_of_state.hpp"
#include "coronet/materials/generalised_newtonian.hpp"
#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

template <int D>
struct WallSettings {
    /// Sets WallVelocity for a time [s], moves the walls that move and takes their acceleration off the field
    /// Acceleration; empty: all stand still, as they were given.
    std::function<void(double time, Particles<D>&)> motion;
    /// Adds a body force per mass [m/s^2] at a time [s] to the field Acceleration of [begin, end); empty: none.
    std::function<void(double time, View<D> const&, std::size_t begin, std::size_t end)> body_force;
    Vector<double, D> gravity = {};  ///< [m/s^2]
    EquationOfState equation_of_state;
    GeneralisedNewtonian liquid;
    Kernel kernel;
    Precision precision = Precision::full;
    /// sum V grad W (x_j - x_i) over a full lattice, a multiple of I: the corrected gradient that wall particles take
    /// part with is that of a lattice, L = I over this and q = 0.
    double lattice_slope_moment = 1;
    double contact_range = 1;  ///< of terms/wall_contact.hpp [m]
};

template <int D>
class Walls {
public:
    explicit Walls(WallSettings<D> const& settings) : settings_(settings) {}

    /// Puts walls where they are at `time`, with their velocity, and what acts there on liquid that moves with them.
    void move(Particles<D>& particles, PeriodicBox<D> const& box, double time);
    /// Finds whose mirror is whose, and who is near a wall: after neighbours have been listed.
    void follow(Particles<D> const& particles, Neighbours<D> const& neighbours);
    /// Gives wall particles what the liquid sees of them. Position, Velocity, Volume and Pressure of the liquid and its
    /// images must be set.
    void look_at_liquid(Particles<D>& particles, Neighbours<D> const& neighbours) const;

    /// Adds to the rate of density of the liquid what terms/wall_continuity.hpp says, and finds what
    /// terms/wall_contact.hpp does,
    void add_to_density_rate(Particles<D>& particles, Neighbours<D> const& neighbours);
    /// which this adds to Acceleration, once forces have set it.
    void add_contact(Particles<D>& particles) const;

    /// Whether liquid particle i has wall particles in its row.
    bool is_near(std::size_t i) const { return !near_wall_.empty() && near_wall_[i] != 0; }
    /// The displacement d of liquid particle i, without what would bring it nearer than `least` [m] to the surface of a
    /// wall in front of which it stands.
    Vector<double, D> held_off(Particles<D> const& particles, Neighbours<D> const& neighbours, std::size_t i,
                               Vector<double, D> d, double least) const;

private:
    void find_mirrors(Particles<D> const& particles);

    WallSettings<D> settings_;
    std::vector<std::size_t> wall_of_;  // each mirror
    std::vector<char> near_wall_;       // liquid that has wall particles in its row,
    Targets near_;                      // the same
    std::vector<Vector<double, D>> contact_;  // acceleration of those by walls
};

}  // namespace coronet
