// SPDX-License-Identifier: BSD-3-Clause

// What a pressure solve costs: for each operator and preconditioner, iterations from zero to a relative residual, the
// divergence left over that of before, seconds, and those in units of one evaluation of plain weakly compressible SPH,
// as `coronet bench --gradient sph` measures it, on as many particles in the same process; at last the exponents that
// iterations grow with. On a disc or ball with jitter. The right-hand side is the divergence of a smooth velocity and
// of one step of a force on the outermost particles, as surface tension has it.
//
// pressure_solve [--dimension D] [--threads T] [--tolerance X] [--operator thesis|sph|fpm]
//     [--preconditioner none|cholesky|jacobi|multigrid] [--kernel NAME] [--support SPACINGS] [--jitter SPACINGS]
//     [--budget SECONDS] N
//     ...
//
// `none` and `cholesky`, an incomplete factorisation with as many entries as the matrix, are Eigen's, and for the
// thesis's matrix alone: the consistent operator has none. What took long is not tried with more particles: what would
// exceed `budget` tenfold.

#include <Eigen/IterativeLinearSolvers>
#include <chrono>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include <fmt/format.h>

#include "coronet/core/parallel.hpp"
#include "coronet/run/benchmark.hpp"
#include "coronet/schemes/projection.hpp"
#include "coronet/schemes/thesis_pressure.hpp"

namespace {

using namespace coronet;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct Options {
    int dimension = 2, threads = 1;
    double tolerance = 1e-8, budget = 30, jitter = 0.1, support = 2.6;
    std::string operator_name, preconditioner, kernel = "wendland-c2";
    std::vector<double> particles;
};

template <int D>
Particles<D> body(double count, double jitter, double& dx) {
    dx = std::pow((D == 2 ? M_PI : 4 * M_PI / 3) / count, 1.0 / D);
    std::mt19937_64 engine(1);
    auto const random = [&] { return 2 * (static_cast<double>(engine() >> 11) * 0x1p-53) - 1; };
    std::vector<Vector<double, D>> x;
    int const m = static_cast<int>(1 / dx) + 1, depth = D == 3 ? m : 0;
    for (int c = -depth; c <= depth; ++c)
        for (int b = -m; b <= m; ++b)
            for (int a = -m; a <= m; ++a) {
                Vector<double, D> at;
                int const index[] = {a, b, c};
                for (int k = 0; k < D; ++k) at[k] = index[k] * dx;
                if (norm2(at) > 1) continue;
                for (int k = 0; k < D; ++k) at[k] += jitter * dx * random();
                x.push_back(at);
            }
    Particles<D> particles(x.size());
    particles.template allocate<Position, Velocity, Mass, Density, Volume, Pressure, Surface>();
    auto const view = particles.view();
    double const V = std::pow(dx, D), rho = 1000;
    for (std::size_t i = 0; i < x.size(); ++i) {
        view.template set<Position>(i, x[i]);
        view.template set<Volume>(i, V);
        view.template set<Density>(i, rho);
        view.template set<Mass>(i, rho * V);
        view.template set<Surface>(i, std::sqrt(norm2(x[i])) > 1 - dx ? 1 : 0);
    }
    return particles;
}

constexpr double dt = 1e-3;

/// Smooth, of the size of one, and a step of an inward force with a capillary pressure of one on the outermost spacing.
template <int D>
void set_velocity(Particles<D>& particles, double dx) {
    auto const view = particles.view();
    for_each(particles.size(), [&](std::size_t i) {
        auto const x = view.template get<Position>(i);
        Vector<double, D> v{{std::sin(2 * x[1]) + x[0], std::cos(3 * x[0]) + x[1] * x[0]}};
        if constexpr (D == 3) v[2] = x[0] * x[1] + x[2];
        if (view.template get<Surface>(i) > 0)
            v += (-dt * (1 + 0.5 * x[0]) / (view.template get<Density>(i) * dx) / std::sqrt(norm2(x))) * x;
        view.template set<Velocity>(i, v);
    });
}

template <int D>
std::unique_ptr<PressureOperator<D>> make_operator(std::string const& name, Options const& o, double dx,
                                                   Particles<D> const& particles) {
    Kernel const kernel = make_kernel(o.kernel, D, o.support * dx);
    if (name == "sph") return std::make_unique<ConsistentPressure<D>>(kernel, GradientKind::plain);
    if (name == "fpm") return std::make_unique<ConsistentPressure<D>>(kernel, GradientKind::corrected);
    if (name == "fpm+5%") return std::make_unique<ConsistentPressure<D>>(kernel, GradientKind::corrected, 0.05);
    auto made = std::make_unique<ThesisPressure<D>>(
        kernel, typename ThesisPressure<D>::Options{SurfacePressure::mirrored, dx, false});
    std::vector<Vector<double, D>> normals(particles.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        auto const x = particles.view().template get<Position>(i);
        normals[i] = (1 / std::sqrt(norm2(x))) * x;
    }
    made->set_normals(std::move(normals));
    return made;
}

struct Tried {
    long iterations;
    double set_up, solve;  // s
};

/// By Eigen, from zero, the matrix stored once more.
template <class Preconditioner, int D>
Tried by_eigen(ThesisPressure<D>& pressure, std::vector<double> const& b, double tolerance) {
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    auto const n = static_cast<Eigen::Index>(b.size());
    double const begin = seconds();
    auto const& rows = pressure.rows();
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < b.size(); ++i) {
        entries.emplace_back(static_cast<int>(i), static_cast<int>(i), pressure.diagonal()[i]);
        for (std::size_t k = rows.begin[i]; k < rows.begin[i + 1]; ++k)
            entries.emplace_back(static_cast<int>(i), rows.column[k], rows.value[k]);
    }
    Matrix A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Preconditioner> solver(A);
    solver.setTolerance(tolerance);
    double const built = seconds();
    Eigen::VectorXd const p = solver.solve(Eigen::Map<Eigen::VectorXd const>(b.data(), n));
    return {solver.iterations(), built - begin, seconds() - built};
}

