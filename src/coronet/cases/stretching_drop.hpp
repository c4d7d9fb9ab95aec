// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The exact stretching drop: an incompressible ellipse (D = 2) or ellipsoid (D = 3) under zero surface pressure whose
// velocity is linear, v_k = (a_k'/a_k) x_k. Its semi-axes obey
//     a_k'' = 2 p_c/(rho a_k),   p_c = (rho/2) sum_k (a_k'/a_k)^2 / sum_k a_k^-2,
// since p = p_c (1 - sum_k (x_k/a_k)^2) then satisfies momentum, incompressibility and the surface condition at once;
// a linear velocity feels no viscosity. In 2D this is the solution of Fang et al. (2009), Eqs 94-96.

#include <algorithm>
#include <cmath>

#include "coronet/core/tensor.hpp"

namespace coronet {

template <int D>
class StretchingDrop {
public:
    /// Semi-axes [m], initial rates a_k'/a_k [1/s] (their sum must be zero), density [kg/m^3].
    StretchingDrop(Vector<double, D> const& semi_axes, Vector<double, D> const& rates, double density)
        : a_(semi_axes), rho_(density) {
        double fastest = 0;
        for (int k = 0; k < D; ++k) {
            v_[k] = rates[k] * semi_axes[k];
            fastest = std::max(fastest, std::fabs(rates[k]));
        }
        step_ = fastest > 0 ? 1e-4 / fastest : INFINITY;
    }

    /// Follows the drop to a later time [s]: classical Runge-Kutta, error below 1e-12 of the axes.
    void advance_to(double time) {
        while (time_ < time) {
            double const dt = std::min(step_, time - time_);
            auto const a1 = v_, v1 = force(a_, v_);
            auto const a2 = v_ + 0.5 * dt * v1, v2 = force(a_ + 0.5 * dt * a1, a2);
            auto const a3 = v_ + 0.5 * dt * v2, v3 = force(a_ + 0.5 * dt * a2, a3);
            auto const a4 = v_ + dt * v3, v4 = force(a_ + dt * a3, a4);
            a_ += (dt / 6) * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
            v_ += (dt / 6) * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
            time_ = dt < step_ ? time : time_ + dt;
        }
    }

    Vector<double, D> const& semi_axes() const { return a_; }
    double centre_pressure() const { return centre_pressure(a_, v_); }

private:
    double centre_pressure(Vector<double, D> const& a, Vector<double, D> const& v) const {
        double stretch = 0, inverse = 0;
        for (int k = 0; k < D; ++k) {
            stretch += v[k] * v[k] / (a[k] * a[k]);
            inverse += 1 / (a[k] * a[k]);
        }
        return 0.5 * rho_ * stretch / inverse;
    }
    Vector<double, D> force(Vector<double, D> const& a, Vector<double, D> const& v) const {
        double const p = centre_pressure(a, v);
        Vector<double, D> f;
        for (int k = 0; k < D; ++k) f[k] = 2 * p / (rho_ * a[k]);
        return f;
    }

    Vector<double, D> a_, v_;
    double rho_, time_ = 0, step_;
};

}  // namespace coronet
