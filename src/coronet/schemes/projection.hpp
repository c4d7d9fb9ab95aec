// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One projection: of all pressures, that whose force leaves the velocity without divergence, found by preconditioned
// conjugate gradients from the pressure of before, v <- v + dt dv(p), A p = -V div(v)/dt
// (schemes/pressure_operator.hpp).

#include <cmath>
#include <memory>
#include <utility>

#include "coronet/core/phases.hpp"
#include "coronet/schemes/pressure_operator.hpp"
#include "coronet/solvers/conjugate_gradients.hpp"
#include "coronet/solvers/jacobi.hpp"

namespace coronet {

enum class Preconditioning { jacobi, multigrid };

template <int D>
class Projection {
public:
    /// spacing of the particles in m, for the multigrid.
    Projection(std::unique_ptr<PressureOperator<D>> pressure, Preconditioning preconditioning, double spacing,
               SolveLimits const& limits)
        : pressure_(std::move(pressure)), preconditioning_(preconditioning), spacing_(spacing), limits_(limits) {}

    /// Sets Pressure [Pa], which is the first guess, Acceleration and Velocity; step in s. What
    /// PressureOperator::set_up asks for must hold. A solve that has not converged says so in what it returns; the
    /// velocity has then been corrected as far as it came.
    Solved project(Particles<D>& particles, Neighbours<D> const& neighbours, double step) {
        Phases untold;
        return project(particles, neighbours, step, untold);
    }
    /// The same, and how long it took: `pressure rows` is the operator's set-up, what is summed pair
    /// by pair, `pressure solve` the rest.
    Solved project(Particles<D>& particles, Neighbours<D> const& neighbours, double step, Phases& phases) {
        std::size_t const n = particles.size();
        particles.template allocate<Pressure, Acceleration>();
        phases.act("pressure rows", [&] { pressure_->set_up(particles, neighbours); });
        Solved solved;
        phases.act("pressure solve", [&] {
            b_.resize(n);
            pressure_->source(step, b_);
            auto const view = particles.view();
            std::span<double> const p = particles.template get<Pressure>();
            solved = solve(particles, p);
            pressure_->accelerate(p);
            for_each(n, [&](std::size_t i) {
                view.template set<Velocity>(
                    i, view.template get<Velocity>(i) + step * view.template get<Acceleration>(i));
            });
        });
        return solved;
    }

    /// Of the field Velocity [1/s], where project() was called last.
    double largest_divergence(Particles<D> const& particles) {
        pressure_->source(1, b_);
        auto const view = particles.view();
        return max_over(b_.size(), 0, [&](std::size_t i) { return std::fabs(b_[i]) / view.template at<Volume>()[i]; });
    }

    PressureOperator<D>& pressure() { return *pressure_; }

private:
    Solved solve(Particles<D> const& particles, std::span<double> p) {
        auto const A = [&](std::span<double const> in, std::span<double> out) { pressure_->apply(in, out); };
        if (preconditioning_ == Preconditioning::jacobi)
            return gradients_.solve(A, Jacobi{pressure_->diagonal()}, b_, p, limits_);
        multigrid_.set_up(particles, pressure_->smooth_energy(), pressure_->diagonal(), grid_spacing * spacing_);
        return gradients_.solve(A, multigrid_, b_, p, limits_);
    }

    /// Of the finest grid over that of the particles.
    static constexpr double grid_spacing = 2;

    std::unique_ptr<PressureOperator<D>> pressure_;
    Preconditioning preconditioning_;
    double spacing_;
    SolveLimits limits_;
    ConjugateGradients gradients_;
    GridMultigrid<D> multigrid_;
    std::vector<double> b_;
};

}  // namespace coronet
