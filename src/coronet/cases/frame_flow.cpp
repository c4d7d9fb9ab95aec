// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/frame_flow.hpp"

#include <cmath>

namespace coronet {

namespace {

template <int D>
Particles<D> particles_of(Frame const& frame) {
    Particles<D> particles(frame.ids.size());
    particles.allocate(Fields<Position, Velocity, Pressure, Volume>{});
    auto const view = particles.view();
    auto const *velocity = field_of(frame, "velocity"), *pressure = field_of(frame, "pressure"),
               *volume = field_of(frame, "volume");
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        for (int k = 0; k < D; ++k) {
            view.template at<Position>(k)[i] = frame.points[3 * i + k];
            view.template at<Velocity>(k)[i] = velocity->values[3 * i + k];
        }
        if (pressure) view.template at<Pressure>()[i] = pressure->values[i];
        view.template at<Volume>()[i] = volume->values[i];
    }
    return particles;
}

/// Moments of the weights V W of particles at y from the point.
template <int D>
struct Moments {
    double sum = 0;
    Vector<double, D> first;
    Matrix<double, D> second;

    void add(double weight, Vector<double, D> const& y) {
        sum += weight;
        first += weight * y;
        second += weight * outer(y, y);
    }
};

/// The weights w of the regression: a share p of V W and what it is tilted by.
template <int D>
struct Regression {
    double per_sum;
    Vector<double, D> centre, tilt;  // C^-1 (c - x); 0 where the value is the mean

    Regression(Moments<D> const& m, double most_amplified) : per_sum(1 / m.sum), centre(per_sum * m.first) {
        auto const C = per_sum * m.second - outer(centre, centre);
        auto const steep = adjugate(C) * centre;
        double const det = determinant(C);
        bool const spans = det > 1e-6 * std::pow(trace(C) / D, D);
        if (spans && dot(centre, steep) < (most_amplified - 1) * det) tilt = (1 / det) * steep;
    }

    double weight(double VW, Vector<double, D> const& y) const { return VW * per_sum * (1 - dot(y - centre, tilt)); }
};

}  // namespace

double spacing_of(Frame const& frame, int dimension) {
    auto const& volume = field_of(frame, "volume")->values;
    double const sum = sum_over(volume.size(), 0.0, [&](std::size_t i) { return volume[i]; });
    return std::pow(sum / static_cast<double>(volume.size()), 1.0 / dimension);
}

template <int D>
FrameFlow<D>::FrameFlow(Frame const& frame, PeriodicBox<D> const& box)
    : kernel_(make_kernel("wendland-c2", D, radius_in_spacings * spacing_of(frame, D))),
      particles_(particles_of<D>(frame)) {
    Images<D> images(box);
    images.remake(particles_, kernel_.support);
    images.follow(particles_, grid_.sort(particles_, kernel_.support));
    Fields<Velocity, Pressure, Volume> const fields;
    images.refresh(particles_, fields);

    auto const view = particles_.view();
    std::vector<Value> smooth(particles_.owned());
    for_each(smooth.size(), [&](std::size_t i) { smooth[i] = at(view.template get<Position>(i)); });
    for_each(smooth.size(), [&](std::size_t i) {
        view.template set<Velocity>(i, 2.0 * view.template get<Velocity>(i) - smooth[i].velocity);
        view.template set<Pressure>(i, 2 * view.template get<Pressure>(i) - smooth[i].pressure);
    });
    images.refresh(particles_, fields);
}

template <int D>
typename FrameFlow<D>::Value FrameFlow<D>::at(Vector<double, D> const& x) const {
    auto const view = particles_.view();
    auto const for_near = [&](auto const& act) {
        auto const all = [](Role) { return true; };
        grid_.for_rows_around(x, all, [&](Range range) {
            for (std::size_t j = range.first; j < static_cast<std::size_t>(range.last); ++j) {
                auto const y = view.template get<Position>(j) - x;
                double const VW = view.template get<Volume>(j) * kernel_(norm2(y)).W;
                if (VW > 0) act(j, VW, y);
            }
        });
    };
    Moments<D> moments;
    for_near([&](std::size_t, double VW, auto const& y) { moments.add(VW, y); });
    if (!(moments.sum > 0)) return nearest(x);
    Regression<D> const regression(moments, most_amplified);
    Value value;
    for_near([&](std::size_t j, double VW, auto const& y) {
        double const w = regression.weight(VW, y);
        value.velocity += w * view.template get<Velocity>(j);
        value.pressure += w * view.template get<Pressure>(j);
    });
    return value;
}

/// A loop over all particles: few points lie so far off.
template <int D>
typename FrameFlow<D>::Value FrameFlow<D>::nearest(Vector<double, D> const& x) const {
    auto const view = particles_.view();
    auto const distance2 = [&](std::size_t j) { return norm2(view.template get<Position>(j) - x); };
    std::size_t best = 0;
    for (std::size_t j = 1; j < particles_.size(); ++j)
        if (distance2(j) < distance2(best)) best = j;
    return {view.template get<Velocity>(best), view.template get<Pressure>(best), true};
}

template class FrameFlow<2>;
template class FrameFlow<3>;

}  // namespace coronet
