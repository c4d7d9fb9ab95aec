// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/rheology_check.hpp"

#include <cmath>

#include "coronet/cases/fluid.hpp"

namespace coronet {

void check_rheology(Case const& c, Errors& errors) {
    Rheology const law = rheology_of(c);
    double const m = law.cross_exponent, contrast = law.zero_shear_viscosity / law.infinite_shear_viscosity;
    double const most = std::pow((m + 1) / (m - 1), 2);
    if (law.model == Rheology::Model::cross && m > 1 && contrast > most)
        say(errors,
            "fluid.cross_exponent = {} with zero_shear_viscosity {:.4g} times infinite_shear_viscosity lets the stress "
            "fall as the shear rate rises, and such a flow is unstable: use an exponent of at most 1, or a ratio of at "
            "most {:.4g}",
            m, contrast, most);
    if (law.model == Rheology::Model::carreau_yasuda && law.power_index > 1)
        say(errors,
            "fluid.power_index = {} lets the viscosity of carreau-yasuda grow without end: use at most 1; a liquid "
            "that thickens has a zero_shear_viscosity below its infinite_shear_viscosity",
            law.power_index);
    bool const bounded = law.model == Rheology::Model::power_law || law.model == Rheology::Model::herschel_bulkley;
    if (bounded && law.shear_rate_min >= law.shear_rate_max)
        say(errors, "fluid.shear_rate_min = {} 1/s must be below fluid.shear_rate_max = {} 1/s", law.shear_rate_min,
            law.shear_rate_max);
}

}  // namespace coronet
