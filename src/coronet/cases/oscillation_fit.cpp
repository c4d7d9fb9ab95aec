// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/oscillation_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>

namespace coronet {

namespace {

/// exp(-b t) (C cos w t + S sin w t) + c, with p = (C, S, c, b, w): deviations and their slopes.
struct Deviations {
    using Scalar = double;
    using InputType = Eigen::VectorXd;
    using ValueType = Eigen::VectorXd;
    using JacobianType = Eigen::MatrixXd;
    enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

    Eigen::VectorXd t, y;

    int inputs() const { return 5; }
    int values() const { return static_cast<int>(t.size()); }
    int operator()(InputType const& p, ValueType& deviation) const {
        for (int k = 0; k < values(); ++k)
            deviation[k] =
                std::exp(-p[3] * t[k]) * (p[0] * std::cos(p[4] * t[k]) + p[1] * std::sin(p[4] * t[k])) + p[2] - y[k];
        return 0;
    }
    int df(InputType const& p, JacobianType& slopes) const {
        for (int k = 0; k < values(); ++k) {
            double const fall = std::exp(-p[3] * t[k]), c = fall * std::cos(p[4] * t[k]),
                         s = fall * std::sin(p[4] * t[k]);
            slopes.row(k) << c, s, 1, -t[k] * (p[0] * c + p[1] * s), t[k] * (p[1] * c - p[0] * s);
        }
        return 0;
    }
    double misfit(InputType const& p) const {
        ValueType deviation(values());
        (*this)(p, deviation);
        return deviation.squaredNorm();
    }
};

/// The best C, S and c for b and w.
Eigen::VectorXd best_for(Deviations const& deviations, double b, double w) {
    Eigen::MatrixXd slopes(deviations.values(), 5);
    Eigen::VectorXd p(5);
    p << 1, 1, 0, b, w;
    deviations.df(p, slopes);
    Eigen::MatrixXd const linear = slopes.leftCols(3);
    p.head(3) = (linear.transpose() * linear).ldlt().solve(linear.transpose() * deviations.y);
    return p;
}

constexpr double grid_step = 0.7;  // of w times the length of the window [rad]: a fit finds its way over a radian

}  // namespace

std::optional<Oscillation> fit_oscillation(std::vector<double> const& times, std::vector<double> const& values,
                                           double expected) {
    if (times.size() < least_fit_samples) return {};
    if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) return {};
    auto const n = static_cast<Eigen::Index>(times.size());
    Deviations deviations{expected * (Eigen::Map<Eigen::VectorXd const>(times.data(), n).array() - times.front()),
                          Eigen::Map<Eigen::VectorXd const>(values.data(), n)};
    double const length = deviations.t[n - 1];

    Eigen::VectorXd best;
    double least = std::numeric_limits<double>::infinity();
    for (double w = 0.5; w <= 2; w += std::min(grid_step / length, 0.1))
        for (double const fall : {0.0, 1.0, 3.0, 9.0}) {  // over the window
            auto const p = best_for(deviations, fall / length, w);
            double const misfit = deviations.misfit(p);
            if (!(misfit < least)) continue;
            least = misfit;
            best = p;
        }
    if (!std::isfinite(least)) return {};
    Eigen::LevenbergMarquardt<Deviations> search(deviations);
    search.parameters.maxfev = 1000;
    search.minimize(best);
    if (!best.allFinite() || best[4] < 0.4 || best[4] > 2.5) return {};

    Eigen::MatrixXd slopes(n, 5);
    deviations.df(best, slopes);
    Eigen::MatrixXd const inverse = (slopes.transpose() * slopes).ldlt().solve(Eigen::MatrixXd::Identity(5, 5));
    double const variance = deviations.misfit(best) / static_cast<double>(n - 5);
    auto const error = [&](int k) { return expected * std::sqrt(variance * std::max(inverse(k, k), 0.0)); };
    return Oscillation{expected * best[4],
                       expected * best[3],
                       error(4),
                       error(3),
                       std::hypot(best[0], best[1]),
                       std::atan2(-best[1], best[0]),
                       best[2]};
}

}  // namespace coronet
