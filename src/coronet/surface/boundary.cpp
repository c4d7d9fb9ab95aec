// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "coronet/surface/pieces.hpp"

namespace coronet {

namespace {

using Vector2 = Vector<double, 2>;

Vector2 right_of(Vector2 const& t) { return {{t[1], -t[0]}}; }
Vector2 left_of(Vector2 const& t) { return {{-t[1], t[0]}}; }

/// The corners of the boundary for one loop of the outline, and how they follow its particles.
class Corners {
public:
    Corners(std::vector<Vector2> points, double spacing, double volume)
        : x_(std::move(points)), n_(x_.size()), corners_(x_) {
        for (std::size_t k = 0; k < n_; ++k) {
            auto const side = x_[at(k, 1)] - x_[k];
            length_.push_back(std::sqrt(norm2(side)));
            along_.push_back(length_[k] > 0 ? (1 / length_[k]) * side : Vector2{});
        }
        for (std::size_t k = 0; k < n_; ++k) {
            auto const chord = x_[at(k, 1)] - x_[at(k, n_ - 1)];
            double const length = std::sqrt(norm2(chord)), least = least_chord * (length_[at(k, n_ - 1)] + length_[k]);
            folded_.push_back(length < least);
            chord_.push_back(std::max(length, least));
            double spread = 0;
            for_sides(k, [&](std::size_t side) { spread += length_[side] / sides; });
            bool const crowded = spread < 0.5 * spacing;
            spread_.push_back(crowded ? 0.5 * spacing : spread);
            crowded_.push_back(crowded);
            normal_.push_back(chord_[k] > 0 ? (1 / chord_[k]) * right_of(chord) : Vector2{});
            out_.push_back(chord_[k] > 0 ? volume / (2 * spread_[k]) : 0);
            corners_[k] += out_[k] * normal_[k];
        }
    }

    std::vector<Vector2> const& all() const { return corners_; }
    Vector2 const& operator[](std::size_t k) const { return corners_[k]; }
    std::size_t next(std::size_t k) const { return at(k, 1); }

    /// From derivatives by the corners to those by the particles.
    std::vector<Vector2> by_particles(std::vector<Vector2> const& by_corners) const {
        std::vector<Vector2> total = by_corners;
        for (std::size_t k = 0; k < n_; ++k) {
            if (out_[k] == 0) continue;
            auto const& F = by_corners[k];
            double const outwards = dot(F, normal_[k]);
            // A unit normal turns with the chord; of one that is shorter, the chord and the sides change the length.
            auto const turning = (out_[k] / chord_[k]) * left_of(folded_[k] ? F : F - outwards * normal_[k]);
            total[at(k, 1)] += turning;
            total[at(k, n_ - 1)] += -turning;
            if (folded_[k])
                for (std::size_t const side : {at(k, n_ - 1), k}) {
                    auto const shortening = (-outwards * out_[k] * least_chord / chord_[k]) * along_[side];
                    total[at(side, 1)] += shortening;
                    total[side] += -shortening;
                }
            if (crowded_[k]) continue;
            for_sides(k, [&](std::size_t side) {
                auto const thinning = (-outwards * out_[k] / (spread_[k] * sides)) * along_[side];
                total[at(side, 1)] += thinning;
                total[side] += -thinning;
            });
        }
        return total;
    }

private:
    static constexpr int sides = 4;
    static constexpr double least_chord = 0.5;  // over both sides

    std::size_t at(std::size_t k, std::size_t further) const { return (k + further) % n_; }
    /// The two sides before and the two after corner k, by where they begin.
    template <class Visit>
    void for_sides(std::size_t k, Visit const& visit) const {
        for (std::size_t s = 0; s < sides; ++s) visit((k + s + 2 * n_ - 2) % n_);
    }

    std::vector<Vector2> x_;
    std::size_t n_;
    std::vector<Vector2> corners_, along_, normal_;
    std::vector<double> length_, chord_, spread_, out_;
    std::vector<char> crowded_, folded_;
};

}  // namespace

Boundary<2> find_boundary(Particles<2>& particles, Neighbours<2> const& neighbours, double coverage_radius,
                          double spacing, double volume) {
    return boundary_along(find_outline(particles, neighbours, coverage_radius), particles, neighbours, coverage_radius,
                          spacing, volume);
}

Boundary<2> boundary_along(Outline const& outline, Particles<2>& particles, Neighbours<2> const& neighbours,
                           double coverage_radius, double spacing, double volume) {
    std::size_t const n = particles.owned();
    particles.allocate(Fields<Surface>{});
    auto const view = particles.view();
    std::fill_n(view.at<Surface>(), n, 0.0);

    using Vectors = std::vector<Vector<double, 2>>;
    Boundary<2> boundary{1, std::vector<Index>(n, 0), {}, {}, Vectors(n), Vectors(n)};
    auto const is_outer = [](Loop const& loop) { return loop.area > 0; };
    if (std::count_if(outline.loops.begin(), outline.loops.end(), is_outer) > 1)
        boundary.pieces = number_pieces(particles, neighbours, 2 * coverage_radius, boundary.piece);
    boundary.size.assign(boundary.pieces, 0);
    boundary.content.assign(boundary.pieces, 0);

    for (Loop const& loop : outline.loops) {
        Vectors points;
        for (Index const i : loop.particles) {
            points.push_back(view.get<Position>(static_cast<std::size_t>(i)));
            view.at<Surface>()[i] = 1;
        }
        Corners const corners(points, spacing, volume);
        auto const piece = boundary.piece_of(static_cast<std::size_t>(loop.particles[0]));
        Vectors of_size(points.size()), of_content(points.size());  // by the corners
        for (std::size_t k = 0; k < points.size(); ++k) {
            std::size_t const next = corners.next(k);
            auto const from = corners[k] - corners[0], side = corners[next] - corners[k];
            double const length = std::sqrt(norm2(side));
            if (length == 0) continue;
            auto const along = (1 / length) * side;
            boundary.size[piece] += length;
            of_size[k] += -along;
            of_size[next] += along;
            boundary.content[piece] += 0.5 * (from[0] * side[1] - from[1] * side[0]);
            // A side pushed outwards by a length sweeps an area of that times its own: half of it at either end.
            of_content[k] += 0.5 * right_of(side);
            of_content[next] += 0.5 * right_of(side);
        }
        of_size = corners.by_particles(of_size);
        of_content = corners.by_particles(of_content);
        for (std::size_t k = 0; k < points.size(); ++k) {
            auto const i = static_cast<std::size_t>(loop.particles[k]);
            boundary.of_size[i] += of_size[k];
            boundary.of_content[i] += of_content[k];
        }
    }
    return boundary;
}

std::vector<Vector2> boundary_corners(std::vector<Vector2> const& loop, double spacing, double volume) {
    return Corners(loop, spacing, volume).all();
}

}  // namespace coronet
