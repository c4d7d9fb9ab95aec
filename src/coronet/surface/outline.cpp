// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "coronet/surface/arc_coverage.hpp"
#include "coronet/surface/cover.hpp"
#include "coronet/surface/detect.hpp"

namespace coronet {

namespace {

/// A gap and the particle whose circle it is on.
struct Arc {
    Index particle;
    Gap gap;
};

double cross(Vector<double, 2> const& a, Vector<double, 2> const& b) { return a[0] * b[1] - a[1] * b[0]; }

Vector<double, 2> direction(double angle) { return {{std::cos(angle), std::sin(angle)}}; }

/// Calls visit(coverage, i, block) for each of the targets whose circle discs of radius `others` leave uncovered.
template <class Visit>
void for_uncovered(Particles<2> const& particles, Neighbours<2> const& neighbours, Targets const& targets,
                   double radius, double others, Visit const& visit) {
    for_blocks(targets.blocks(), [&](std::size_t block) {
        static thread_local ArcCoverage coverage;
        for (std::size_t k = targets.begin[block]; k < targets.begin[block + 1]; ++k)
            if (!cover(coverage, particles, neighbours, targets[k], radius, others)) visit(coverage, targets[k], block);
    });
}

std::vector<Arc> arcs_of_the_boundary(Particles<2> const& particles, Neighbours<2> const& neighbours, double radius,
                                      Targets const& candidates) {
    std::vector<std::vector<Arc>> of_block(candidates.blocks());
    for_uncovered(particles, neighbours, candidates, radius, radius, [&](auto& coverage, auto i, auto block) {
        coverage.for_gaps([&](Gap const& gap) { of_block[block].push_back({static_cast<Index>(i), gap}); });
    });
    std::vector<Arc> arcs;
    for (auto const& some : of_block) arcs.insert(arcs.end(), some.begin(), some.end());
    return arcs;
}

/// Of each arc, the one that it goes over into: a permutation.
std::vector<std::size_t> successors(std::vector<Arc> const& arcs, View<2> const& view, double radius) {
    constexpr auto none = std::numeric_limits<std::size_t>::max();
    std::map<std::pair<Index, Index>, std::size_t> begins;  // of the arc on a particle that begins at another
    for (std::size_t k = 0; k < arcs.size(); ++k) begins[{arcs[k].particle, arcs[k].gap.from}] = k;

    std::vector<std::size_t> next(arcs.size(), none), open_ends;
    std::vector<char> reached(arcs.size(), false);
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        bool const alone = arcs[k].gap.to < 0;
        auto const found = alone ? begins.end() : begins.find({arcs[k].gap.to, arcs[k].particle});
        if (alone) next[k] = k;
        else if (found != begins.end()) next[k] = found->second;
        if (next[k] == none) open_ends.push_back(k);
        else reached[next[k]] = true;
    }
    auto const point = [&](Arc const& arc, double angle) {
        return view.get<Position>(static_cast<std::size_t>(arc.particle)) + radius * direction(angle);
    };
    for (std::size_t const end : open_ends) {
        auto const from = point(arcs[end], arcs[end].gap.end);
        double least = INFINITY;
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            if (reached[k]) continue;
            double const distance2 = norm2(point(arcs[k], arcs[k].gap.begin) - from);
            if (distance2 >= least) continue;
            least = distance2;
            next[end] = k;
        }
        reached[next[end]] = true;
    }
    return next;
}

}  // namespace

int Outline::largest() const {
    auto const by_area = [](Loop const& a, Loop const& b) { return a.area < b.area; };
    return loops.empty() ? -1 : static_cast<int>(std::max_element(loops.begin(), loops.end(), by_area) - loops.begin());
}

int Outline::voids() const {
    return static_cast<int>(std::count_if(loops.begin(), loops.end(), [](Loop const& loop) { return loop.area < 0; }));
}

