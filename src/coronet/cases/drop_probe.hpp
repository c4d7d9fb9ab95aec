// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A drop: how round it is, whether it keeps its area (volume), and whether it stays where its momentum takes it. Shape
// and area are geometric, of the line (drop_outline.hpp) or the boundary (drop_surface.hpp)
// around the largest piece; the area there should be, and the radius R by which lengths are measured,
// follow from mass and density. And where its energy is (energy_ledger.hpp).

#include "coronet/cases/energy_ledger.hpp"

namespace coronet {

template <int D>
class DropProbe final : public Probe<D> {
public:
    explicit DropProbe(Case const& c) : case_(c), ledger_(c) {}
    std::vector<std::string> columns() const override;
    std::vector<double> sample(Snapshot<D> const& now) override;
    std::vector<Measure> measures() const override;

private:
    struct Start {
        double mass, content, radius;
        Vector<double, D> centre, momentum;
    };

    Case const& case_;
    EnergyLedger<D> ledger_;
    std::optional<Start> start_;
    double circularity_ = 0, centre_drift_ = 0, momentum_drift_ = 0, content_error_ = 0, content_error_max_ = 0;
};

}  // namespace coronet
