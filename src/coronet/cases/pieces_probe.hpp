// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Liquid in several pieces, as drops that collide: how many there are, particles being of one piece if balls of the
// coverage radius join them, as tension has it (surface/pieces.hpp); the gap between the nearest two of them, a spacing
// less than their particles are apart, 0 where there is one piece; and whether momentum and its moment are kept.

#include "coronet/cases/energy_ledger.hpp"

namespace coronet {

template <int D>
class PiecesProbe final : public Probe<D> {
public:
    explicit PiecesProbe(Case const& c) : case_(c), is_free_(no_outer_force(c)), ledger_(c) {}
    std::vector<std::string> columns() const override;
    std::vector<double> sample(Snapshot<D> const& now) override;
    std::vector<Measure> measures() const override;

private:
    struct Start {
        Vector<double, D> momentum;
        Vector<double, 3> angular_momentum;
        double momentum_scale, angular_scale;  // sum m |v| and sum m |x| |v|, from the centre of mass
    };
    struct Pieces {
        std::size_t count = 0;
        double gap = 0;  // [m]
    };
    static Start start_of(Particles<D> const& particles);
    Pieces look_at(Particles<D> const& particles) const;

    Case const& case_;
    bool is_free_;
    EnergyLedger<D> ledger_;
    std::optional<Start> start_;
    Pieces pieces_;
    double momentum_drift_ = 0, angular_drift_ = 0, last_gap_ = 0;
    std::optional<double> joined_;  // when fewer pieces were seen for the first time [s]
};

}  // namespace coronet
