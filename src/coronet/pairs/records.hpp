// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Records: what a sweep reads of a neighbour, packed together. A particle's position and the fields of the list are
// numbers of type T in groups of four, so that a neighbour is fetched by a few wide loads instead of one gather per
// number from as many arrays. The first groups of all particles stand one after another, then the second groups, and
// so on: a group is found by the particle's place in the lists alone (neighbours/neighbours.hpp).
//
// With T = float coordinates are fixed-point numbers in units of support/2^24 (core/coordinate.hpp), finer than the
// rounding of a distance in float, and velocities are relative to a frame, the mean of all: laws know differences of
// velocity alone, and a common motion would use up their digits.

#include <type_traits>
#include <utility>

#include "coronet/core/coordinate.hpp"
#include "coronet/core/simd.hpp"
#include "coronet/fields/particles.hpp"

namespace coronet {

template <int D, class T, class List>
struct Records;

template <int D, class T, class... F>
struct Records<D, T, Fields<F...>> {
    static constexpr int used = D + (0 + ... + components<F::rank, D>());
    /// Whether velocities are relative to the frame.
    static constexpr bool is_relative = sizeof(T) == 4 && (std::is_same_v<F, Velocity> || ...);
    static constexpr std::size_t width = static_cast<std::size_t>((used + 3) / 4 * 4);

    T* first = nullptr;      ///< the first group of particle 0, aligned to a group
    std::size_t stride = 0;  ///< numbers from one group to the next of the same particle
    Coordinate<T> coordinate{1};
    Vector<double, D> frame = {};  ///< velocity that velocities are relative to [m/s]

    /// Copies particles [begin, end) into their records.
    void fill(View<D> const& view, std::size_t begin, std::size_t end) const {
        double shift[width] = {};
        double const* from[width];  // for each number of a record, and something to read for those that are unused
        for (double const*& numbers : from) numbers = view.template at<Position>();
        for (int k = 0; k < D; ++k) from[k] = view.template at<Position>(k);
        auto const add = [&]<class G>(G) {
            for (int k = 0; k < components<G::rank, D>(); ++k) from[slot(offset<G>() + k)] = view.template at<G>(k);
        };
        (add(F{}), ...);
        if constexpr (is_relative)
            for (int k = 0; k < D; ++k) shift[slot(offset<Velocity>() + k)] = frame[k];
        auto const fill_group = [&]<std::size_t group>(std::integral_constant<std::size_t, group>) {
            T* const to = first + group * stride;
            double const* const* const numbers = from + 4 * group;
            for (std::size_t i = begin; i < end; ++i)
                for (std::size_t c = 0; c < 4; ++c) {
                    double const value = numbers[c][i];
                    if (4 * group + c < D) to[4 * i + c] = coordinate.stored(value);
                    else to[4 * i + c] = static_cast<T>(is_relative ? value - shift[4 * group + c] : value);
                }
        };
        [&]<std::size_t... group>(std::index_sequence<group...>) {
            (fill_group(std::integral_constant<std::size_t, group>{}), ...);
        }
        (std::make_index_sequence<width / 4>{});
    }

    /// Positions (as stored) and the fields G... of the particles at place[0], place[1], ..., a lane each. Only groups
    /// of four numbers that hold any of them are loaded.
    template <class... G>
    void fetch(Index const* place, Vector<Pack<T>, D>& x, Values<Pack<T>, D, Fields<G...>>& values) const {
        Pack<T> number[width];
        [&]<std::size_t... group>(std::index_sequence<group...>) { (fetch_group<group, G...>(place, number), ...); }
        (std::make_index_sequence<width / 4>{});
        unrolled<D>([&](int k) { x[k] = number[k]; });
        take_from([&](int k) { return number[k]; }, values, Fields<G...>{});
    }

    /// The same for particle i in every lane.
    template <class V, class... G>
    void spread(std::size_t i, Vector<Pack<T>, D>& x, V& values, Fields<G...> fields) const {
        auto const number = [&](int k) { return Pack<T>::copies(first[at(i, k)]); };
        unrolled<D>([&](int k) { x[k] = number(k); });
        take_from(number, values, fields);
    }

private:
    std::size_t at(std::size_t i, int k) const {
        return static_cast<std::size_t>(k / 4) * stride + 4 * i + static_cast<std::size_t>(k % 4);
    }

    /// Where number k of a record stands. If the last group holds two numbers, they stand first and third in it: that
    /// saves half of their transposition.
    static constexpr int slot(int k) { return used % 4 == 2 && k == used - 1 && k >= D ? used : k; }

    /// Which of a record's numbers is the first component of field G.
    template <class G>
    static constexpr int offset() {
        int at = D;
        bool found = false;
        ((found = found || std::is_same_v<F, G>, at += found ? 0 : components<F::rank, D>()), ...);
        return at;
    }

    template <class... G>
    static constexpr bool holds_any(std::size_t group) {
        auto const inside = [=](int begin, int count) {
            return begin < static_cast<int>(group) + 4 && begin + count > static_cast<int>(group);
        };
        return inside(0, D) || (inside(offset<G>(), components<G::rank, D>()) || ...);
    }

    template <std::size_t group, class... G>
    void fetch_group(Index const* place, Pack<T>* number) const {
        constexpr std::size_t at = 4 * group;
        // One number of a last group, or two floats, are gathered faster than the group is transposed.
        constexpr int left = used - static_cast<int>(at);
        if constexpr (left <= (sizeof(T) == 4 ? 2 : 1) && holds_any<G...>(at)) {
            for (int k = static_cast<int>(at); k < used; ++k)
                number[slot(k)] = fetch_one(&first[group * stride + slot(k) % 4], place);
        } else if constexpr (holds_any<G...>(at)) fetch_four(first + group * stride, place, number + at);
    }

    template <class Number, class V, class... G>
    static void take_from(Number const& number, V& values, Fields<G...>) {
        auto const take = [&]<class H>(H) {
            unrolled<components<H::rank, D>()>(
                [&](int k) { component(H::of(values), k) = number(slot(offset<H>() + k)); });
        };
        (take(G{}), ...);
    }
};

}  // namespace coronet
