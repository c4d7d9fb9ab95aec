// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/wall_forces.hpp"

#include "coronet/pairs/sweep.hpp"
#include "coronet/schemes/laws.hpp"
#include "coronet/terms/stress_divergence.hpp"

namespace coronet {

namespace {

/// Opposite to what terms/wall_contact.hpp does to the liquid.
template <int D>
void add_contact(Particles<D>& particles, Neighbours<D> const& neighbours, WallContact const& contact) {
    auto const view = particles.view();
    std::size_t const first = particles.begin(Role::wall);
    for_each(particles.count(Role::wall), [&](std::size_t k) {
        std::size_t const w = first + k;
        auto const x = view.template get<Position>(w);
        auto force = view.template get<WallForce>(w);
        for (Index const at : neighbours.row(w)) {
            auto const j = static_cast<std::size_t>(at);
            auto const from_wall = view.template get<Position>(j) - x;
            double const r2 = norm2(from_wall);
            if (r2 >= contact.range * contact.range) continue;
            double const mass = view.template get<Volume>(j) * view.template get<Density>(j);  // of an image, too
            force += (-mass * contact.push(r2)) * from_wall;
        }
        view.template set<WallForce>(w, force);
    });
}

}  // namespace

template <int D>
void find_wall_forces(Particles<D>& particles, Neighbours<D> const& neighbours,
                      typename WeaklyCompressible<D>::Settings const& settings) {
    if (particles.count(Role::wall) == 0) return;
    auto const view = particles.view();
    auto const& terms = settings.pair_terms;
    auto const sweep_walls = [&](auto const& law, auto const& close) {
        sweep(particles, neighbours, settings.kernel, settings.precision,
              Part{neighbours.walls(), law, OneByOne{close}});
    };
    auto const take = [&](std::size_t w, auto const& sums) {
        double const mass = view.template get<Volume>(w) * view.template get<Density>(w);
        view.template set<WallForce>(w, mass * sums.dv);
    };
    bool const fpm = settings.gradient == Gradient::fpm, morris = settings.viscous_force == ViscousForce::morris;
    if (fpm && morris) {
        CorrectedMorrisViscosity const viscosity{settings.liquid.rheology.viscosity};
        sweep_walls(CorrectedPressureAndMorris{{}, viscosity, terms}, take);
    } else if (fpm) {
        // The law's sums lack what a particle adds itself.
        sweep_walls(MirrorSums{}, [&](std::size_t w, auto const& sums) {
            double const per_V = 1 / view.template get<Volume>(w);
            view.template set<OwnAcceleration>(
                w, CorrectedStressDivergence::own_part(per_V * view.template get<CorrectedStress>(w),
                                                       per_V * view.template get<StressOffset>(w),
                                                       view.template get<Density>(w), sums.G0, sums.W0));
        });
        sweep_walls(CorrectedForcesAndPairTerms{{}, {}, terms}, [&](std::size_t w, auto const& sums) {
            double const mass = view.template get<Volume>(w) * view.template get<Density>(w);
            view.template set<WallForce>(w, mass * (sums.dv + view.template get<OwnAcceleration>(w)));
        });
    } else if (settings.liquid.is_newtonian()) {
        MorrisViscosity const viscosity{settings.liquid.rheology.viscosity};
        sweep_walls(PlainSweepAndPairTerms{{}, viscosity, {}, terms}, take);
    } else {
        sweep_walls(PressureAndVariableMorris{{}, {}, terms}, take);
    }
    add_contact(particles, neighbours, WallContact{settings.wall_contact, settings.equation_of_state.c});
}

template void find_wall_forces(Particles<2>&, Neighbours<2> const&, WeaklyCompressible<2>::Settings const&);
template void find_wall_forces(Particles<3>&, Neighbours<3> const&, WeaklyCompressible<3>::Settings const&);

}  // namespace coronet
