// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Particles own their fields, as a structure of arrays: every component of every field is one contiguous array, so that
// neighbouring loops read only what they use. Everyone else borrows a View for one call.
//
// Particles stand in the order of their roles. Loops that advance particles run over the `owned` ones, the liquid;
// loops that read neighbours over all `size` of them, which are more where there are walls or periodic boundaries. Each
// particle keeps a global identity through every re-ordering; an image has that of its original.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "coronet/core/parallel.hpp"
#include "coronet/fields/vocabulary.hpp"

namespace coronet {

/// Borrowed pointers to the fields of D-dimensional particles; component k of a field lies k * stride further on.
template <int D>
struct View {
    double* first[field_count] = {};
    std::size_t stride = 0;

    template <class F>
    CORONET_HD double* at(int component = 0) const {
        return first[F::number] + static_cast<std::size_t>(component) * stride;
    }
    template <class F>
    CORONET_HD ValueOf<F, double, D> get(std::size_t i) const {
        ValueOf<F, double, D> value{};
        unrolled<components<F::rank, D>()>([&](int k) { component(value, k) = at<F>(k)[i]; });
        return value;
    }
    template <class F>
    CORONET_HD void set(std::size_t i, ValueOf<F, double, D> const& value) const {
        unrolled<components<F::rank, D>()>([&](int k) { at<F>(k)[i] = component(value, k); });
    }
};

/// What a particle is there for, in the order in which they stand.
enum class Role {
    liquid,        ///< is advanced
    wall,          ///< fills the solid behind a wall as far as the liquid can see
    mirror,        ///< where a wall particle looks at the liquid: the neighbour of none
    liquid_image,  ///< a copy beyond a periodic boundary
    wall_image
};
inline constexpr int role_count = 5;

template <int D>
class Particles {
public:
    /// Liquid, and wall particles with a mirror each, which has the identity of its wall particle plus their number.
    explicit Particles(std::size_t liquid = 0, std::size_t walls = 0)
        : end_{liquid, liquid + walls, liquid + 2 * walls, liquid + 2 * walls, liquid + 2 * walls},
          stride_(rounded(size())),
          id(size()) {
        for (std::size_t i = 0; i < size(); ++i) id[i] = static_cast<std::int64_t>(i);
    }

    std::size_t size() const { return end_[role_count - 1]; }
    std::size_t owned() const { return end_[0]; }
    /// The particles of a role are begin(role) ... end(role) - 1.
    std::size_t begin(Role role) const { return role == Role::liquid ? 0 : end_[static_cast<int>(role) - 1]; }
    std::size_t end(Role role) const { return end_[static_cast<int>(role)]; }
    std::size_t count(Role role) const { return end(role) - begin(role); }
    Role role(std::size_t i) const {
        int role = 0;
        while (i >= end_[role]) ++role;
        return static_cast<Role>(role);
    }

    /// Makes room for so many images behind all others, which stay as they are. What images hold is undefined.
    void set_images(std::size_t of_liquid, std::size_t of_walls) {
        std::size_t const kept = end(Role::mirror);
        end_[3] = kept + of_liquid;
        end_[4] = end_[3] + of_walls;
        id.resize(size());
        if (size() <= stride_) return;
        std::size_t const stride = rounded(size() + size() / 8);
        for (std::size_t field = 0; field < field_count; ++field) {
            if (!array_[field]) continue;
            Array larger = make_array(stride * static_cast<std::size_t>(count_[field]));
            for (int k = 0; k < count_[field]; ++k)
                std::copy_n(array_[field].get() + static_cast<std::size_t>(k) * stride_, kept,
                            larger.get() + static_cast<std::size_t>(k) * stride);
            array_[field] = std::move(larger);
        }
        stride_ = stride;
    }

    /// Makes room for fields, set to zero; those that exist already are kept as they are.
    template <class... F>
    void allocate(Fields<F...> = {}) {
        ((array_[F::number] || (allocate_one(F::number, components<F::rank, D>()), true)), ...);
    }
    template <class F>
    bool has() const {
        return array_[F::number] != nullptr;
    }
    bool has(int field) const { return array_[static_cast<std::size_t>(field)] != nullptr; }

    View<D> view() const {
        View<D> view;
        for (std::size_t field = 0; field < field_count; ++field) view.first[field] = array_[field].get();
        view.stride = stride_;
        return view;
    }
    template <class F>
    std::span<double> get(int component = 0) {
        return {array_[F::number].get() + static_cast<std::size_t>(component) * stride_, size()};
    }
    template <class F>
    std::span<double const> get(int component = 0) const {
        return {array_[F::number].get() + static_cast<std::size_t>(component) * stride_, size()};
    }

    /// Room for `count` numbers of T, aligned to 64 bytes: for copies that a sweep makes. Kept from call to call, since
    /// fresh memory costs more than the copy.
    template <class T>
    T* scratch(std::size_t count) const {
        std::size_t const doubles = (count * sizeof(T) + sizeof(double) - 1) / sizeof(double);
        if (scratch_size_ < doubles) {
            scratch_ = make_array(doubles);
            scratch_size_ = doubles;
        }
        return reinterpret_cast<T*>(scratch_.get());
    }

    /// Puts the particle that stands at from[i] at place i, with all its fields and its identity.
    void reorder(std::span<Index const> from) {
        double* const spare = scratch<double>(stride_);
        for (std::size_t field = 0; field < field_count; ++field) {
            if (!array_[field]) continue;
            for (int k = 0; k < count_[field]; ++k) {
                double* const values = array_[field].get() + static_cast<std::size_t>(k) * stride_;
                for_each(size(), [&](std::size_t i) { spare[i] = values[from[i]]; });
                for_each(size(), [&](std::size_t i) { values[i] = spare[i]; });
            }
        }
        std::vector<std::int64_t> moved(size());
        for_each(size(), [&](std::size_t i) { moved[i] = id[static_cast<std::size_t>(from[i])]; });
        id = std::move(moved);
    }

private:
    static constexpr std::align_val_t alignment{64};
    struct Release {
        void operator()(double* p) const { ::operator delete[](p, alignment); }
    };
    using Array = std::unique_ptr<double[], Release>;

    /// A pack may be loaded at any particle: a few more numbers are readable behind the last.
    static Array make_array(std::size_t count) {
        Array array(static_cast<double*>(::operator new[]((count + 8) * sizeof(double), alignment)));
        std::fill_n(array.get(), count + 8, 0.0);
        return array;
    }
    void allocate_one(int field, int components) {
        array_[field] = make_array(stride_ * static_cast<std::size_t>(components));
        count_[field] = components;
    }

    static std::size_t rounded(std::size_t count) { return (count + 7) / 8 * 8; }

    std::size_t end_[role_count], stride_;
    Array array_[field_count];
    int count_[field_count] = {};
    mutable Array scratch_;
    mutable std::size_t scratch_size_ = 0;

public:
    std::vector<std::int64_t> id;
};

}  // namespace coronet
