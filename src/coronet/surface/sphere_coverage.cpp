// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/sphere_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coronet/surface/frame.hpp"

namespace coronet {

namespace {

/// Cells that tile the unit sphere: those of a grid on the faces of a cube, in equal angles, seen from the centre.
/// Their edges are great circles, so a cell lies within the cap around its middle that holds its corners. In float, for
/// many at a time; `rounding` is more than a dot product of theirs can be off by.
struct Cells {
    static constexpr int across = 6, count = 6 * across * across;
    static constexpr float rounding = 1e-6F;
    alignas(64) float x[count], y[count], z[count];
    double c, s;  ///< cosine and sine of the largest angular radius

    Cells() : c(1) {
        auto const point = [](int face, double a, double b) {
            auto const grid = [](double k) { return std::tan(std::numbers::pi / 4 * (2 * k / across - 1)); };
            Vector<double, 3> p;
            p[face % 3] = face < 3 ? 1 : -1;
            p[(face + 1) % 3] = grid(a);
            p[(face + 2) % 3] = grid(b);
            return 1 / std::sqrt(norm2(p)) * p;
        };
        for (int cell = 0; cell < count; ++cell) {
            int const face = cell / (across * across), a = cell / across % across, b = cell % across;
            auto const middle = point(face, a + 0.5, b + 0.5);
            x[cell] = static_cast<float>(middle[0]);
            y[cell] = static_cast<float>(middle[1]);
            z[cell] = static_cast<float>(middle[2]);
            for (int corner = 0; corner < 4; ++corner)
                c = std::min(c, dot(middle, point(face, a + corner / 2, b + corner % 2)));
        }
        s = std::sqrt(1 - c * c);
    }
};

Cells const cells;

}  // namespace

void SphereCoverage::add(Cap<3> const& cap, Index) {
    double const r2 = norm2(cap.x);
    if (cap.a * cap.a >= r2) {
        everything_ |= cap.everything();
        return;
    }
    double const inverse = 1 / std::sqrt(r2), c = cap.a * inverse;
    caps_.push_back({inverse * cap.x, c, std::sqrt((1 - c) * (1 + c))});
}

bool SphereCoverage::covered() {
    if (everything_) return true;
    if (caps_.empty()) return false;
    switch (ask_cells()) {
        case Answer::covered: return true;
        case Answer::open: return false;
        default: return std::ranges::all_of(caps_, [&](Disc const& cap) { return !in_doubt(cap) || is_covered(cap); });
    }
}

bool SphereCoverage::circles_are_covered() {
    return everything_ || (!caps_.empty() && std::ranges::all_of(caps_, [&](Disc const& c) { return is_covered(c); }));
}

/// How far each cell is inside a cap, with all caps of now.
float const* SphereCoverage::look_at_cells() {
    if (seen_ == 0) inside_.assign(Cells::count, -4.0F);
    float* const inside = inside_.data();
    for (; seen_ < caps_.size(); ++seen_) {
        Disc const& cap = caps_[seen_];
        auto const n0 = static_cast<float>(cap.n[0]), n1 = static_cast<float>(cap.n[1]),
                   n2 = static_cast<float>(cap.n[2]);
        // A cell is inside if its middle is nearer to the axis than the cap's angle less the cell's.
        float const inner = cap.c < cells.c ? static_cast<float>(cap.c * cells.c + cap.s * cells.s) : 4;
        for (int k = 0; k < Cells::count; ++k)
            inside[k] = std::max(inside[k], n0 * cells.x[k] + n1 * cells.y[k] + n2 * cells.z[k] - inner);
    }
    return inside;
}

bool SphereCoverage::seems_covered() {
    if (everything_) return true;
    float const* const inside = look_at_cells();
    return std::count_if(inside, inside + Cells::count, [](float depth) { return depth <= Cells::rounding; }) == 0;
}

auto SphereCoverage::ask_cells() -> Answer {
    float const* const inside = look_at_cells();
    doubtful_.clear();
    for (int k = 0; k < Cells::count; ++k) {
        if (inside[k] > Cells::rounding) continue;
        Vector<double, 3> const middle{{cells.x[k], cells.y[k], cells.z[k]}};
        auto const outside = [&](Disc const& cap) { return dot(cap.n, middle) < cap.c - Cells::rounding; };
        if (std::ranges::all_of(caps_, outside)) return Answer::open;
        doubtful_.push_back(middle);
    }
    return doubtful_.empty() ? Answer::covered : Answer::unknown;
}

bool SphereCoverage::in_doubt(Disc const& cap) const {
    // Cosines of the angles between which the middle of a cell is no farther from the circle than its corners.
    double const inner = cap.c < cells.c ? cap.c * cells.c + cap.s * cells.s + Cells::rounding : 2;
    double const outer = cap.c > -cells.c ? cap.c * cells.c - cap.s * cells.s - Cells::rounding : -2;
    return std::ranges::any_of(doubtful_, [&](Vector<double, 3> const& middle) {
        double const cosine = dot(cap.n, middle);
        return outer < cosine && cosine < inner;
    });
}

bool SphereCoverage::is_covered(Disc const& cap) {
    auto const [e1, e2] = tangents(cap.n);
    constexpr double apart = Cap<3>::apart;
    circle_.clear();
    for (Disc const& other : caps_) {
        bool const alike = norm2(other.n - cap.n) < apart * apart && std::fabs(other.c - cap.c) < apart;
        if (alike) continue;
        Vector<double, 2> const direction{{cap.s * dot(other.n, e1), cap.s * dot(other.n, e2)}};
        circle_.add(Cap<2>(direction, other.c - cap.c * dot(other.n, cap.n)));
    }
    return circle_.covered();
}

}  // namespace coronet
