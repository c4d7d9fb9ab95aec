// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pressure equation of Lobo (2011), Eqs 3.61 to 3.63: the Laplacian of Morris's kind, times V_i and with its sign
// turned, so that the matrix is symmetric and positive semi-definite,
//     (A p)_i = sum_j a_ij (p_i - p_j),   a_ij = -V_i V_j 4/(rho_i + rho_j) F(r_ij),   F = W'/r,
// with the plain divergence and pressure force. For the uniform density that the thesis has, these are its equations to
// the letter. A is not the divergence of that force: the projection is approximate. Its stencil is compact, so a
// checkerboard costs as much as it should. The matrix is stored by rows.
//
// At the free surface, with particles marked by Surface = 1 and their outward normals:
//   free      nothing special: p is determined up to a constant in each connected body, which exerts a force there;
//   zero      p = 0 at the surface particles, their rows and columns taken out;
//   mirrored  p = 0 on the plane half a spacing outside of each surface particle: with the images of its neighbours and
//   of
//             itself behind it (Eq 4.8), as the energy a(r) (p_i - p_j)^2 + a(r') (p_i + p_j)^2 in the rows of both,
//             where r'^2 = t^2 + (d_i + d_j)^2 for distances d from the plane and t along it. Images are external: the
//             force of the pressure stays the plain one, which conserves momentum.

#include <vector>

#include "coronet/schemes/consistent_pressure.hpp"

namespace coronet {

enum class SurfacePressure { free, zero, mirrored };

template <int D>
class ThesisPressure : public PressureOperator<D> {
public:
    struct Options {
        SurfacePressure surface = SurfacePressure::mirrored;
        double spacing = 0;  ///< of the particles [m]
        /// No diagonal less than that inside a lattice: holds the constant that rows of few neighbours hardly see.
        bool lattice_diagonal = false;
    };

    ThesisPressure(Kernel const& kernel, Options const& options);

    /// Outward unit normals of the particles marked in Surface, in their order at the next set_up; those of others are
    /// not read. Needed for `mirrored` alone.
    void set_normals(std::vector<Vector<double, D>> normals) { normals_ = std::move(normals); }

    void set_up(Particles<D>& particles, Neighbours<D> const& neighbours) override;
    void source(double step, std::span<double> b) override;
    void divergence(std::vector<Vector<double, D>> const& v, std::span<double> to) override;
    void apply(std::span<double const> p, std::span<double> Ap) override;
    std::span<double const> diagonal() override { return diagonal_; }
    SmoothEnergy smooth_energy() override;
    void accelerate(std::span<double const> p) override { plain_.accelerate(p); }

    /// The matrix off its diagonal: row i holds column[k], value[k] for k from begin[i] to begin[i + 1].
    struct Rows {
        std::vector<std::size_t> begin;
        std::vector<Index> column;
        std::vector<double> value;
    };
    Rows const& rows() const { return rows_; }

private:
    bool taken_out(std::size_t i) const { return options_.surface == SurfacePressure::zero && is_surface_[i]; }
    double image(std::size_t i, std::size_t j, Vector<double, D> const& x_ij) const;

    Kernel kernel_;
    Options options_;
    ConsistentPressure<D> plain_;  ///< its divergence (3.62) and force (3.63)
    double lattice_sum_ = 0;       ///< of -V F over the neighbours in a lattice [1/m^2]
    std::vector<Vector<double, D>> normals_;
    std::vector<char> is_surface_;
    Particles<D>* particles_ = nullptr;
    Rows rows_;
    std::vector<double> diagonal_;
};

}  // namespace coronet