Targets surface_candidates(Particles<2> const& particles, Neighbours<2> const& neighbours, double radius) {
    Targets const& all = neighbours.all();
    std::vector<char> candidate(all.begin.back(), false);
    for_uncovered(particles, neighbours, all, radius, std::max(radius - 2 * neighbours.skin(), 0.0),
                  [&](auto&, auto i, auto) { candidate[i] = true; });
    return neighbours.targets([&](std::size_t i) { return candidate[i]; });
}

Outline find_outline(Particles<2> const& particles, Neighbours<2> const& neighbours, double radius) {
    return find_outline(particles, neighbours, radius, neighbours.all());
}

Outline find_outline(Particles<2> const& particles, Neighbours<2> const& neighbours, double radius,
                     Targets const& candidates) {
    check_coverage_radius(radius, neighbours.support());
    auto const view = particles.view();
    auto const arcs = arcs_of_the_boundary(particles, neighbours, radius, candidates);
    auto const next = successors(arcs, view, radius);

    Outline outline;
    for (std::size_t k = 0; k < arcs.size(); ++k)  // those of one particle stand together
        outline.particles += k == 0 || arcs[k].particle != arcs[k - 1].particle;
    std::vector<char> seen(arcs.size(), false);
    for (std::size_t first = 0; first < arcs.size(); ++first) {
        if (seen[first]) continue;
        Loop loop{{}, 0};
        auto const origin = view.get<Position>(static_cast<std::size_t>(arcs[first].particle));
        for (std::size_t k = first; !seen[k]; k = next[k]) {
            seen[k] = true;
            auto const& [i, gap] = arcs[k];
            loop.particles.push_back(i);
            // Half the integral of x dy - y dx along the arc.
            auto const x = view.get<Position>(static_cast<std::size_t>(i)) - origin;
            loop.area +=
                0.5 * radius * (radius * (gap.end - gap.begin) + cross(x, direction(gap.end) - direction(gap.begin)));
        }
        outline.loops.push_back(std::move(loop));
    }
    return outline;
}

Polygon moved_out(Polygon line, double d) {
    auto const same = [](auto const& a, auto const& b) { return norm2(a - b) == 0; };  // such sides have no direction
    line.erase(std::unique(line.begin(), line.end(), same), line.end());
    while (line.size() > 1 && same(line.front(), line.back())) line.pop_back();
    std::size_t const n = line.size();
    if (n == 1) {
        auto const& x = line.front();
        return {x + d * Vector<double, 2>{{-1, -1}}, x + d * Vector<double, 2>{{1, -1}},
                x + d * Vector<double, 2>{{1, 1}}, x + d * Vector<double, 2>{{-1, 1}}};
    }
    auto const along = [&](std::size_t k) {  // the side from corner k to the next
        auto const side = line[(k + 1) % n] - line[k];
        return 1 / std::sqrt(norm2(side)) * side;
    };
    auto const right = [](Vector<double, 2> const& t) { return Vector<double, 2>{{t[1], -t[0]}}; };
    Polygon moved;
    auto before = along(n - 1);
    for (std::size_t k = 0; k < n; ++k) {
        auto const after = along(k), n1 = right(before), n2 = right(after);
        double const cosine = dot(before, after),
                     side = cross(before, after) < 0 ? -1 : 1;  // back the same way: outwards
        if (cosine >= 0) {
            moved.push_back(line[k] + d / (1 + cosine) * (n1 + n2));
        } else {
            moved.push_back(line[k] + d * (n1 + side * before));
            moved.push_back(line[k] + d * (n2 - side * after));
        }
        before = after;
    }
    return moved;
}

PolygonMeasures measure(Polygon const& line) {
    PolygonMeasures sums;
    for (std::size_t k = 0; k < line.size(); ++k) {
        auto const a = line[k] - line[0], b = line[(k + 1) % line.size()] - line[0];
        double const twice = cross(a, b);
        sums.area += twice / 2;
        sums.perimeter += std::sqrt(norm2(b - a));
        sums.centroid += twice / 6 * (a + b);
    }
    sums.centroid = line[0] + 1 / sums.area * sums.centroid;
    return sums;
}

}  // namespace coronet
