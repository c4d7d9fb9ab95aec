// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A probe looks at the particles at every sample: it adds columns to the series and, at the end, measures to the
// summary, beside their exact value where there is one.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coronet/cases/profile.hpp"
#include "coronet/cases/snapshot.hpp"

namespace coronet {

/// A number the case exists for.
struct Measure {
    std::string name;
    double value;  ///< NaN where it could not be had: `source` says why
    std::optional<double> reference, error;
    std::string source;
    std::optional<double> standard_error = {};  ///< of a value that was fitted, in its unit
};

template <int D>
class Probe {
public:
    virtual ~Probe() = default;
    virtual std::vector<std::string> columns() const = 0;
    /// One number per column. Called in the order of time, first at t = 0.
    virtual std::vector<double> sample(Snapshot<D> const& now) = 0;
    virtual std::vector<Measure> measures() const { return {}; }
    /// Of the last sample; always the same ones.
    virtual std::vector<Profile> profiles() const { return {}; }
};

/// The case must outlive its probes.
template <int D>
std::vector<std::unique_ptr<Probe<D>>> make_probes(Case const& c);

/// Whether neither gravity nor a body force acts, so that momentum and its moment are conserved.
bool no_outer_force(Case const& c);

}  // namespace coronet
