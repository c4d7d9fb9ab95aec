// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The columns that every series begins with; the probes' follow, and last the count of singular matrices.

#include <string>
#include <vector>

namespace coronet {

inline std::vector<std::string> standard_columns(int dimension) {
    std::vector<std::string> names{"time", "step", "dt", "particles", "mass", "volume"};
    auto const vector = [&](std::string const& name) {
        for (int k = 0; k < dimension; ++k) names.push_back(name + "_" + "xyz"[k]);
    };
    vector("momentum");
    names.push_back("angular_momentum_z");
    if (dimension == 3) names.insert(names.end(), {"angular_momentum_x", "angular_momentum_y"});
    vector("centre");
    names.insert(names.end(), {"kinetic_energy", "spacing_min"});
    return names;
}

}  // namespace coronet