template <int D>
void run(Options const& o) {
    struct Point {
        double n, iterations;
    };
    std::map<std::string, std::vector<Point>> growth;
    std::map<std::string, bool> too_slow;
    fmt::print("{:>9} {:8} {:9} {:>10} {:>9} {:>9} {:>9} {:>12}\n", "N", "operator", "precond.", "iterations",
               "residual", "set-up s", "solve s", "evaluations");
    for (double const count : o.particles) {
        double const evaluation = [&] {
            auto const result = run_benchmark({.dimension = D,
                                               .gradient = "sph",
                                               .precision = "double",
                                               .particles = count,
                                               .steps = 5,
                                               .repeat = 1});
            return static_cast<double>(result.particles) / result.rate;
        }();
        double dx = 0;
        auto particles = body<D>(count, o.jitter, dx);
        Neighbours<D> neighbours(o.support * dx, 0.03 * o.support * dx);
        neighbours.update(particles);
        for (std::string const name : {"thesis", "fpm+5%", "sph", "fpm"})
            for (std::string const precondition : {"none", "cholesky", "jacobi", "multigrid"}) {
                std::string const key = name + " " + precondition;
                if ((!o.operator_name.empty() && name != o.operator_name) || too_slow[key] ||
                    (!o.preconditioner.empty() && precondition != o.preconditioner))
                    continue;
                set_velocity(particles, dx);
                if (precondition == "none" || precondition == "cholesky") {
                    if (name != "thesis") continue;
                    auto const made = make_operator<D>(name, o, dx, particles);
                    auto& pressure = static_cast<ThesisPressure<D>&>(*made);
                    pressure.set_up(particles, neighbours);
                    std::vector<double> b(particles.size());
                    pressure.source(dt, b);
                    auto const tried = precondition == "none"
                                           ? by_eigen<Eigen::IdentityPreconditioner>(pressure, b, o.tolerance)
                                           : by_eigen<Eigen::IncompleteCholesky<double>>(pressure, b, o.tolerance);
                    double const all = tried.set_up + tried.solve;
                    fmt::print("{:9} {:8} {:9} {:10} {:>9} {:9.3f} {:9.3f} {:12.1f}\n", particles.size(), name,
                               precondition, tried.iterations, "", tried.set_up, tried.solve, all / evaluation);
                    std::fflush(stdout);
                    growth[key].push_back(
                        {static_cast<double>(particles.size()), static_cast<double>(tried.iterations)});
                    too_slow[key] = all * (D == 2 ? 30 : 10) > 10 * o.budget;
                    continue;
                }
                Projection<D> projection(
                    make_operator<D>(name, o, dx, particles),
                    precondition == "jacobi" ? Preconditioning::jacobi : Preconditioning::multigrid, dx,
                    {o.tolerance, 5000});
                // Twice: what a step of a run takes is the second, which finds its memory in place.
                Phases phases;
                Solved solved;
                for (int pass = 0; pass < 2; ++pass) {
                    set_velocity(particles, dx);
                    for (double& p : particles.template get<Pressure>()) p = 0;
                    phases = {};
                    solved = projection.project(particles, neighbours, dt, phases);
                }
                double const set_up = phases.seconds()[0].second, all = set_up + phases.seconds()[1].second;
                std::vector<double> left(particles.size()), before(particles.size());
                projection.pressure().source(dt, left);
                set_velocity(particles, dx);
                projection.pressure().source(dt, before);
                double const ratio = std::sqrt(inner_product(left, left) / inner_product(before, before));
                fmt::print("{:9} {:8} {:9} {:10} {:9.1e} {:9.3f} {:9.3f} {:12.1f}{}\n", particles.size(), name,
                           precondition, solved.iterations, ratio, set_up, all - set_up, all / evaluation,
                           solved.converged ? "" : "  not converged");
                std::fflush(stdout);
                growth[key].push_back({static_cast<double>(particles.size()), static_cast<double>(solved.iterations)});
                too_slow[key] = all * (D == 2 ? 30 : 10) > 10 * o.budget;
            }
    }
    for (auto const& [key, points] : growth) {
        if (points.size() < 2) continue;
        double sx = 0, sy = 0, sxx = 0, sxy = 0, n = static_cast<double>(points.size());
        for (Point const& p : points) {
            double const lx = std::log(p.n), ly = std::log(p.iterations);
            sx += lx, sy += ly, sxx += lx * lx, sxy += lx * ly;
        }
        fmt::print("{}: iterations grow as N^{:.3f}\n", key, (n * sxy - sx * sy) / (n * sxx - sx * sx));
    }
}

}  // namespace

int main(int argc, char** argv) {
    Options o;
    for (int k = 1; k < argc; ++k) {
        std::string const word = argv[k];
        auto const value = [&] { return std::string(k + 1 < argc ? argv[++k] : "0"); };
        if (word == "--dimension") o.dimension = std::stoi(value());
        else if (word == "--threads") o.threads = std::stoi(value());
        else if (word == "--tolerance") o.tolerance = std::stod(value());
        else if (word == "--budget") o.budget = std::stod(value());
        else if (word == "--operator") o.operator_name = value();
        else if (word == "--preconditioner") o.preconditioner = value();
        else if (word == "--jitter") o.jitter = std::stod(value());
        else if (word == "--kernel") o.kernel = value();
        else if (word == "--support") o.support = std::stod(value());
        else o.particles.push_back(std::stod(word));
    }
    set_threads(o.threads);
    if (o.dimension == 2) run<2>(o);
    else run<3>(o);
}
