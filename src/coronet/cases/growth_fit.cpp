// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/growth_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace coronet {

namespace {

struct Samples {
    Eigen::VectorXd t, y;

    Eigen::VectorXd best_for(double s) const {  // A, B
        auto const shapes = exponentials(s);
        return (shapes.transpose() * shapes).ldlt().solve(shapes.transpose() * y);
    }
    double misfit(double s) const { return (exponentials(s) * best_for(s) - y).squaredNorm(); }
    Eigen::MatrixXd exponentials(double s) const {
        Eigen::MatrixXd shapes(t.size(), 2);
        shapes << (s * t).array().exp(), (-s * t).array().exp();
        return shapes;
    }
    double variance_of(double s) const {
        auto const p = best_for(s);
        auto const shapes = exponentials(s);
        Eigen::MatrixXd slopes(t.size(), 3);
        slopes << shapes, t.cwiseProduct(shapes.col(0) * p[0] - shapes.col(1) * p[1]);
        Eigen::MatrixXd const inverse = (slopes.transpose() * slopes).ldlt().solve(Eigen::MatrixXd::Identity(3, 3));
        return std::max(inverse(2, 2), 0.0) * misfit(s) / static_cast<double>(t.size() - 3);
    }
};

}  // namespace

std::optional<Growth> fit_growth(std::vector<double> const& times, std::vector<double> const& values, double expected) {
    auto const finite = [](double value) { return std::isfinite(value); };
    if (times.size() < least_growth_samples || !std::ranges::all_of(values, finite)) return {};
    auto const n = static_cast<Eigen::Index>(times.size());
    Samples const samples{expected * (Eigen::Map<Eigen::VectorXd const>(times.data(), n).array() - times.front()),
                          Eigen::Map<Eigen::VectorXd const>(values.data(), n)};
    // The best of a grid, then between its neighbours by golden sections.
    constexpr double least = 1.0 / 3, most = 3, step = 0.05;
    double s = least;
    for (double other = least; other <= most; other += step)
        if (samples.misfit(other) < samples.misfit(s)) s = other;
    if (s < least + step / 2 || s > most - step) return {};
    double low = s - step, high = s + step;
    double const golden = (std::sqrt(5) - 1) / 2;
    while (high - low > 1e-9) {
        double const a = high - golden * (high - low), b = low + golden * (high - low);
        if (samples.misfit(a) < samples.misfit(b)) high = b;
        else low = a;
    }
    s = (low + high) / 2;
    return Growth{expected * s, expected * std::sqrt(samples.variance_of(s))};
}

}  // namespace coronet
