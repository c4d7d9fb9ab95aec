// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sweep on the host: for every target particle i, the sum of a law over its neighbours, a pack of neighbours at a
// time, on all cores. What the laws read of j is first copied into records, one per particle, so that a neighbour costs
// one or two cache lines (pairs/records.hpp). Rows are taken as they are listed: those beyond the support are few, and
// the kernel makes them nothing, as it does the unused lanes of a row's last pack, which are moved far away.
//
// Each particle gathers its own sums, and a close ends a pack of particles (pairs/close.hpp). It may write any field of
// theirs: the law reads of j what was copied before.

#include <algorithm>
#include <tuple>
#include <type_traits>
#include <utility>

#include "coronet/core/parallel.hpp"
#include "coronet/core/simd.hpp"
#include "coronet/fields/particles.hpp"
#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/neighbours.hpp"
#include "coronet/pairs/close.hpp"
#include "coronet/pairs/law.hpp"
#include "coronet/pairs/records.hpp"

namespace coronet {

/// What one sweep does to some of the particles.
template <class Law, class Close>
struct Part {
    Targets const& targets;
    Law law;
    Close close;
};
template <class Law, class Close>
Part(Targets const&, Law, Close) -> Part<Law, Close>;

namespace detail {

template <class... F, int D, class V>
void spread_own(View<D> const& view, std::size_t i, V& values, Fields<F...>) {
    [[maybe_unused]] auto const fill = [&]<class G>(G) {
        unrolled<components<G::rank, D>()>([&](int k) { component(G::of(values), k) = view.template at<G>(k)[i]; });
    };
    (fill(F{}), ...);
}

template <int D, class List>
struct RowSums;

/// The sums of a row, component after component, as they come from the lanes.
template <int D, class... F>
struct RowSums<D, Fields<F...>> {
    static constexpr int count = (0 + ... + components<F::rank, D>()), room = (count + 7) / 8 * 8;
    double sum[room];

