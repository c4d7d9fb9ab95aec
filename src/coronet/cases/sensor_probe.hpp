// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A pressure sensor in a wall: the mean pressure over its face, a line (in 3D a square) of a width around a point, of
// liquid that touches it. At points of the face, as many as see spacings apart, the pressure is the Shepard mean over
// the liquid within the kernel's support, weighted with V W; 0 where there is none.

#include "coronet/cases/probe.hpp"
#include "coronet/kernels/kernel.hpp"

namespace coronet {

template <int D>
class Sensor {
public:
    /// At a point [m], of a width [m] along the wall with a normal.
    Sensor(Vector<double, D> const& at, double width, Case const& c);

    double pressure(Particles<D> const& particles) const;

private:
    std::vector<Vector<double, D>> face_;
    Kernel kernel_;
};

template <int D>
class SensorProbe final : public Probe<D> {
public:
    SensorProbe(ProbeKeys const& keys, Case const& c);

    std::vector<std::string> columns() const override { return {name_}; }
    std::vector<double> sample(Snapshot<D> const& now) override { return {sensor_.pressure(now.particles)}; }

private:
    std::string name_;
    Sensor<D> sensor_;
};

}  // namespace coronet
