// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/work.hpp"

#include "coronet/kernels/kernel.hpp"
#include "coronet/run/counted.hpp"
#include "coronet/schemes/laws.hpp"

namespace coronet {

namespace {

template <int D, class... F>
constexpr double numbers(Fields<F...>) {
    return (0 + ... + components<F::rank, D>());
}

/// One sweep of a law, of whose results `Kept` are read later.
template <int D, class Kept, class Law>
Work of_sweep(Case const& c, double neighbours, Law const& law) {
    Kernel const kernel = make_kernel(c.method.kernel, D, c.method.support * c.particles.spacing);
    double const record_number = c.method.precision == "double" ? 8 : 4;
    double const read = D + numbers<D>(Unite<typename Law::own, typename Law::reads>{});
    double const record = D + numbers<D>(typename Law::reads{});
    return {
        neighbours * static_cast<double>(operations_per_pair<D>(kernel, law)),
        8 * (read + numbers<D>(Kept{})) + 2 * record_number * record + static_cast<double>(sizeof(Index)) * neighbours};
}

Work operator+(Work const& a, Work const& b) { return {a.operations + b.operations, a.bytes + b.bytes}; }
Work operator*(double share, Work const& a) { return {share * a.operations, share * a.bytes}; }

}  // namespace

template <int D>
Work work_per_evaluation(Case const& c, double neighbours, double exterior) {
    auto const& terms = c.method.pair_terms;
    auto const& central = c.method.central_viscosity;
    bool const with_terms = central.active() || any_active(terms), plain = c.method.gradient == "sph";
    MorrisViscosity const viscosity{c.fluid.viscosity};
    using Rates = Fields<Acceleration, DensityRate>;
    if (plain && (c.method.viscous_force == "morris" || c.fluid.viscosity == 0))
        return with_terms ? of_sweep<D, Rates>(c, neighbours, PlainSweepAndPairTerms{{}, viscosity, {}, terms})
                          : of_sweep<D, Rates>(c, neighbours, PlainSweep{{}, viscosity, {}});

    using ForForces = Fields<DensityRate, CorrectedStress, StressOffset, OwnAcceleration>;
    using Forces = Fields<Acceleration>;
    double const corrected = plain ? 0 : c.method.gradient == "cph" ? exterior : 1;
    return (1 - corrected) * (of_sweep<D, Fields<DensityRate, Stress>>(c, neighbours, PlainGradients{}) +
                              (with_terms ? of_sweep<D, Forces>(c, neighbours, PlainForcesAndPairTerms{{}, terms})
                                          : of_sweep<D, Forces>(c, neighbours, PlainForces{}))) +
           corrected *
               (of_sweep<D, ForForces>(c, neighbours, CorrectedGradients{}) +
                (with_terms ? of_sweep<D, Forces>(c, neighbours, CorrectedForcesAndPairTerms{{}, central, terms})
                            : of_sweep<D, Forces>(c, neighbours, CorrectedForces{})));
}

template Work work_per_evaluation<2>(Case const&, double, double);
template Work work_per_evaluation<3>(Case const&, double, double);

}  // namespace coronet
