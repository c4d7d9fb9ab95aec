// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/sensor_probe.hpp"

#include <cmath>

#include "coronet/cases/point_value.hpp"
#include "coronet/cases/wall_fill.hpp"

namespace coronet {

template <int D>
Sensor<D>::Sensor(Vector<double, D> const& at, double width, Case const& c) : kernel_(probe_kernel<D>(c)) {
    auto const normal = Solid<D>(c).deepest(at).normal;
    int across = 0;  // the axis that is least along the normal
    for (int k = 1; k < D; ++k)
        if (std::fabs(normal[k]) < std::fabs(normal[across])) across = k;
    Vector<double, D> one, other;
    one[across] = 1;
    one = one - dot(one, normal) * normal;
    one = (1 / std::sqrt(norm2(one))) * one;
    if constexpr (D == 3)
        other = {{normal[1] * one[2] - normal[2] * one[1], normal[2] * one[0] - normal[0] * one[2],
                  normal[0] * one[1] - normal[1] * one[0]}};
    int const count = 1 + static_cast<int>(width / c.particles.spacing);
    auto const place = [&](int k) { return width * ((k + 0.5) / count - 0.5); };
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < (D == 3 ? count : 1); ++b) face_.push_back(at + place(a) * one + place(b) * other);
}

template <int D>
double Sensor<D>::pressure(Particles<D> const& particles) const {
    auto const p = particles.template get<Pressure>();
    double sum = 0;
    for (auto const& x : face_) sum += value_at(particles, kernel_, x, [&](std::size_t i) { return p[i]; });
    return sum / static_cast<double>(face_.size());
}

template <int D>
SensorProbe<D>::SensorProbe(ProbeKeys const& keys, Case const& c)
    : name_(keys.name),
      sensor_(
          [&] {
              Vector<double, D> at;
              for (int k = 0; k < D; ++k) at[k] = keys.at[k];
              return at;
          }(),
          keys.sensor_width, c) {}

template class Sensor<2>;
template class Sensor<3>;
template class SensorProbe<2>;
template class SensorProbe<3>;

}  // namespace coronet
