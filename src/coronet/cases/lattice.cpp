// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/lattice.hpp"

namespace coronet {

template <int D>
Lattice<D>::Lattice(Case const& c)
    : spacing_(c.particles.spacing),
      rotation_(c.particles.rotation),
      offset_(c.particles.origin == "cell" ? 0.5 : 0),
      basis_(identity<double, D>()) {
    auto const add = [&](Point n) {
        nearest_.push_back(n);
        for (int& k : n) k = -k;
        nearest_.push_back(n);
    };
    for (int k = 0; k < D; ++k) {
        Point n{};
        n[k] = 1;
        add(n);
    }
    if (c.particles.lattice == "hexagonal") {
        if constexpr (D == 2) {
            basis_ = {{1, 0.5, 0, std::sqrt(0.75)}};
            add({1, -1});
        } else {
            double const s = std::sqrt(0.5);  // face-centred cubic: (1,1,0), (1,0,1), (0,1,1) over the root of two
            basis_ = {{s, s, 0, s, 0, s, 0, s, s}};
            add({1, -1, 0});
            add({1, 0, -1});
            add({0, 1, -1});
        }
    }
    inverse_ = (1 / determinant(basis_)) * adjugate(basis_);
}

template <int D>
bool Lattice<D>::repeats_after(Vector<double, D> const& step) const {
    auto const n = in_lattice(step);
    for (int k = 0; k < D; ++k)
        if (std::fabs(n[k] - std::round(n[k])) > 1e-6) return false;
    return true;
}

template class Lattice<2>;
template class Lattice<3>;

}  // namespace coronet
