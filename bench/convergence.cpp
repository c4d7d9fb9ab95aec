// SPDX-License-Identifier: BSD-3-Clause

// The convergence study of Lobo (2011), section 4.2: f(x) = sin(exp(3 x)) on [0, 1], N particles, k of them within the
// radius of the kernel W6, with and without 1 % of random noise. Writes convergence.csv (the L2 errors of Eqs 4.6
// and 4.7) and scatter.csv (values at every particle for N = 500, k = 2 and 16, with noise) into the directory named on
// the command line. bench/convergence.py draws Figs 4.2 to 4.5 from them and prints the slopes.

#include <cmath>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "coronet/io/table.hpp"
#include "coronet/schemes/operators.hpp"

namespace {

using namespace coronet;

double f(double x) { return std::sin(std::exp(3 * x)); }
double slope(double x) { return 3 * std::exp(3 * x) * std::cos(std::exp(3 * x)); }

struct Study {
    Particles<1> particles;
    std::vector<Interpolated<1>> values;
};

/// N particles in the middle of N equal cells of [0, 1]; the support is k cells.
Study study(int N, int k, double noise) {
    Study s{Particles<1>(static_cast<std::size_t>(N)), {}};
    s.particles.allocate(Fields<Position, Volume, Sample>{});
    auto const view = s.particles.view();
    std::mt19937_64 engine(1);
    double const dx = 1.0 / N;
    for (std::size_t i = 0; i < s.particles.size(); ++i) {
        double const x = (static_cast<double>(i) + 0.5) * dx;
        double const random = 2 * (static_cast<double>(engine() >> 11) * 0x1p-53) - 1;
        view.set<Position>(i, {{x}});
        view.set<Volume>(i, dx);
        view.set<Sample>(i, f(x) * (1 + noise * random));
    }
    Neighbours<1> neighbours(k * dx, 0.1 * dx);
    neighbours.update(s.particles);
    s.values = interpolate(s.particles, neighbours, make_kernel("w6", 1, k * dx));
    return s;
}

}  // namespace

int main(int argc, char** argv) {
    std::filesystem::path const directory = argc > 1 ? argv[1] : "runs/convergence";
    std::filesystem::create_directories(directory);

    Table errors(directory / "convergence.csv",
                 {"N", "k", "noise", "shepard_error", "axis_gradient_error", "sph_error", "sph_gradient_error",
                  "fpm_error", "fpm_gradient_error", "shepard_error_inside"});
    for (double const noise : {0.0, 0.01})
        for (int const k : {2, 4, 8, 16, 32})
            for (int N = 125; N <= 64000; N *= 2) {
                Study const s = study(N, k, noise);
                double e[7] = {};
                for (std::size_t i = 0; i < s.particles.size(); ++i) {
                    double const x = s.particles.get<Position>()[i];
                    auto const& at = s.values[i];
                    double const inside = x > 0.1 && x < 0.9 ? at.shepard - f(x) : 0;
                    double const difference[] = {
                        at.shepard - f(x), at.axis_gradient[0] - slope(x), at.sph - f(x), at.sph_gradient[0] - slope(x),
                        at.fpm - f(x),     at.fpm_gradient[0] - slope(x),  inside};
                    for (int m = 0; m < 7; ++m) e[m] += difference[m] * difference[m] / N;
                }
                std::vector<double> row{static_cast<double>(N), static_cast<double>(k), noise};
                for (double const square : e) row.push_back(std::sqrt(square));
                errors.row(row);
            }

    Table scatter(directory / "scatter.csv", {"k", "x", "shepard", "axis_gradient", "exact", "exact_gradient"});
    for (int const k : {2, 16}) {
        Study const s = study(500, k, 0.01);
        for (std::size_t i = 0; i < s.particles.size(); ++i) {
            double const x = s.particles.get<Position>()[i];
            scatter.row(std::vector<double>{static_cast<double>(k), x, s.values[i].shepard,
                                            s.values[i].axis_gradient[0], f(x), slope(x)});
        }
    }
    fmt::print("{}\n", directory.string());
}
