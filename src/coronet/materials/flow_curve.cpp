// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/materials/flow_curve.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "coronet/core/error.hpp"

namespace coronet {

namespace {

using Parameters = std::vector<RheologyParameter const*>;

/// The logarithms of the free parameters -> the differences of logarithms of stress: what Eigen asks of a function.
struct Deviations {
    using Scalar = double;
    using InputType = Eigen::VectorXd;
    using ValueType = Eigen::VectorXd;
    using JacobianType = Eigen::MatrixXd;
    enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

    FlowCurve const& curve;
    Rheology given;
    Parameters free;

    int inputs() const { return static_cast<int>(free.size()); }
    int values() const { return static_cast<int>(curve.stress.size()); }

    Rheology law(InputType const& logarithms) const {
        Rheology law = given;
        for (int k = 0; k < inputs(); ++k) law.*free[static_cast<std::size_t>(k)]->value = std::exp(logarithms[k]);
        return law;
    }
    int operator()(InputType const& logarithms, ValueType& deviations) const {
        Rheology const bare = without_bounds(law(logarithms));
        for (int k = 0; k < values(); ++k) {
            auto const at = static_cast<std::size_t>(k);
            deviations[k] = std::log(bare.stress_at(curve.shear_rate[at]) / curve.stress[at]);
        }
        return 0;
    }
    /// The sum of squares; infinite where the law cannot be evaluated.
    double misfit(InputType const& logarithms) const {
        ValueType deviations(values());
        (*this)(logarithms, deviations);
        double const sum = deviations.squaredNorm();
        return std::isfinite(sum) ? sum : INFINITY;
    }
};

std::vector<double> geometric(double from, double to, int count) {
    std::vector<double> values;
    for (int k = 0; k < count; ++k) values.push_back(from * std::pow(to / from, (k + 0.5) / count));
    return values;
}

/// Values worth trying for a parameter, from the extent of the data.
std::vector<double> guesses(RheologyParameter const& parameter, FlowCurve const& curve) {
    auto const [slow, fast] = std::minmax_element(curve.shear_rate.begin(), curve.shear_rate.end());
    auto const [weak, strong] = std::minmax_element(curve.stress.begin(), curve.stress.end());
    double thin = INFINITY, thick = 0;
    for (std::size_t k = 0; k < curve.stress.size(); ++k) {
        thin = std::min(thin, curve.stress[k] / curve.shear_rate[k]);
        thick = std::max(thick, curve.stress[k] / curve.shear_rate[k]);
    }
    if (parameter.unit == "s") return geometric(1 / *fast, 1 / *slow, 8);
    if (parameter.unit == "Pa") return {*weak, 0.3 * *weak, 0.03 * *weak};
    if (parameter.unit == "Pa s") return {thick, std::sqrt(thick * thin), thin, 0.2 * thin};
    if (parameter.unit == "Pa s^n") return geometric(std::min(thin, *weak), std::max(thick, *strong), 8);
    return {0.25, 0.5, 1, 2};
}

/// All combinations of guesses, the best of them first.
std::vector<Eigen::VectorXd> starts(Deviations const& deviations) {
    std::vector<Eigen::VectorXd> all{Eigen::VectorXd(deviations.inputs())};
    for (int k = 0; k < deviations.inputs(); ++k) {
        std::vector<Eigen::VectorXd> longer;
        for (double const guess : guesses(*deviations.free[static_cast<std::size_t>(k)], deviations.curve))
            for (Eigen::VectorXd start : all) {
                start[k] = std::log(guess);
                longer.push_back(start);
            }
        all = longer;
    }
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < all.size(); ++k) order.emplace_back(deviations.misfit(all[k]), k);
    std::sort(order.begin(), order.end());
    std::vector<Eigen::VectorXd> sorted;
    for (auto const& [misfit, k] : order) sorted.push_back(all[k]);
    return sorted;
}

/// Standard errors of the logarithms, from the curvature of the misfit where it is least.
Eigen::VectorXd standard_errors(Deviations const& deviations, Eigen::VectorXd const& best) {
    int const n = deviations.values(), p = deviations.inputs();
    Eigen::MatrixXd slopes(n, p);
    Eigen::NumericalDiff<Deviations, Eigen::Central>(deviations).df(best, slopes);
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> const modes(slopes.transpose() * slopes);
    double const variance = deviations.misfit(best) / (n - p);
    Eigen::VectorXd errors(p);
    for (int k = 0; k < p; ++k) {
        double sum = 0;  // a direction that changes nothing has an eigenvalue of 0 up to round-off, of either sign
        for (int mode = 0; mode < p; ++mode)
            sum += std::pow(modes.eigenvectors()(k, mode), 2) / std::max(modes.eigenvalues()[mode], 1e-300);
        errors[k] = std::sqrt(variance * sum);
    }
    return errors;
}

void measure_deviations(FlowCurveFit& fit) {
    Rheology const bare = without_bounds(fit.law);
    double sum = 0;
    for (std::size_t k = 0; k < fit.curve.stress.size(); ++k) {
        double const deviation = bare.stress_at(fit.curve.shear_rate[k]) / fit.curve.stress[k] - 1;
        sum += deviation * deviation;
        if (std::fabs(deviation) < std::fabs(fit.largest_deviation)) continue;
        fit.largest_deviation = deviation;
        fit.largest_at = fit.curve.shear_rate[k];
    }
    fit.rms_deviation = std::sqrt(sum / static_cast<double>(fit.curve.stress.size()));
}

constexpr std::size_t most_starts = 8;

}  // namespace

FlowCurveFit fit_flow_curve(FlowCurve const& curve, Rheology const& given) {
    FlowCurveFit fit;
    fit.curve = curve;
    fit.law = given;
    Deviations deviations{curve, given, {}};
    for (RheologyParameter const& parameter : rheology_parameters())
        if (parameter.physical && parameter.used_by(given.model) && std::isnan(given.*parameter.value))
            deviations.free.push_back(&parameter);

    std::set<double> const rates(curve.shear_rate.begin(), curve.shear_rate.end());
    if (rates.size() <= deviations.free.size())
        throw CaseError(
            fmt::format("there are {} different shear rates, but {} with {} parameters to find needs {} or more",
                        rates.size(), rheology_names()[static_cast<std::size_t>(given.model)], deviations.free.size(),
                        deviations.free.size() + 1));

    if (!deviations.free.empty()) {
        auto candidates = starts(deviations);
        candidates.resize(std::min(candidates.size(), most_starts));
        Eigen::VectorXd best = candidates.front();
        for (Eigen::VectorXd& candidate : candidates) {
            Eigen::NumericalDiff<Deviations, Eigen::Central> differentiable(deviations);
            Eigen::LevenbergMarquardt<decltype(differentiable)> search(differentiable);
            search.parameters.maxfev = 4000;
            search.minimize(candidate);
            if (deviations.misfit(candidate) < deviations.misfit(best)) best = candidate;
        }
        fit.law = deviations.law(best);
        auto const errors = standard_errors(deviations, best);
        for (std::size_t k = 0; k < deviations.free.size(); ++k)
            fit.fitted.push_back({deviations.free[k], errors[static_cast<int>(k)]});
    }
    measure_deviations(fit);
    return fit;
}

}  // namespace coronet
