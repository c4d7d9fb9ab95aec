// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/wall_motion.hpp"

#include <algorithm>
#include <memory>
#include <numbers>

#include "coronet/cases/shapes.hpp"

namespace coronet {

namespace {

/// spin x r, about the axis across the x-y plane.
template <int D>
Vector<double, D> spun(double spin, Vector<double, D> const& r) {
    Vector<double, D> v;
    v[0] = -spin * r[1];
    v[1] = spin * r[0];
    return v;
}

/// A wall with what moves it and its surface.
template <int D>
struct Moving {
    Moving(Wall const& wall, Case const& c) : motion(wall, c), moves(coronet::moves(wall)) {
        for (std::string const& text : wall.surface_velocity) {
            slides = slides || text != "0";
            surface_velocity.emplace_back(text, c.parameters);
        }
        for (int k = 0; k < D; ++k) centre[k] = wall.centre[k];
    }
    WallMotion<D> motion;
    std::vector<Formula> surface_velocity;
    Vector<double, D> centre;
    bool moves, slides = false;
    WallPose<D> pose;  // of now
};

}  // namespace

template <int D>
WallMotion<D>::WallMotion(Wall const& wall, Case const& c)
    : turn_(wall.turn, c.parameters),
      interval_(0.25 * c.method.support / 3 * c.particles.spacing / c.fluid.sound_speed) {
    for (std::string const& text : wall.displacement) displacement_.emplace_back(text, c.parameters);
}

template <int D>
WallPose<D> WallMotion<D>::at(double time) {
    double const e = interval_, middle = std::max(time, e);  // nothing is asked of formulas before the start
    auto const place = [&](double t) {
        Vector<double, D> d;
        for (int k = 0; k < D; ++k) d[k] = displacement_[static_cast<std::size_t>(k)](Vector<double, D>{}, t);
        return d;
    };
    auto const angle = [&](double t) { return turn_(Vector<double, D>{}, t) * std::numbers::pi / 180; };
    auto const before = place(middle - e), now = place(middle), after = place(middle + e);
    double const turn_before = angle(middle - e), turn_now = angle(middle), turn_after = angle(middle + e);
    WallPose<D> pose;
    pose.displacement = place(time);
    pose.turn = angle(time);
    pose.acceleration = (1 / (e * e)) * (after - 2 * now + before);
    pose.spin_rate = (turn_after - 2 * turn_now + turn_before) / (e * e);
    pose.velocity = (0.5 / e) * (after - before) + (time - middle) * pose.acceleration;
    pose.spin = 0.5 / e * (turn_after - turn_before) + (time - middle) * pose.spin_rate;
    return pose;
}

template <int D>
std::function<void(double, Particles<D>&)> wall_motion(Case const& c, WallSeeds<D> const& seeds) {
    auto walls = std::make_shared<std::vector<Moving<D>>>();
    for (Wall const& wall : c.walls) walls->emplace_back(wall, c);
    if (std::none_of(walls->begin(), walls->end(), [](auto const& wall) { return wall.moves || wall.slides; }))
        return {};
    auto const home = std::make_shared<WallSeeds<D> const>(seeds);
    auto const box = periodic_box<D>(c);
    return [walls, home, box](double time, Particles<D>& particles) {
        for (auto& wall : *walls) wall.pose = wall.motion.at(time);
        auto const view = particles.view();
        std::size_t const first = particles.begin(Role::wall);
        auto const count = static_cast<std::int64_t>(particles.owned());  // identities of wall particles begin there
        for (std::size_t i = first; i < particles.end(Role::wall); ++i) {
            auto const k = static_cast<std::size_t>(particles.id[i] - count);
            auto& wall = (*walls)[home->wall[k]];
            Vector<double, D> velocity;
            auto to_mirror = home->to_mirror[k], x = view.template get<Position>(i);
            if (wall.moves) {
                auto const& pose = wall.pose;
                double const degrees = pose.turn * 180 / std::numbers::pi;
                auto const arm = turned(home->position[k] - wall.centre, degrees);
                to_mirror = turned(to_mirror, degrees);
                x = wall.centre + pose.displacement + arm;
                auto const r = arm + 0.5 * to_mirror;  // of the surface
                auto across = r;
                if constexpr (D == 3) across[2] = 0;
                velocity = pose.velocity + spun(pose.spin, r);
                auto const acceleration = pose.acceleration + spun(pose.spin_rate, r) - pose.spin * pose.spin * across;
                view.template set<Position>(i, x + box.shift_into(x));
                view.template set<ToMirror>(i, to_mirror);
                view.template set<Acceleration>(i, view.template get<Acceleration>(i) - acceleration);
            }
            if (wall.slides)
                for (int a = 0; a < D; ++a)
                    velocity[a] += wall.surface_velocity[static_cast<std::size_t>(a)](x + 0.5 * to_mirror, time);
            view.template set<WallVelocity>(i, velocity);
        }
    };
}

template class WallMotion<2>;
template class WallMotion<3>;
template std::function<void(double, Particles<2>&)> wall_motion(Case const&, WallSeeds<2> const&);
template std::function<void(double, Particles<3>&)> wall_motion(Case const&, WallSeeds<3> const&);

}  // namespace coronet
