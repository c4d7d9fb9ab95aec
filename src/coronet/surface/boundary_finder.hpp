// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Finds the boundary of a liquid on which tension acts, again and again as its particles move: in 2D from the outline
// (boundary.hpp), sought each time among the particles that can have come to it since neighbours were listed; in 3D
// from the mesh (mesh_boundary.hpp), whose triangles are kept until neighbours are listed anew: it lags by less than
// the skin of the lists. Where triangles change, or other particles are on the outline, the size jumps; the jumps are
// counted.

#include "coronet/surface/mesh_boundary.hpp"
#include "coronet/surface/tension.hpp"

namespace coronet {

template <int D>
class BoundaryFinder {
public:
    /// From one call to the next the particles and their neighbours are the same objects.
    Boundary<D> operator()(Particles<D>& particles, Neighbours<D> const& neighbours, SurfaceSettings const& settings);

    /// The sum of what the size was changed by, up and down, where other particles came to make the surface [m^(D-1)].
    double jumps() const { return jumps_; }

private:
    double jumps_ = 0;
    std::vector<std::vector<std::int64_t>> lines_;  // in 2D the identities along each loop of the outline,
    Targets candidates_;                            // and who can be on it;
    SurfaceMesh mesh_;                              // in 3D,
    std::vector<std::int64_t> of_mesh_;             // the identities of its vertices' particles;
    std::size_t listing_ = 0;                       // and the listing of neighbours that these belong to
};

}  // namespace coronet
