// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Is a circle covered by the discs of its neighbours? Dilts, Int. J. Numer. Meth. Eng. 48 (2000) 1503; Lobo (2011),
// 3.2.1 and 4.1.2: each neighbour covers an arc, and particle i is one of the surface if their union (3.35, 4.4) is not
// the whole circle. The linked list there, from which arcs are cut one by one (Table 4.1), allocates and is walked for
// every arc. Here the arcs are sorted by where they begin, once, and one pass keeps how far the union reaches: what
// begins beyond the reach leaves a gap. Arcs are closed (cap.hpp has the tolerance).
//
// Angles are measured in `quarters`, a function of the direction that grows with the polar angle, by 1 from axis to
// axis: one division instead of an arc tangent. It is exact on the axes.
//
// An uncovered gap of i is a piece of the boundary of the union of all discs. Counter-clockwise, it begins where the
// arc of one neighbour ends and ends where the arc of another begins: there the boundary goes over from i to that
// neighbour.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "coronet/core/real.hpp"
#include "coronet/surface/cap.hpp"

namespace coronet {

/// The polar angle of (x, y) != 0, in [-2, 2].
inline double quarters(double x, double y) { return std::copysign(1 - x / (std::fabs(x) + std::fabs(y)), y); }

/// The same angle in radians.
inline double radians(double quarters) {
    double const axis = std::floor(quarters), part = quarters - axis;
    return axis * (std::numbers::pi / 2) + std::atan2(part, 1 - part);
}

/// A part of the circle that no neighbour covers, counter-clockwise from `begin` to `end` [rad]: no more than a turn,
/// -3 pi <= begin < end <= pi.
struct Gap {
    double begin, end;
    Index from, to;  ///< the neighbours whose arc ends at `begin`, and begins at `end`; -1 if there is none at all
};

/// The caps of one circle. Meant to be used for one circle after the other: it keeps its memory.
class ArcCoverage {
public:
    void clear() { count_ = measured_ = 0; }

    /// The circle's part within `cap` is covered by `neighbour`.
    void add(Cap<2> const& cap, Index neighbour = 0) {
        if (count_ == neighbour_.size()) grow();
        x_[count_] = cap.x[0];
        y_[count_] = cap.x[1];
        a_[count_] = cap.a;
        neighbour_[count_++] = neighbour;
    }

    /// Enough to know that the circle is covered, if it is with some overlap: each of 64 sectors lies in one arc.
    bool seems_covered() {
        measure();
        std::uint64_t covered = 0;
        for (std::size_t k = 0; k < count_; ++k) {
            int const first = static_cast<int>(std::ceil(16 * begin_[k]));
            int const sectors = std::clamp(static_cast<int>(std::floor(16 * end_[k])) - first, 0, 63);
            covered |= std::rotl((std::uint64_t{1} << sectors) - 1, first & 63);
        }
        return ~covered == 0;
    }

    bool covered() {
        if (count_ == 0) return false;
        if (seems_covered()) return true;
        list_arcs();
        bool gap = arcs_.empty();
        pass([&](double, double, Index, Index) { gap = true; });
        return everything_ || !gap;
    }

    /// Calls visit(Gap) counter-clockwise for every gap. A circle that meets no neighbour is one gap, from -pi to pi.
    template <class Visit>
    void for_gaps(Visit const& visit) {
        measure();
        list_arcs();
        if (everything_) return;
        if (arcs_.empty()) visit(Gap{-std::numbers::pi, std::numbers::pi, -1, -1});
        pass([&](double begin, double end, Index from, Index to) {
            visit(Gap{radians(begin), radians(end), from, to});
        });
    }

private:
    struct Arc {
        double begin, end;  ///< in quarters: -2 <= begin <= 2, begin <= end <= begin + 4
        Index neighbour;
    };

    void grow() {
        std::size_t const room = 2 * count_ + 64;
        for (auto* numbers : {&x_, &y_, &a_, &begin_, &end_}) numbers->resize(room);
        neighbour_.resize(room);
    }

    /// Ends of all arcs, without a branch, for several at a time. An arc that is nothing ends where it begins, and so,
    /// for now, does one that is everything.
    void measure() {
        double const *const x = x_.data(), *const y = y_.data(), *const a = a_.data();
        double *const begin = begin_.data(), *const end = end_.data();
        for (std::size_t k = measured_; k < count_; ++k) {
            double const h2 = x[k] * x[k] + y[k] * y[k] - a[k] * a[k];
            double const h = std::sqrt(h2 > 0 ? h2 : 0);
            begin[k] = quarters(a[k] * x[k] + h * y[k], a[k] * y[k] - h * x[k]);
            double const last = quarters(a[k] * x[k] - h * y[k], a[k] * y[k] + h * x[k]);
            end[k] = last < begin[k] ? last + 4 : last;
        }
        measured_ = count_;
    }

    void list_arcs() {
        arcs_.clear();
        everything_ = false;
        for (std::size_t k = 0; k < count_; ++k) {
            Cap<2> const cap({{x_[k], y_[k]}}, a_[k]);
            if (cap.everything()) everything_ = true;
            else if (!cap.nothing()) arcs_.push_back({begin_[k], end_[k], neighbour_[k]});
        }
    }

    template <class Visit>
    void pass(Visit const& visit) {
        auto const by = [](auto of) { return [of](Arc const& a, Arc const& b) { return a.*of < b.*of; }; };
        std::sort(arcs_.begin(), arcs_.end(), by(&Arc::begin));
        // The arc that ends last is the one that reaches farthest into the next turn, that is, from below into this.
        auto const last = std::max_element(arcs_.begin(), arcs_.end(), by(&Arc::end));
        double reach = last == arcs_.end() ? 0 : last->end - 4;
        Index owner = last == arcs_.end() ? -1 : last->neighbour;
        for (Arc const& arc : arcs_) {
            if (arc.begin > reach) visit(reach, arc.begin, owner, arc.neighbour);
            if (arc.end > reach) {
                reach = arc.end;
                owner = arc.neighbour;
            }
        }
    }

    std::vector<double> x_, y_, a_, begin_, end_;  // the caps and their arcs, of which count_ are in use
    std::vector<Index> neighbour_;
    std::size_t count_ = 0, measured_ = 0;
    std::vector<Arc> arcs_;
    bool everything_ = false;
};

}  // namespace coronet
