// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A round drop at rest: the mean pressure within half of its radius, where Laplace has (D - 1) sigma/R, and the fastest
// particle, where there should be no motion. Measured over the second half of the samples, when the sound of the start
// is gone: the mean of the pressure, and the largest capillary number mu |v|/sigma, v relative to the mean velocity.

#include "coronet/cases/probe.hpp"

namespace coronet {

template <int D>
class StaticDropProbe final : public Probe<D> {
public:
    explicit StaticDropProbe(Case const& c) : case_(c) {}
    std::vector<std::string> columns() const override { return {"pressure_jump", "spurious_speed"}; }
    std::vector<double> sample(Snapshot<D> const& now) override;
    std::vector<Measure> measures() const override;

private:
    Case const& case_;
    double radius_ = 0, mass_ = 0;                   // at the start, from the volume [m]; [kg]
    std::vector<double> pressure_, speed_, volume_;  // of all samples
};

}  // namespace coronet
