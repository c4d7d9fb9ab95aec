// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "coronet/core/error.hpp"

namespace coronet {

namespace {

using Point = ClosedSurface::Point;

constexpr int most_in_leaf = 4;
constexpr double on_surface = 1e-12;   // over the extent of the surface: nearer, the way there has no direction
constexpr double least_volume = 1e-9;  // of a surface, over that of the box around it
constexpr double least_height = 1e-9;  // of a triangle, over its longest edge: below, rounding gives it its normal

Point cross(Point const& a, Point const& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

double distance2_to_box(Point const& low, Point const& high, Point const& x) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        double const beyond = std::max({low[k] - x[k], x[k] - high[k], 0.0});
        sum += beyond * beyond;
    }
    return sum;
}

/// Where a triangle stands in its file.
std::string place_of(Triangles const& triangles, std::size_t k, std::string const& file) {
    return triangles.in_lines ? fmt::format("{}:{}", file, triangles.place[k])
                              : fmt::format("{}, triangle {}", file, triangles.place[k]);
}

}  // namespace

ClosedSurface::ClosedSurface(Triangles const& triangles, double unit, std::string const& file) : file_(file) {
    weld(triangles, unit, file);
    find_normals(triangles, file);
    order_.resize(triangles_.size());
    for (std::size_t k = 0; k < order_.size(); ++k) order_[k] = static_cast<int>(k);
    nodes_.push_back({low_, high_, 0, static_cast<int>(order_.size())});
    grow(0);
}

/// Equal corners get one number.
void ClosedSurface::weld(Triangles const& triangles, double unit, std::string const& file) {
    std::map<std::array<double, 3>, int> numbers;
    low_ = {{INFINITY, INFINITY, INFINITY}};
    high_ = -low_;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        std::array<int, 3> triangle;
        for (std::size_t c = 0; c < 3; ++c) {
            auto const& at = triangles.corners[t][c];
            auto const [known, is_new] =
                numbers.try_emplace({at[0] + 0.0, at[1] + 0.0, at[2] + 0.0}, static_cast<int>(corners_.size()));
            if (is_new) corners_.push_back(unit * at);
            triangle[c] = known->second;
            for (int k = 0; k < 3; ++k) {
                low_[k] = std::min(low_[k], unit * at[k]);
                high_[k] = std::max(high_[k], unit * at[k]);
            }
        }
        auto const a = corners_[static_cast<std::size_t>(triangle[0])],
                   b = corners_[static_cast<std::size_t>(triangle[1])],
                   c = corners_[static_cast<std::size_t>(triangle[2])];
        double const longest2 = std::max({norm2(b - a), norm2(c - b), norm2(a - c)});
        if (!(std::sqrt(norm2(cross(b - a, c - a))) > least_height * longest2))
            throw CaseError(
                fmt::format("{}: a triangle has no area: its corners are on a line; leave it away and join its "
                            "neighbours",
                            place_of(triangles, t, file)));
        triangles_.push_back(triangle);
    }
}

void ClosedSurface::find_normals(Triangles const& triangles, std::string const& file) {
    // Each edge belongs to one triangle in either sense.
    std::map<std::array<int, 2>, std::vector<std::size_t>> sides;
    auto const corner_of = [&](std::size_t t, std::size_t c) { return static_cast<std::size_t>(triangles_[t][c % 3]); };
    corner_normals_.resize(corners_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        auto const a = corners_[corner_of(t, 0)], b = corners_[corner_of(t, 1)], c = corners_[corner_of(t, 2)];
        auto const area = cross(b - a, c - a);
        triangle_normals_.push_back((1 / std::sqrt(norm2(area))) * area);
        volume_ += dot(a, cross(b, c)) / 6;
        for (std::size_t k = 0; k < 3; ++k) {
            sides[{triangles_[t][k], triangles_[t][(k + 1) % 3]}].push_back(t);
            auto const at = corners_[corner_of(t, k)];
            auto const one = corners_[corner_of(t, k + 1)] - at, other = corners_[corner_of(t, k + 2)] - at;
            double const angle = std::atan2(std::sqrt(norm2(cross(one, other))), dot(one, other));
            corner_normals_[corner_of(t, k)] += angle * triangle_normals_[t];
        }
    }
    edge_normals_.resize(triangles_.size());
    for (auto const& [ends, owners] : sides) {
        auto const describe = [&](std::size_t t) {
            auto const& from = corners_[static_cast<std::size_t>(ends[0])];
            auto const& to = corners_[static_cast<std::size_t>(ends[1])];
            return fmt::format("{}: the edge from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m",
                               place_of(triangles, t, file), from[0], from[1], from[2], to[0], to[1], to[2]);
        };
        if (owners.size() > 1)
            throw CaseError(
                fmt::format("{} is run through in the same sense by {} triangles, here and at {}: two neighbours must "
                            "have corners in "
                            "the same order, seen from outside, and no more than two may meet",
                            describe(owners[0]), owners.size(), place_of(triangles, owners[1], file)));
        auto const back = sides.find({ends[1], ends[0]});
        if (back == sides.end())
            throw CaseError(
                fmt::format("{} has a triangle on one side only: the surface must be closed, without a hole or "
                            "a seam between corners that are not quite the same",
                            describe(owners[0])));
        std::size_t const t = owners[0];
        for (std::size_t k = 0; k < 3; ++k)
            if (triangles_[t][k] == ends[0] && triangles_[t][(k + 1) % 3] == ends[1])
                edge_normals_[t][k] = triangle_normals_[t] + triangle_normals_[back->second[0]];
    }
    auto const size = high_ - low_;
    if (!(std::fabs(volume_) > least_volume * size[0] * size[1] * size[2]))
        throw CaseError(
            fmt::format("{}: the surface holds no volume: its sides lie on each other, or its pieces are seen from "
                        "outside and from inside by turns",
                        file));
    if (volume_ > 0) return;
    // Seen from inside: corners are in the other order all over.
    volume_ = -volume_;
    for (auto* normals : {&triangle_normals_, &corner_normals_})
        for (Point& n : *normals) n = -n;
    for (auto& normals : edge_normals_)
        for (Point& n : normals) n = -n;
}

