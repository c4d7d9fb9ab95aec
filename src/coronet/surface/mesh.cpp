// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "coronet/core/error.hpp"
#include "coronet/core/random.hpp"
#include "coronet/surface/arc_coverage.hpp"
#include "coronet/surface/detect.hpp"
#include "coronet/surface/frame.hpp"

namespace coronet {

namespace {

using Vector3 = Vector<double, 3>;
using Triple = std::array<Index, 3>;

constexpr double disorder = 1e-5;  // by which particles are moved to decide [radii]
constexpr int attempts = 8;        // with other random numbers

/// A gap on the circle of i and j, counter-clockwise about the direction from i to j.
struct Edge {
    Index i, j, from, to;
};

/// Images with their originals.
Particles<3> disordered(Particles<3> const& particles, double by, int attempt) {
    Particles<3> moved(particles.owned());
    moved.set_images(particles.size() - particles.owned(), 0);
    moved.allocate(Fields<Position>{});
    for_each(moved.size(), [&](std::size_t i) {
        auto x = particles.view().get<Position>(i);
        auto const id = static_cast<std::uint64_t>(particles.id[i]);
        for (int k = 0; k < 3; ++k)
            x[k] += by * (2 * random(static_cast<std::uint64_t>(attempt) + 1, id, static_cast<std::uint64_t>(k)) - 1);
        moved.view().set<Position>(i, x);
    });
    return moved;
}

/// The sphere of one particle and what others cover of it.
class Sphere {
public:
    void clear() { caps_.clear(); }
    void add(Index j, Vector3 const& x, double radius) {
        double const r = std::sqrt(norm2(x));
        if (r > 0) caps_.push_back({j, (1 / r) * x, r / (2 * radius)});
    }

    /// Calls visit(j, Gap) for the gaps on the circles with those j that are `chosen`.
    template <class Chosen, class Visit>
    void for_gaps(Chosen const& chosen, Visit const& visit) {
        for (Disc const& cap : caps_) {
            if (!chosen(cap.j)) continue;
            auto const [e1, e2] = tangents(cap.n);
            double const s = std::sqrt((1 - cap.c) * (1 + cap.c));
            circle_.clear();
            for (Disc const& other : caps_) {
                if (other.j == cap.j) continue;
                Vector<double, 2> const direction{{s * dot(other.n, e1), s * dot(other.n, e2)}};
                circle_.add(Cap<2>(direction, other.c - cap.c * dot(other.n, cap.n)), other.j);
            }
            if (!circle_.covered()) circle_.for_gaps([&](Gap const& gap) { visit(cap.j, gap); });
        }
    }

private:
    struct Disc {
        Index j;
        Vector3 n;
        double c;  ///< cosine of its angular radius
    };
    std::vector<Disc> caps_;
    ArcCoverage circle_;
};

std::vector<Edge> find_edges(Particles<3>& particles, Neighbours<3> const& neighbours, double radius) {
    mark_surface(particles, neighbours, radius);
    auto const view = particles.view();
    double const* const open = view.at<Surface>();
    auto const original = [&](Index i) {
        return static_cast<Index>(neighbours.images().original(particles, static_cast<std::size_t>(i)));
    };
    Targets const& all = neighbours.all();
    std::vector<std::vector<Edge>> of_block(all.blocks());
    for_blocks(all.blocks(), [&](std::size_t block) {
        static thread_local Sphere sphere;
        for (std::size_t i = all.begin[block]; i < all.begin[block + 1]; ++i) {
            if (open[i] == 0) continue;
            auto const number = static_cast<Index>(i);
            sphere.clear();
            for (Index const j : neighbours.row(i)) {
                auto const x = view.get<Position>(static_cast<std::size_t>(j)) - view.get<Position>(i);
                if (norm2(x) < 4 * radius * radius) sphere.add(j, x, radius);
            }
            sphere.for_gaps([&](Index j) { return original(j) > number && open[original(j)] != 0; },
                            [&](Index j, Gap const& gap) {
                                if (gap.from < 0) return;
                                of_block[block].push_back({number, original(j), original(gap.from), original(gap.to)});
                            });
        }
    });
    std::vector<Edge> edges;
    for (auto const& some : of_block) edges.insert(edges.end(), some.begin(), some.end());
    return edges;
}

/// One side of a triangle, from the particle at `side` to the next.
struct Side {
    Triple triangle;  ///< the smallest number first
    Index side, edge;

