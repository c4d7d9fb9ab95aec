// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Particles own their fields, as a structure of arrays: every component of every field is one contiguous array, so that
// neighbouring loops read only what they use. Everyone else borrows a View for one call.
//
// Loops that advance particles run over the `owned` ones, loops that read neighbours over all `size` of them: today
// they are the same. Each particle keeps a global identity through every re-ordering.

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

template <int D>
class Particles {
public:
    explicit Particles(std::size_t owned = 0) : size_(owned), stride_((owned + 7) / 8 * 8), id(owned) {
        for (std::size_t i = 0; i < owned; ++i) id[i] = static_cast<std::int64_t>(i);
    }

    std::size_t size() const { return size_; }
    std::size_t owned() const { return size_; }

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
        return {array_[F::number].get() + static_cast<std::size_t>(component) * stride_, size_};
    }
    template <class F>
    std::span<double const> get(int component = 0) const {
        return {array_[F::number].get() + static_cast<std::size_t>(component) * stride_, size_};
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
                for_each(size_, [&](std::size_t i) { spare[i] = values[from[i]]; });
                for_each(size_, [&](std::size_t i) { values[i] = spare[i]; });
            }
        }
        std::vector<std::int64_t> moved(size_);
        for_each(size_, [&](std::size_t i) { moved[i] = id[static_cast<std::size_t>(from[i])]; });
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

    std::size_t size_, stride_;
    Array array_[field_count];
    int count_[field_count] = {};
    mutable Array scratch_;
    mutable std::size_t scratch_size_ = 0;

public:
    std::vector<std::int64_t> id;
};

}  // namespace coronet
