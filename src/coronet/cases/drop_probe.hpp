// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A drop in 2D: how round it is, whether it keeps its area, and whether it stays where its momentum takes it. Shape and
// area are geometric, of the outline of the largest piece moved out by half a spacing (drop_outline.hpp); the area
// there should be, and the radius R by which lengths are measured, follow from mass and density.

#include "coronet/cases/probe.hpp"

namespace coronet {

class DropProbe final : public Probe<2> {
public:
    explicit DropProbe(Case const& c) : case_(c) {}
    std::vector<std::string> columns() const override;
    std::vector<double> sample(Snapshot<2> const& now) override;
    std::vector<Measure> measures() const override;

private:
    struct Start {
        double mass, area, radius;
        Vector<double, 2> centre, momentum;
    };

    Case const& case_;
    std::optional<Start> start_;
    double circularity_ = 0, centre_drift_ = 0, momentum_drift_ = 0, area_error_ = 0, area_error_max_ = 0;
};

}  // namespace coronet