    Side(Triple t, Index of_edge) : triangle(t), side(0), edge(of_edge) {
        auto const least = std::min_element(t.begin(), t.end()) - t.begin();
        std::rotate(triangle.begin(), triangle.begin() + least, triangle.end());
        side = static_cast<Index>((3 - least) % 3);
    }
    friend bool operator<(Side const& a, Side const& b) {
        return std::tie(a.triangle, a.side, a.edge) < std::tie(b.triangle, b.side, b.edge);
    }
};

/// Nothing if the edges do not join to a closed mesh.
std::optional<SurfaceMesh> join(std::vector<Edge> const& edges) {
    std::vector<Side> sides;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        auto const& [i, j, from, to] = edges[e];
        sides.push_back({{i, j, from}, static_cast<Index>(2 * e)});
        sides.push_back({{j, i, to}, static_cast<Index>(2 * e + 1)});
    }
    std::sort(sides.begin(), sides.end());
    std::size_t const corners = sides.size();
    if (corners % 3 != 0) return {};
    std::vector<std::size_t> place(corners);  // among the sorted sides of each side of an edge
    for (std::size_t k = 0; k < corners; ++k) {
        bool const fits = sides[k].triangle == sides[k - k % 3].triangle && sides[k].side == static_cast<Index>(k % 3);
        if (!fits) return {};
        place[static_cast<std::size_t>(sides[k].edge)] = k;
    }
    // Around the particle where a side begins, the next side is the other one of the edge that leads there.
    auto const next = [&](std::size_t k) {
        std::size_t const before = k - k % 3 + (k + 2) % 3;
        return place[static_cast<std::size_t>(sides[before].edge ^ 1)];
    };

    SurfaceMesh mesh;
    mesh.triangles.resize(corners / 3);
    std::vector<char> seen(corners, false);
    for (std::size_t begin = 0; begin < corners; ++begin) {
        if (seen[begin]) continue;
        auto const vertex = static_cast<Index>(mesh.particle.size());
        mesh.particle.push_back(sides[begin].triangle[begin % 3]);
        mesh.first.push_back(static_cast<Index>(mesh.corners.size()));
        for (std::size_t k = begin; !seen[k]; k = next(k)) {
            seen[k] = true;
            mesh.triangles[k / 3][k % 3] = vertex;
            mesh.corners.push_back(static_cast<Index>(k));
        }
    }
    mesh.first.push_back(static_cast<Index>(mesh.corners.size()));
    return mesh;
}

}  // namespace

std::vector<Index> SurfaceMesh::parts() const {
    std::vector<Index> part(triangles.size(), -1);
    std::vector<std::size_t> open;
    Index parts = 0;
    for (std::size_t begin = 0; begin < part.size(); ++begin) {
        if (part[begin] >= 0) continue;
        part[begin] = parts;
        open.push_back(begin);
        while (!open.empty()) {
            auto const& triangle = triangles[open.back()];
            open.pop_back();
            for (Index const vertex : triangle)
                for_corners(static_cast<std::size_t>(vertex), [&](std::size_t t, std::size_t) {
                    if (part[t] >= 0) return;
                    part[t] = parts;
                    open.push_back(t);
                });
        }
        ++parts;
    }
    return part;
}

/// One particle, two, or a row of them have no triangle; what is off the mesh inside of liquid has dozens around it.
bool has_strays(SurfaceMesh const& mesh, Particles<3> const& particles, Neighbours<3> const& neighbours,
                double radius) {
    constexpr int few = 12;
    std::vector<char> on_mesh(particles.owned(), 0);
    for (Index const i : mesh.particle) on_mesh[static_cast<std::size_t>(i)] = 1;
    auto const view = particles.view();
    for (std::size_t i = 0; i < on_mesh.size(); ++i) {
        if (on_mesh[i]) continue;
        auto const is_joined = [&](Index at) {
            auto const apart = view.get<Position>(static_cast<std::size_t>(at)) - view.get<Position>(i);
            return norm2(apart) <= 4 * radius * radius;
        };
        if (std::ranges::count_if(neighbours.row(i), is_joined) < few) return true;
    }
    return false;
}

SurfaceMesh find_mesh(Particles<3> const& particles, Neighbours<3> const& neighbours, double radius) {
    check_coverage_radius(radius, neighbours.support());
    for (int attempt = 0; attempt < attempts; ++attempt) {
        auto moved = disordered(particles, disorder * radius, attempt);
        if (auto mesh = join(find_edges(moved, neighbours, radius))) {
            mesh->box = neighbours.images().box();
            mesh->has_strays = has_strays(*mesh, particles, neighbours, radius);
            return *std::move(mesh);
        }
    }
    throw RunError(fmt::format(
        "the surface particles form no closed mesh, although it was tried with {} sets of tiny random displacements: "
        "positions are not finite, or particles coincide by the dozen; a smaller step (time.step) or "
        "method.shifting = 'conserving' keeps them apart",
        attempts));
}

}  // namespace coronet
