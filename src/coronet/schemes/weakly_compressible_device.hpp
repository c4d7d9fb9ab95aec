// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "coronet/schemes/weakly_compressible.hpp"

namespace coronet {

/// The rates of the weakly compressible scheme (sph or fpm, without pair terms, viscosity along pairs and body force)
/// on a GPU: copies the state there, runs the same laws and closes as the host, and brings DensityRate and Acceleration
/// back. Throws RunError if there is no GPU. The host's Volume and Pressure must fit the density.
template <int D>
void rates_on_device(typename WeaklyCompressible<D>::Settings const& settings, Particles<D>& particles,
                     Neighbours<D> const& neighbours);

}  // namespace coronet
