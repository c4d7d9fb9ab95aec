// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the time loop knows of a scheme. Virtual calls happen a few times a step, never per pair.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "coronet/core/phases.hpp"
#include "coronet/fields/particles.hpp"
#include "coronet/surface/boundary.hpp"

namespace coronet {

/// A vote on the step size: at most `step` [s], because of `reason`.
struct StepLimit {
    double step;
    std::string_view reason;
};

/// What a scheme counts over a run.
struct Counters {
    std::int64_t evaluations = 0;        ///< evaluations of the right-hand side
    std::int64_t listings = 0;           ///< times the neighbours were listed
    std::int64_t singular_matrices = 0;  ///< gradients that fell back to plain SPH, summed over evaluations
    std::int64_t singular_now = 0;       ///< the same in the last evaluation
};

/// How the particles stand to each other.
struct Arrangement {
    double neighbours_mean = 0;    ///< mean count inside the support, self excluded
    double smallest_distance = 0;  ///< between any two particles [m]
};

/// A number that a scheme shows beside the state, a column of the series.
struct Reading {
    std::string name;
    double value;
};

/// What forces have done so far [J].
struct Works {
    double tension = 0;     ///< on the boundary
    double dissipated = 0;  ///< taken by viscous and artificial forces

    friend Works operator+(Works const& a, Works const& b) {
        return {a.tension + b.tension, a.dissipated + b.dissipated};
    }
    friend Works operator*(double s, Works const& w) { return {s * w.tension, s * w.dissipated}; }
};

/// What a scheme with a tension sigma [N/m] on the boundary shows of it, `jumps` those of its size so far.
template <int D>
void add_readings(std::vector<Reading>& list, Boundary<D> const& boundary, double jumps, double sigma,
                  Works const& works) {
    list.push_back({"surface_energy", sigma * boundary.total_size()});
    list.push_back({"surface_content", boundary.total_content()});
    list.push_back({"surface_energy_jumps", sigma * jumps});
    list.push_back({"tension_work", works.tension});
    list.push_back({"dissipated_energy", works.dissipated});
}

template <int D>
class Scheme {
public:
    virtual ~Scheme() = default;

    /// Evaluates the rates at the time of the particles, so that time_limit() and advance() can use them.
    virtual void begin_step(double time) = 0;
    virtual StepLimit time_limit() const = 0;

    /// Goes from `time` to `time + step`. begin_step(time) must have been called.
    virtual void advance(double time, double step) = 0;

    /// Makes every quantity that follows from the state (pressure, volume) fit it: before anyone looks.
    virtual void refresh() = 0;

    /// Looks at every pair and, where tension acts on it, at the boundary as it is now: cheap enough for a sample, not
    /// for every step.
    virtual Arrangement arrangement() = 0;

    /// Of the last step; always the same names, in the same order.
    virtual std::vector<Reading> readings() const = 0;

    virtual Particles<D> const& particles() const = 0;
    virtual Counters const& counters() const = 0;
    virtual Phases& phases() = 0;
};

}  // namespace coronet
