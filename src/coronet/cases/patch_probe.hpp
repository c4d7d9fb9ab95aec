// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is looked at in the rotating square patch: how far corners and mid-sides are from the centre, the pressure
// there, the number of fragments (particles linked within three spacings), and the area inside the outline.
//
// The outline runs through the particles of the initial surface in their initial order, by identity: it stays the
// material surface. The part of their volume that lies outside it (half of an edge particle, three quarters of a corner
// one) keeps its size in an incompressible flow and is added as it was at the start.
//
// Shifted particles are no points of the liquid. With method.shifting the outline is that of the largest piece as it
// lies, moved out by half a spacing (cases/drop_outline.hpp). A corner of the exact patch feels no pressure gradient,
// and turns by atan(omega t): the corner radius is the mean of the farthest points in the four quarters around the
// exact corners, the half-width of the sides that of the nearest points in the quarters between.

#include <cstdint>
#include <vector>

#include "coronet/cases/probe.hpp"
#include "coronet/kernels/kernel.hpp"

namespace coronet {

class PatchProbe final : public Probe<2> {
public:
    PatchProbe(ProbeKeys const& keys, Case const& c);
    std::vector<std::string> columns() const override;
    std::vector<double> sample(Snapshot<2> const& now) override;
    std::vector<Measure> measures() const override;

private:
    /// Distances from the centre [m], and the area inside the outline [m^2].
    struct Seen {
        double corner, side, area;
    };
    void remember_surface(Particles<2> const& particles);
    Seen material_outline(Particles<2> const& particles) const;
    Seen outline_as_it_lies(Snapshot<2> const& now) const;

    Case const& case_;
    Kernel kernel_;
    double spacing_, side_, omega_;
    std::vector<std::int64_t> outline_, corners_, mid_sides_;  // identities
    double outside_area_ = 0, first_area_ = 0, area_ = 0;
    int fragments_ = 0;
};

}  // namespace coronet
