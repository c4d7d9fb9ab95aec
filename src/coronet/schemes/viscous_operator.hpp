// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Viscous stress as a linear operator on velocities. With the corrected gradient and its transpose
// (schemes/kept_gradients.hpp) and d the traceless symmetric part of grad(v), the viscous force of Fang et al. (2009),
// Eqs 5, 6 and 61, is -K v,
//     K = grad^T (V 2 mu d) grad,   v . K v = sum V 2 mu d : d >= 0,
// the force that the scheme also sweeps for (terms/stress_divergence.hpp). K is symmetric and positive semi-definite on
// any arrangement of particles. K v keeps momentum to round-off, and angular momentum, too, where no gradient falls
// back: a rigid motion has no d. Units: K v is in N (per metre of depth in 2D).

#include "coronet/materials/generalised_newtonian.hpp"
#include "coronet/schemes/kept_gradients.hpp"

namespace coronet {

template <int D>
class ViscousOperator {
public:
    explicit ViscousOperator(Kernel const& kernel) : kernel_(kernel) {}

    /// Everything that depends on positions alone. The lists must be those of now, Position and Volume set.
    void set_up(Particles<D> const& particles, Neighbours<D> const& neighbours);
    /// The viscosity of every particle in the flow v [m/s]; D numbers a particle, as everywhere here.
    void set_viscosity(GeneralisedNewtonian const& liquid, std::span<double const> v);
    /// Kv = K v.
    void apply(std::span<double const> v, std::span<double> Kv);
    /// 2 mu d [Pa] at a particle in the flow v.
    Symmetric<double, D> stress(std::size_t i, std::span<double const> v) const {
        return Newtonian{viscosity_[i]}.stress(0.0, gradient(i, v));
    }
    /// The diagonal of K [kg/s].
    void diagonal(std::span<double> K) const;

    std::span<double const> viscosity() const { return viscosity_; }  ///< [Pa s]
    /// Particles whose gradient fell back to the plain one; they have no viscosity (schemes/stress_close.hpp).
    std::size_t singular_matrices() const { return gradients_.singular_matrices(); }

private:
    Matrix<double, D> gradient(std::size_t i, std::span<double const> v) const;

    Kernel kernel_;
    KeptGradients<D> gradients_;
    std::vector<double> volume_, viscosity_;
    std::vector<double> stress_;  ///< component by component [Pa]
};

}  // namespace coronet