    RowSums() = default;
    template <class R>
    explicit RowSums(Values<R, D, Fields<F...>> const& packs) {
        R all[room] = {};
        int next = 0;
        auto const take = [&]<class G>(G) {
            unrolled<components<G::rank, D>()>([&](int k) { all[next++] = component(G::of(packs), k); });
        };
        (take(F{}), ...);
        for (int k = 0; k < room; k += 8) sum_eight(all + k, sum + k);
    }
    /// The sums of a pack of rows, one row a lane.
    static Values<Pack<double>, D, Fields<F...>> values(RowSums const* rows) {
        Index row[pack_size<double>];
        for (int lane = 0; lane < pack_size<double>; ++lane) row[lane] = room * lane;
        Values<Pack<double>, D, Fields<F...>> values;
        int next = 0;
        auto const give = [&]<class G>(G) {
            unrolled<components<G::rank, D>()>(
                [&](int k) { component(G::of(values), k) = fetch_one(rows->sum + next++, row); });
        };
        (give(F{}), ...);
        return values;
    }
};

/// Sums a law over the neighbours of each of a pack of particles, with a kernel of one kind or the other; `far` is
/// added to the squares behind the end of a row. Kept out of line, so that instantiations can be counted by name.
template <int D, class T, bool polynomial, class List, class Law>
[[gnu::noinline, gnu::flatten]] void sweep_rows(View<D> const& view, Records<D, T, List> const& records,
                                                Neighbours<D> const& neighbours, PackOfParticles<D> const& at,
                                                Kernel const& kernel, ZerosThen<T> const& far, Law const& law,
                                                RowSums<D, typename Law::gives>* rows) {
    using R = Pack<T>;
    using Reads = typename Law::reads;
    Pair<R, D, Unite<Reads, typename Law::own>, Reads> ij;
    ij.h = R(kernel.support / 3);
    for (int lane = 0; lane < at.count(); ++lane) {
        Vector<R, D> x_i;
        spread_own(view, at[lane], ij.i, typename Law::own{});
        // Last: what is in both lists must be rounded as that of the neighbours is.
        records.spread(at[lane], x_i, ij.i, Reads{});
        Values<R, D, typename Law::gives> total;
        auto const places = neighbours.places(at[lane]);
        std::size_t const count = places.size();
        for (std::size_t k = 0; k < count; k += pack_size<T>) {
            Vector<R, D> x_j;
            records.fetch(places.data() + k, x_j, ij.j);
            unrolled<D>([&](int a) { ij.x[a] = records.coordinate.difference(x_i[a], x_j[a]); });
            ij.r2 = far.after(count - k);
            unrolled<D>([&](int a) { ij.r2 += ij.x[a] * ij.x[a]; });
            auto const [W, F] = kernel.template at<polynomial>(ij.r2);
            ij.W = W;
            ij.F = F;
            ij.gradW = F * ij.x;
            law.add_to(total, ij);
        }
        rows[lane] = RowSums<D, typename Law::gives>(total);
    }
}

/// Which of the types L is the first that is the same as number k.
template <class... L>
constexpr std::size_t first_like(std::size_t k) {
    constexpr std::size_t count = sizeof...(L);
    std::size_t first[count] = {};
    std::size_t next = 0;
    [[maybe_unused]] auto const look = [&]<class This>(This) {
        std::size_t at = 0;
        bool found = false;
        ((found = found || std::is_same_v<This, L>, at += !found), ...);
        first[next++] = at;
    };
    (look(L{}), ...);
    return first[k];
}

template <int D, class T, bool polynomial, class... Parts>
void sweep_parts(Particles<D> const& particles, Neighbours<D> const& neighbours, Kernel const& kernel,
                 Parts const&... parts) {
    auto const view = particles.view();
    std::size_t const n = particles.size();
    // Records for each list of fields; parts that read the same share them.
    auto const records = [&]<std::size_t... k>(std::index_sequence<k...>) {
        std::tuple<Records<D, T, typename decltype(Parts::law)::reads>...> all;
        constexpr std::size_t first[] = {first_like<typename decltype(Parts::law)::reads...>(k)...};
        T* next = particles.template scratch<T>(
            (0 + ... + (first[k] == k ? std::tuple_element_t<k, decltype(all)>::width * n : 0)));
        auto const make = [&]<std::size_t m>(std::integral_constant<std::size_t, m>) {
            auto& own = std::get<m>(all);
            if constexpr (first[m] < m) {
                own = std::get<first[m]>(all);
            } else {
                own = {next, 4 * n, Coordinate<T>(kernel.support * 0x1p-24), {}};
                next += n * own.width;
                if constexpr (std::decay_t<decltype(own)>::is_relative)
                    own.frame = (1 / static_cast<double>(n)) * sum_over(n, Vector<double, D>{}, [&](std::size_t i) {
                                    return view.template get<Velocity>(i);
                                });
            }
        };
        (make(std::integral_constant<std::size_t, k>{}), ...);
        for_ranges(n, [&](std::size_t begin, std::size_t end) {
            ((first[k] == k ? std::get<k>(all).fill(view, begin, end) : void()), ...);
        });
        return all;
    }
    (std::index_sequence_for<Parts...>{});
    ZerosThen<T> const far(4 * kernel.support * kernel.support);
    auto const run = [&](auto const& part, auto const& own, std::size_t block) __attribute__((flatten)) {
        using Sums = RowSums<D, typename std::decay_t<decltype(part.law)>::gives>;
        constexpr std::size_t most = PackOfParticles<D>::most;
        Sums rows[most] = {};
        std::size_t const end = part.targets.begin[block + 1];
        for (std::size_t first = part.targets.begin[block]; first < end; first += most) {
            auto const count = static_cast<int>(std::min(most, end - first));
            PackOfParticles<D> const at(view, count, [&](int lane) { return part.targets[first + lane]; });
            sweep_rows<D, T, polynomial>(view, own, neighbours, at, kernel, far, part.law, rows);
            part.close(at, Sums::values(rows));
        }
    };
    for_blocks((parts.targets.blocks() + ...), [&](std::size_t block) {
        // Block b of the first part that has so many, else block b - blocks of the next.
        bool done = false;
        auto const in = [&](auto const& part, auto const& own) {
            if (done) return;
            done = block < part.targets.blocks();
            if (done) run(part, own, block);
            else block -= part.targets.blocks();
        };
        std::apply([&](auto const&... own) { (in(parts, own), ...); }, records);
    });
}

}  // namespace detail

/// Sums the law of each part over the neighbours of each of its targets and hands the sums, Values of Law::gives, to
/// its close (pairs/close.hpp). All parts read the state of before the sweep.
template <int D, class... Parts>
void sweep(Particles<D> const& particles, Neighbours<D> const& neighbours, Kernel const& kernel, Precision precision,
           Parts const&... parts) {
    auto const with = [&]<class T>(T) {
        if (kernel.is_polynomial) detail::sweep_parts<D, T, true>(particles, neighbours, kernel, parts...);
        else detail::sweep_parts<D, T, false>(particles, neighbours, kernel, parts...);
    };
    if (precision == Precision::mixed) with(float{});
    else with(double{});
}

}  // namespace coronet
