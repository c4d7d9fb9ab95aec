// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A profile: a field along a line, beside what it should be. And when a run has settled: when none of its profiles has
// changed since 4/5 of the time, by more than a given share of its own root mean square. Whatever decays as exp(-k t)
// differs by exp(-k t) (exp(k t/5) - 1) then, so what is left of it is less than that share.

#include <string>
#include <utility>
#include <vector>

namespace coronet {

struct Profile {
    std::string name;
    std::vector<double> position;             ///< [m]
    std::vector<double> computed, reference;  ///< of the unit of the field; no reference: empty
};

/// sqrt(sum (computed - reference)^2/sum reference^2)
double relative_error(Profile const& profile);

class Settling {
public:
    /// Takes the profiles of a time [s], and returns the largest change as defined above; infinite while that is not
    /// known.
    double change(double time, std::vector<Profile> const& profiles);

private:
    std::vector<std::pair<double, std::vector<Profile>>> before_;  // from 4/5 of the time on
};

}  // namespace coronet
