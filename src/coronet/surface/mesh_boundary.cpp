// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/mesh_boundary.hpp"

#include <algorithm>
#include <cmath>

#include "coronet/surface/pieces.hpp"

namespace coronet {

namespace {

using Vector3 = Vector<double, 3>;

constexpr double least_share = 0.5;   // s_v [spacings^2]
constexpr double least_normal = 0.5;  // |N_v| over the area around v

Vector3 cross(Vector3 const& a, Vector3 const& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// What something depends on size and on content.
template <class T>
struct Both {
    T size{}, content{};
};

/// The corners of the boundary, and how they follow its particles.
class Corners {
public:
    Corners(SurfaceMesh const& mesh, std::vector<Vector3> x, double spacing, double volume)
        : mesh_(mesh), x_(std::move(x)), corners_(x_), triangle_(mesh.triangles.size()), vertex_(mesh.vertices()) {
        for_each(triangle_.size(), [&](std::size_t t) {
            auto const& v = mesh_.triangles[t];
            for (std::size_t k = 1; k < 3; ++k)
                triangle_[t].shift[k] =
                    mesh_.box.shift_to_nearest(x_[static_cast<std::size_t>(v[k])] - x_[static_cast<std::size_t>(v[0])]);
            triangle_[t].normal = vector_area(t, x_);
            triangle_[t].area = std::sqrt(norm2(triangle_[t].normal));
        });
        for_each(vertex_.size(), [&](std::size_t v) {
            mesh_.for_corners(v, [&](std::size_t t, std::size_t) {
                vertex_[v].normal += triangle_[t].normal;
                vertex_[v].area += triangle_[t].area;
            });
        });
        for_each(triangle_.size(), [&](std::size_t t) {
            for (Index const v : mesh_.triangles[t]) triangle_[t].share += of(v).area / 9;
        });
        for_each(vertex_.size(), [&](std::size_t v) {
            auto& vertex = vertex_[v];
            mesh_.for_corners(v, [&](std::size_t t, std::size_t) { vertex.share += triangle_[t].share / degree(v); });
            double const length = std::sqrt(norm2(vertex.normal)), least = least_normal * vertex.area;
            vertex.crowded = vertex.share < least_share * spacing * spacing;
            vertex.folded = length < least;
            double const share = std::max(vertex.share, least_share * spacing * spacing);
            double const scale = std::max(length, least);
            vertex.out = scale > 0 ? volume * vertex.area / (2 * share * scale * scale) : 0;
            corners_[v] += vertex.out * vertex.normal;
        });
    }

    std::vector<Vector3> const& positions() const { return corners_; }
    /// Of a triangle between them.
    Vector3 vector_area(std::size_t t) const { return vector_area(t, corners_); }

    /// What a triangle adds to the volume within: the flux through it of a field of divergence one that points along
    /// the axes without a period alone, so that it is the same in every period.
    double content(std::size_t t) const {
        auto const area = vector_area(t);
        double flux = 0, axes = 0;
        for (int k = 0; k < 3; ++k) {
            if (mesh_.box.periodic[k]) continue;
            ++axes;
            for (std::size_t place = 0; place < 3; ++place) flux += at(corners_, t, place)[k] * area[k] / 3;
        }
        return flux / axes;
    }

    /// From derivatives by the corners to those by the particles, in place.
    void to_particles(std::vector<Both<Vector3>>& slopes) const {
        std::vector<Slopes<Vector3>> of_vertex(vertex_.size());
        for_each(vertex_.size(), [&](std::size_t v) {
            of_vertex[v] = {back(v, slopes[v].size), back(v, slopes[v].content)};
        });
        std::vector<Both<double>> of_share(triangle_.size());  // by the mean share of a triangle's corners
        for_each(triangle_.size(), [&](std::size_t t) {
            for (Index const v : mesh_.triangles[t]) {
                auto const& slope = of_vertex[static_cast<std::size_t>(v)];
                of_share[t].size += slope.size.share / degree(v);
                of_share[t].content += slope.content.share / degree(v);
            }
        });
        for_each(vertex_.size(), [&](std::size_t v) {
            mesh_.for_corners(v, [&](std::size_t t, std::size_t) {
                of_vertex[v].size.area += of_share[t].size / 9;
                of_vertex[v].content.area += of_share[t].content / 9;
            });
        });
        std::vector<Both<Vector3>> of_triangle(triangle_.size());  // by its vector area
        for_each(triangle_.size(), [&](std::size_t t) {
            double const area = triangle_[t].area;
            auto const normal = area > 0 ? (1 / area) * triangle_[t].normal : Vector3{};
            for (Index const v : mesh_.triangles[t]) {
                auto const& slope = of_vertex[static_cast<std::size_t>(v)];
                of_triangle[t].size += slope.size.normal + slope.size.area * normal;
                of_triangle[t].content += slope.content.normal + slope.content.area * normal;
            }
        });
        for_each(vertex_.size(), [&](std::size_t v) {
            mesh_.for_corners(v, [&](std::size_t t, std::size_t place) {
                auto const half = 0.5 * opposite(t, place, x_);
                slopes[v].size += cross(of_triangle[t].size, half);
                slopes[v].content += cross(of_triangle[t].content, half);
            });
        });
    }

    /// The side of a triangle that a corner does not touch: the derivative of G . (vector area) by the corner is
    /// G x side/2.
    Vector3 opposite(std::size_t t, std::size_t place) const { return opposite(t, place, corners_); }

private:
    struct Triangle {
        Vector3 shift[3];  // of its corners, from their vertices, to be where the first one is [m]
        Vector3 normal{};  // the vector area [m^2]
        double area = 0, share = 0;
    };
    struct Vertex {
        Vector3 normal{};
        double area = 0, share = 0, out = 0;
        bool crowded = false, folded = false;
    };
    /// By the vector area, the area around a vertex and its share.
    struct ByVertex {
        Vector3 normal{};
        double area = 0, share = 0;
    };
    template <class>
    struct Slopes {
        ByVertex size, content;
    };

    ByVertex back(std::size_t v, Vector3 const& by_corner) const {
        auto const& vertex = vertex_[v];
        if (vertex.out == 0) return {};
        double const outwards = vertex.out * dot(by_corner, vertex.normal);  // what lengthening the way out does
        ByVertex slope{vertex.out * by_corner, outwards / vertex.area, 0};
        if (vertex.folded) slope.area = -outwards / vertex.area;
        else slope.normal += (-2 * outwards / norm2(vertex.normal)) * vertex.normal;
        if (!vertex.crowded) slope.share = -outwards / vertex.share;
        return slope;
    }

    Vertex const& of(Index v) const { return vertex_[static_cast<std::size_t>(v)]; }
    template <class Number>
    double degree(Number vertex) const {
        auto const v = static_cast<std::size_t>(vertex);
        return static_cast<double>(mesh_.first[v + 1] - mesh_.first[v]);
    }
    Vector3 at(std::vector<Vector3> const& x, std::size_t t, std::size_t place) const {
        return x[static_cast<std::size_t>(mesh_.triangles[t][place % 3])] + triangle_[t].shift[place % 3];
    }
    Vector3 vector_area(std::size_t t, std::vector<Vector3> const& x) const {
        return 0.5 * cross(at(x, t, 1) - at(x, t, 0), at(x, t, 2) - at(x, t, 0));
    }
    Vector3 opposite(std::size_t t, std::size_t place, std::vector<Vector3> const& x) const {
        return at(x, t, place + 2) - at(x, t, place + 1);
    }

    SurfaceMesh const& mesh_;
    std::vector<Vector3> x_, corners_;
    std::vector<Triangle> triangle_;
    std::vector<Vertex> vertex_;
};

std::vector<Vector3> vertices(SurfaceMesh const& mesh, Particles<3> const& particles, Vector3 const& origin) {
    std::vector<Vector3> x(mesh.vertices());
    for_each(x.size(), [&](std::size_t v) {
        x[v] = particles.view().get<Position>(static_cast<std::size_t>(mesh.particle[v])) - origin;
    });
    return x;
}

}  // namespace

std::vector<Vector<double, 3>> boundary_corners(SurfaceMesh const& mesh, Particles<3> const& particles, double spacing,
                                                double volume) {
    return Corners(mesh, vertices(mesh, particles, {}), spacing, volume).positions();
}

Boundary<3> boundary_of(SurfaceMesh const& mesh, Particles<3>& particles, Neighbours<3> const& neighbours,
                        double coverage_radius, double spacing, double volume) {
    std::size_t const n = particles.owned();
    particles.allocate(Fields<Surface>{});
    auto const view = particles.view();
    std::fill_n(view.at<Surface>(), n, 0.0);
    using Vectors = std::vector<Vector3>;
    Boundary<3> boundary{1, std::vector<Index>(n, 0), {0}, {0}, Vectors(n), Vectors(n)};
    if (mesh.triangles.empty()) return boundary;

    auto const particle = [&](std::size_t v) { return static_cast<std::size_t>(mesh.particle[v]); };
    Vector3 const origin = view.get<Position>(particle(0));
    Corners const corners(mesh, vertices(mesh, particles, origin), spacing, volume);

    std::vector<Both<double>> of_triangle(mesh.triangles.size());
    for_each(of_triangle.size(), [&](std::size_t t) {
        of_triangle[t] = {std::sqrt(norm2(corners.vector_area(t))), corners.content(t)};
    });
    auto const part = mesh.parts();
    std::vector<double> content_of_part(static_cast<std::size_t>(*std::ranges::max_element(part)) + 1, 0);
    for (std::size_t t = 0; t < part.size(); ++t)
        content_of_part[static_cast<std::size_t>(part[t])] += of_triangle[t].content;
    if (mesh.has_strays || std::ranges::count_if(content_of_part, [](double content) { return content > 0; }) > 1) {
        boundary.pieces = number_pieces(particles, neighbours, 2 * coverage_radius, boundary.piece);
        boundary.size.assign(boundary.pieces, 0);
        boundary.content.assign(boundary.pieces, 0);
    }
    for (std::size_t t = 0; t < of_triangle.size(); ++t) {
        auto const piece = boundary.piece_of(particle(static_cast<std::size_t>(mesh.triangles[t][0])));
        boundary.size[piece] += of_triangle[t].size;
        boundary.content[piece] += of_triangle[t].content;
    }

    std::vector<Both<Vector3>> slopes(mesh.vertices());
    for_each(slopes.size(), [&](std::size_t v) {
        mesh.for_corners(v, [&](std::size_t t, std::size_t place) {
            auto const area = corners.vector_area(t);
            double const length = std::sqrt(norm2(area));
            if (length > 0) slopes[v].size += cross((0.5 / length) * area, corners.opposite(t, place));
            slopes[v].content += 1.0 / 3 * area;  // of all triangles around it, so what the origin does cancels
        });
    });
    corners.to_particles(slopes);
    for (std::size_t v = 0; v < slopes.size(); ++v) {
        std::size_t const i = particle(v);
        view.at<Surface>()[i] = 1;
        boundary.of_size[i] += slopes[v].size;
        boundary.of_content[i] += slopes[v].content;
    }
    return boundary;
}

}  // namespace coronet
