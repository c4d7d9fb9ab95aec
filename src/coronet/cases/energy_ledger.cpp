// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/energy_ledger.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "coronet/cases/totals.hpp"

namespace coronet {

template <int D>
bool EnergyLedger<D>::is_kept(Case const& c) {
    return c.fluid.surface_tension > 0 && c.surface.tension_force == "boundary";
}

template <int D>
void EnergyLedger<D>::sample(Snapshot<D> const& now, std::vector<double>& row) {
    if (!is_kept_) return;
    double const kinetic = totals(now.particles).kinetic_energy, surface = now.reading("surface_energy");
    Energies const energies{kinetic, surface,
                            kinetic + surface + now.reading("compressive_energy") + now.reading("dissipated_energy")};
    if (!start_) start_ = energies;
    double const drift = energies.total - start_->total, change = surface - start_->surface;
    drift_ = std::max(drift_, std::fabs(drift));
    tension_error_ = std::max(tension_error_, std::fabs(now.reading("tension_work") + change));
    exchanged_ = std::max({exchanged_, std::fabs(change), std::fabs(kinetic - start_->kinetic)});
    row.push_back(drift);
}

template <int D>
void EnergyLedger<D>::add_measures(std::vector<Measure>& measures) const {
    if (!start_ || exchanged_ == 0) return;
    std::string const over =
        fmt::format("largest of all samples, over the {:.4g} {} that kinetic or surface energy changed at most",
                    exchanged_, D == 2 ? "J/m" : "J");
    double const drift = drift_ / exchanged_, error = tension_error_ / exchanged_;
    if (is_free_)
        measures.push_back({"energy_drift", drift, 0.0, drift,
                            "kinetic, surface, compressive and dissipated energy together; " + over});
    else measures.push_back({"energy_drift", drift, {}, {}, "by the outer force, too; " + over});
    measures.push_back(
        {"tension_work_error", error, 0.0, error, "the work of tension less the loss of surface energy; " + over});
}

template class EnergyLedger<2>;
template class EnergyLedger<3>;

}  // namespace coronet
