// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/weakly_compressible_device.hpp"

#include <thrust/copy.h>
#include <thrust/device_vector.h>
#include <thrust/host_vector.h>

#include "coronet/core/error.hpp"
#include "coronet/pairs/sweep_cuda.cuh"
#include "coronet/schemes/laws.hpp"
#include "coronet/schemes/stress_close.hpp"

namespace coronet {

namespace {

/// Every allocated field of the host's particles, copied to the device and, those asked for, back.
template <int D>
class DeviceFields {
public:
    explicit DeviceFields(Particles<D> const& particles) : host_(particles.view()), device_(host_) {
        for_every_field([&](int field, int components) {
            if (!particles.has(field)) return;
            double const* const from = host_.first[field];
            array_[field].assign(from, from + static_cast<std::size_t>(components) * host_.stride);
            device_.first[field] = thrust::raw_pointer_cast(array_[field].data());
        });
    }
    View<D> const& view() const { return device_; }

    template <class F>
    void bring_back() const {
        thrust::copy(array_[F::number].begin(), array_[F::number].end(), host_.first[F::number]);
    }

private:
    template <class Visit>
    static void for_every_field(Visit const& visit) {
#define CORONET_VISIT(name, symbol, rank, unit, meaning) visit(name::number, components<Rank::rank, D>());
        CORONET_FIELDS(CORONET_VISIT)
#undef CORONET_VISIT
    }

    View<D> host_, device_;
    thrust::device_vector<double> array_[field_count];
};

}  // namespace

template <int D>
void rates_on_device(typename WeaklyCompressible<D>::Settings const& settings, Particles<D>& particles,
                     Neighbours<D> const& neighbours) {
    int devices = 0;
    if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) throw RunError("there is no CUDA device");

    std::size_t const n = particles.owned();
    thrust::host_vector<std::size_t> begin(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i) begin[i + 1] = begin[i] + neighbours.row(i).size();
    thrust::host_vector<Index> neighbour(begin.back());
    for (std::size_t i = 0; i < n; ++i) {
        std::ranges::copy(neighbours.row(i), neighbour.begin() + static_cast<std::ptrdiff_t>(begin[i]));
    }
    thrust::device_vector<std::size_t> const begin_there = begin;
    thrust::device_vector<Index> const index_there = neighbour;
    DeviceRows const rows{thrust::raw_pointer_cast(begin_there.data()), thrust::raw_pointer_cast(index_there.data())};

    DeviceFields<D> const fields(particles);
    auto const& view = fields.view();
    auto const& kernel = settings.kernel;
    if (settings.gradient == Gradient::sph) {
        sweep_on_device(view, rows, n, kernel, PlainGradients{}, PlainClose{settings.liquid});
        sweep_on_device(view, rows, n, kernel, PlainForces{}, PlainForceClose<D>{settings.gravity});
    } else {
        sweep_on_device(view, rows, n, kernel, CorrectedGradients{},
                        CorrectedClose{settings.liquid, kernel.at_zero()});
        sweep_on_device(view, rows, n, kernel, CorrectedForces{}, CorrectedForceClose<D>{settings.gravity});
    }
    fields.template bring_back<DensityRate>();
    fields.template bring_back<Acceleration>();
}

template void rates_on_device(WeaklyCompressible<2>::Settings const&, Particles<2>&, Neighbours<2> const&);
template void rates_on_device(WeaklyCompressible<3>::Settings const&, Particles<3>&, Neighbours<3> const&);

}  // namespace coronet
