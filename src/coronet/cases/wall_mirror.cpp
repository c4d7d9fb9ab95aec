// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/wall_mirror.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coronet {

namespace {

// A mirror stands at least so far from its wall particle, in spacings, that the way there has a direction.
constexpr double shortest_way = 0.1;

template <int D>
class Mirror {
public:
    Mirror(Solid<D> const& solid, PeriodicBox<D> const& box, Vector<double, D> const& x, double dx, double reach)
        : solid_(solid), box_(box), x_(x), dx_(dx), reach_(reach) {}

    std::optional<Vector<double, D>> find() const {
        if (auto const mirror = reflected(x_)) return mirror;
        auto const outside = nearest_outside();
        if (!outside) return std::nullopt;
        auto const s = surface_towards(*outside);
        auto const normal = depth_at(s).normal;
        double const depth = std::max(dot(normal, s - x_), shortest_way * dx_ / 2);
        if (auto const mirror = reflected(x_ + 2 * depth * normal)) return mirror;
        return outside;
    }

private:
    /// Also where x has left the box, if that is periodic.
    typename Solid<D>::Depth depth_at(Vector<double, D> const& x) const {
        auto const at = solid_.deepest(x);
        auto const shift = box_.shift_into(x);
        if (at.depth > -solid_.slack() || norm2(shift) == 0) return at;
        return solid_.deepest(x + shift);
    }
    bool is_solid(Vector<double, D> const& x) const { return depth_at(x).depth > -solid_.slack(); }

    std::optional<Vector<double, D>> reflected(Vector<double, D> mirror) const {
        auto at = depth_at(mirror);
        for (int k = 0; k < D && at.depth > -solid_.slack(); ++k, at = depth_at(mirror))
            mirror += 2 * std::max(at.depth, shortest_way * dx_ / 2) * at.normal;
        if (at.depth > -solid_.slack()) return std::nullopt;
        return mirror;
    }

    std::optional<Vector<double, D>> nearest_outside() const {
        int const steps = static_cast<int>(std::floor(2 * reach_ / dx_));
        double nearest2 = reach_ * reach_;
        std::optional<Vector<double, D>> found;
        std::array<int, D> n;
        n.fill(-steps);
        for (bool more = true; more;) {
            Vector<double, D> way;
            for (int k = 0; k < D; ++k) way[k] = 0.5 * dx_ * n[k];
            if (norm2(way) < nearest2 && !is_solid(x_ + way)) {
                nearest2 = norm2(way);
                found = x_ + way;
            }
            more = false;
            for (int k = 0; k < D && !more; ++k) {
                more = ++n[k] <= steps;
                if (!more) n[k] = -steps;
            }
        }
        return found;
    }

    /// Where the way there leaves the solid, by halving it.
    Vector<double, D> surface_towards(Vector<double, D> const& outside) const {
        double in = 0, out = 1;
        while (out - in > std::numeric_limits<double>::epsilon()) {
            double const middle = (in + out) / 2;
            (is_solid(x_ + middle * (outside - x_)) ? in : out) = middle;
        }
        return x_ + in * (outside - x_);
    }

    Solid<D> const& solid_;
    PeriodicBox<D> const& box_;
    Vector<double, D> x_;
    double dx_, reach_;
};

}  // namespace

template <int D>
std::optional<Vector<double, D>> mirror_of(Solid<D> const& solid, PeriodicBox<D> const& box, Vector<double, D> const& x,
                                           double dx, double reach) {
    return Mirror<D>(solid, box, x, dx, reach).find();
}

template std::optional<Vector<double, 2>> mirror_of(Solid<2> const&, PeriodicBox<2> const&, Vector<double, 2> const&,
                                                    double, double);
template std::optional<Vector<double, 3>> mirror_of(Solid<3> const&, PeriodicBox<3> const&, Vector<double, 3> const&,
                                                    double, double);

}  // namespace coronet
