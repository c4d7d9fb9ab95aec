// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The vocabulary of particle fields: each is named once, here, with its symbol, rank, unit and meaning. Storage, views,
// what a law reads and gives, and the units in frames come from this one list.

#include <array>
#include <string_view>
#include <type_traits>

#include "coronet/core/tensor.hpp"

namespace coronet {

enum class Rank { scalar, vector, symmetric, matrix };

// X(name, symbol, rank, unit, meaning). V marks what is a sum over neighbours weighted with their volumes.
#define CORONET_FIELDS(X)                                                                                    \
    X(Position, x, vector, "m", "position")                                                                  \
    X(Velocity, v, vector, "m/s", "velocity")                                                                \
    X(Density, rho, scalar, "kg/m^3", "mass density")                                                        \
    X(Mass, m, scalar, "kg", "mass (per metre of depth in 2D)")                                              \
    X(Volume, V, scalar, "m^3", "volume m/rho (an area in 2D)")                                              \
    X(SoundSpeed, c, scalar, "m/s", "sound speed")                                                           \
    X(Pressure, p, scalar, "Pa", "pressure")                                                                 \
    X(Surface, surface, scalar, "-", "1 for a particle of the free surface, else 0")                         \
    X(SurfaceNormal, n, vector, "-", "outward unit normal of the free surface, 0 elsewhere")                 \
    X(Curvature, kappa, scalar, "1/m", "curvature of the surface, in 3D of both ways; > 0 on a drop")        \
    X(SurfaceArea, area, scalar, "m^2", "share of the surface that belongs to a particle (a length in 2D)")  \
    X(SurfaceFitted, fitted, scalar, "-", "1 where normal and curvature are fitted, else 0")                 \
    X(Exterior, exterior, scalar, "-", "1 for a particle that has one of the free surface in its support")   \
    X(Viscosity, mu, scalar, "Pa s", "dynamic viscosity")                                                    \
    X(Acceleration, dv, vector, "m/s^2", "rate of change of velocity")                                       \
    X(DensityRate, drho, scalar, "kg/m^3/s", "rate of change of density")                                    \
    X(Stress, sigma, symmetric, "Pa", "total stress -p I + tau")                                             \
    X(CorrectedStress, VT, matrix, "Pa m^3", "volume times stress times the gradient correction, V sigma L") \
    X(StressOffset, Vs, vector, "Pa m^2", "volume times stress times the value correction, V sigma q")       \
    X(OwnAcceleration, own_dv, vector, "m/s^2", "the part of a particle's own stress in its acceleration")   \
    X(SlopeCorrection, L, matrix, "-", "of the corrected gradient L grad W - q W")                           \
    X(ValueCorrection, q, vector, "1/m", "of the corrected gradient L grad W - q W")                         \
    X(FellBack, fell_back, scalar, "-", "1 where a singular matrix left the plain gradient, else 0")         \
    X(PositionBefore, x0, vector, "m", "position at the start of the step")                                  \
    X(VelocityBefore, v0, vector, "m/s", "velocity at the start of the step")                                \
    X(DensityBefore, rho0, scalar, "kg/m^3", "density at the start of the step")                             \
    X(KernelSum, W0, scalar, "-", "sum V W")                                                                 \
    X(KernelMoment, W1, vector, "m", "sum V (x_j - x_i) W")                                                  \
    X(SlopeSum, G0, vector, "1/m", "sum V grad W")                                                           \
    X(SlopeMoment, G1, symmetric, "-", "sum V grad W (x_j - x_i)")                                           \
    X(VelocityJump, v_jump, vector, "m/s", "sum V (v_j - v_i) W")                                            \
    X(VelocitySlope, v_slope, matrix, "1/s", "sum V (v_j - v_i) grad W: the plain SPH velocity gradient")    \
    X(PressureJump, p_jump, scalar, "Pa", "sum V (p_j - p_i) W")                                             \
    X(WallVelocity, v_wall, vector, "m/s", "of the wall's surface, at a wall particle")                      \
    X(ToMirror, to_mirror, vector, "m", "from a wall particle to its mirror image in the liquid")            \
    X(Slip, slip, scalar, "-", "1 at a wall particle behind a wall that liquid slips along, else 0")         \
    X(WallNumber, wall, scalar, "-", "which of the case's walls a wall particle fills, from 0")              \
    X(WallForce, f_wall, vector, "N", "of the liquid on a wall particle (per metre of depth in 2D)")         \
    X(Sample, f, scalar, "-", "a sampled function of position, of any unit")                                 \
    X(SampleSum, f0, scalar, "-", "sum V f_j W")                                                             \
    X(SampleJump, f_jump, scalar, "-", "sum V (f_j - f_i) W")                                                \
    X(SampleSlope, f_slope, vector, "1/m", "sum V (f_j - f_i) grad W: the plain SPH gradient")               \
    X(DensityJump, rho_jump, scalar, "kg/m^3", "sum V (rho_j - rho_i) W")                                    \
    X(DensitySlope, rho_slope, vector, "kg/m^4", "sum V (rho_j - rho_i) grad W: the plain SPH gradient")     \
    X(NearestNormal, n_near, vector, "-", "normal of the nearest surface particle in the support, else 0")   \
    X(Repulsion, repulsion, vector, "1/m^2", "sum n_ij/r^2 over neighbours that push a particle away")       \
    X(NeighbourCount, count, scalar, "-", "how many neighbours are in the support")                          \
    X(DistanceSum, distances, scalar, "m", "sum of their distances")                                         \
    X(Crowding, crowding, vector, "1/m", "weighted sum V grad W: up the slope of concentration")             \
    X(Shift, shift, vector, "m", "displacement that evens out the particles")                                \
    X(VelocityAlongShift, shift_dv, vector, "m/s", "by which velocity differs where the shift leads")        \
    X(DensityAlongShift, shift_drho, scalar, "kg/m^3", "by which density differs where the shift leads")

template <Rank rank, class R, int D>
struct RankType;
template <class R, int D>
struct RankType<Rank::scalar, R, D> {
    using Type = R;
};
template <class R, int D>
struct RankType<Rank::vector, R, D> {
    using Type = Vector<R, D>;
};
template <class R, int D>
struct RankType<Rank::symmetric, R, D> {
    using Type = Symmetric<R, D>;
};
template <class R, int D>
struct RankType<Rank::matrix, R, D> {
    using Type = Matrix<R, D>;
};

/// The value of field F at one particle, of number type R, in D dimensions.
template <class F, class R, int D>
using ValueOf = typename RankType<F::rank, R, D>::Type;

template <Rank rank, int D>
CORONET_HD constexpr int components() {
    return rank == Rank::scalar ? 1 : rank == Rank::vector ? D : rank == Rank::symmetric ? D * (D + 1) / 2 : D * D;
}

/// Component k of a value of any rank.
template <class R>
CORONET_HD constexpr R& component(R& scalar, int) {
    return scalar;
}
template <Tensor T>
CORONET_HD constexpr auto& component(T& value, int k) {
    return value.c[k];
}
template <Tensor T>
CORONET_HD constexpr auto const& component(T const& value, int k) {
    return value.c[k];
}

namespace detail {
enum FieldNumber {
#define CORONET_NUMBER(name, symbol, rank, unit, meaning) name##Number,
    CORONET_FIELDS(CORONET_NUMBER)
#undef CORONET_NUMBER
        field_count
};
}  // namespace detail

inline constexpr int field_count = detail::field_count;

// Each field is a tag type. Member<R, D> is what lets a law write ij.i.rho and ij.j.v: a set of values inherits it.
#define CORONET_TAG(name_, symbol_, rank_, unit_, meaning_)    \
    struct name_ {                                             \
        static constexpr int number = detail::name_##Number;   \
        static constexpr Rank rank = Rank::rank_;              \
        template <class R, int D>                              \
        struct Member {                                        \
            ValueOf<name_, R, D> symbol_ = {};                 \
        };                                                     \
        template <class Values>                                \
        CORONET_HD static constexpr auto& of(Values& values) { \
            return values.symbol_;                             \
        }                                                      \
    };
CORONET_FIELDS(CORONET_TAG)
#undef CORONET_TAG

/// What is known of a field at run time, for frames and documentation.
struct FieldInfo {
    std::string_view name, symbol, unit, meaning;
    Rank rank;
};

inline constexpr std::array<FieldInfo, field_count> field_info = {{
#define CORONET_INFO(name, symbol, rank, unit, meaning) {#name, #symbol, unit, meaning, Rank::rank},
    CORONET_FIELDS(CORONET_INFO)
#undef CORONET_INFO
}};

/// A list of fields, as a type.
template <class... F>
struct Fields {
    static constexpr int size = sizeof...(F);
};

/// Values of a list of fields at one particle (or at a pack of them): values.rho, values.v, ...
template <class R, int D, class List>
struct Values;
template <class R, int D, class... F>
struct Values<R, D, Fields<F...>> : F::template Member<R, D>... {};

template <class... F, class Visit>
CORONET_HD constexpr void for_fields(Fields<F...>, Visit const& visit) {
    (visit(F{}), ...);
}

namespace detail {
template <class F, class List>
inline constexpr bool has = false;
template <class F, class... L>
inline constexpr bool has<F, Fields<L...>> = (std::is_same_v<F, L> || ...);

template <class List, class... More>
struct UniteTwo {
    using Type = List;
};
template <class... L, class F, class... More>
struct UniteTwo<Fields<L...>, F, More...> {
    using Type =
        typename UniteTwo<std::conditional_t<has<F, Fields<L...>>, Fields<L...>, Fields<L..., F>>, More...>::Type;
};
template <class... Lists>
struct UniteAll {
    using Type = Fields<>;
};
template <class List>
struct UniteAll<List> {
    using Type = List;
};
template <class First, class... F, class... Rest>
struct UniteAll<First, Fields<F...>, Rest...> {
    using Type = typename UniteAll<typename UniteTwo<First, F...>::Type, Rest...>::Type;
};
}  // namespace detail

/// The fields of several lists, each once.
template <class... Lists>
using Unite = typename detail::UniteAll<Lists...>::Type;

}  // namespace coronet