/// Halves a node at the middle of its triangles along its longest edge.
void ClosedSurface::grow(int node) {
    auto [low, high, first, count] = nodes_[static_cast<std::size_t>(node)];
    if (count <= most_in_leaf) return;
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    auto const middle_of = [&](int t) {
        double sum = 0;
        for (int const c : triangles_[static_cast<std::size_t>(t)]) sum += corners_[static_cast<std::size_t>(c)][axis];
        return sum;
    };
    auto const begin = order_.begin() + first;
    int const half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](int a, int b) {
        double const at_a = middle_of(a), at_b = middle_of(b);
        return at_a < at_b || (at_a == at_b && a < b);
    });
    int const children = static_cast<int>(nodes_.size());
    for (auto const& [from, many] : {std::pair{first, half}, std::pair{first + half, count - half}}) {
        Node child{{{INFINITY, INFINITY, INFINITY}}, {{-INFINITY, -INFINITY, -INFINITY}}, from, many};
        for (int n = from; n < from + many; ++n)
            for (int const c : triangles_[static_cast<std::size_t>(order_[static_cast<std::size_t>(n)])])
                for (int k = 0; k < 3; ++k) {
                    child.low[k] = std::min(child.low[k], corners_[static_cast<std::size_t>(c)][k]);
                    child.high[k] = std::max(child.high[k], corners_[static_cast<std::size_t>(c)][k]);
                }
        nodes_.push_back(child);
    }
    nodes_[static_cast<std::size_t>(node)].first = children;
    nodes_[static_cast<std::size_t>(node)].count = 0;
    grow(children);
    grow(children + 1);
}

/// The nearest point of a triangle: its foot inside, else the nearest of the three edges.
auto ClosedSurface::foot_on(int triangle, Point const& x) const -> Foot {
    auto const t = static_cast<std::size_t>(triangle);
    std::array<Point, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = corners_[static_cast<std::size_t>(triangles_[t][k])];
    auto const n = cross(p[1] - p[0], p[2] - p[0]);
    Foot best;
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
        auto const edge = p[(k + 1) % 3] - p[k], from = x - p[k];
        if (dot(cross(edge, from), n) >= 0) continue;
        inside = false;
        double const along = std::clamp(dot(from, edge) / norm2(edge), 0.0, 1.0);
        auto const away = from - along * edge;
        if (norm2(away) >= best.distance2) continue;
        int const number = static_cast<int>(k);
        best = {norm2(away), away, triangle, along == 0 ? 4 + number : along == 1 ? 4 + (number + 1) % 3 : 1 + number};
    }
    if (!inside) return best;
    auto const away = (dot(x - p[0], n) / norm2(n)) * n;
    return {norm2(away), away, triangle, 0};
}

void ClosedSurface::descend(int node, Point const& x, Foot& best) const {
    Node const& here = nodes_[static_cast<std::size_t>(node)];
    for (int n = here.first; n < here.first + here.count; ++n) {
        Foot const foot = foot_on(order_[static_cast<std::size_t>(n)], x);
        if (foot.distance2 < best.distance2) best = foot;
    }
    if (here.count > 0) return;
    double to[2];
    for (int c = 0; c < 2; ++c) {
        Node const& child = nodes_[static_cast<std::size_t>(here.first + c)];
        to[c] = distance2_to_box(child.low, child.high, x);
    }
    int const nearer = to[1] < to[0];
    if (to[nearer] < best.distance2) descend(here.first + nearer, x, best);
    if (to[1 - nearer] < best.distance2) descend(here.first + 1 - nearer, x, best);
}

auto ClosedSurface::nearest(Point const& x) const -> Nearest {
    Foot foot;
    descend(0, x, foot);
    auto const t = static_cast<std::size_t>(foot.triangle);
    auto const n =
        foot.part == 0 ? triangle_normals_[t]
        : foot.part <= 3
            ? edge_normals_[t][static_cast<std::size_t>(foot.part - 1)]
            : corner_normals_[static_cast<std::size_t>(triangles_[t][static_cast<std::size_t>(foot.part - 4)])];
    double const distance = std::sqrt(foot.distance2), sign = dot(foot.from, n) < 0 ? -1 : 1;
    if (distance < on_surface * std::sqrt(norm2(high_ - low_))) return {sign * distance, (1 / std::sqrt(norm2(n))) * n};
    return {sign * distance, (sign / distance) * foot.from};
}

}  // namespace coronet
