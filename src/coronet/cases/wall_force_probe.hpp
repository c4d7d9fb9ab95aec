// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force of the liquid on a wall and its torque about the wall's centre, wherever that has moved: sums of the forces
// on its wall particles (schemes/wall_forces.hpp). Gravity and body forces on the liquid reach a wall only through it.

#include "coronet/cases/probe.hpp"
#include "coronet/cases/wall_motion.hpp"
#include "coronet/neighbours/images.hpp"

namespace coronet {

/// Which of the case's walls has a name; walls.size() where none has.
std::size_t wall_named(std::string const& name, Case const& c);

/// The force on wall number `wall` [N] and its torque about a point [N m]; per metre of depth in 2D. In 2D the torque
/// is the third component. With a box, of which walls that move cross the faces, levers are those to the nearest copy.
template <int D>
struct WallLoad {
    Vector<double, D> force;
    Vector<double, 3> torque;
};
template <int D>
WallLoad<D> wall_load(Particles<D> const& particles, std::size_t wall, Vector<double, D> const& about,
                      PeriodicBox<D> const& box = {});

template <int D>
class WallForceProbe final : public Probe<D> {
public:
    WallForceProbe(ProbeKeys const& keys, Case const& c);

    std::vector<std::string> columns() const override;
    std::vector<double> sample(Snapshot<D> const& now) override;

private:
    std::string name_;
    std::size_t wall_;
    Vector<double, D> centre_;
    WallMotion<D> motion_;
    PeriodicBox<D> box_;  // if the wall moves
};

}  // namespace coronet
