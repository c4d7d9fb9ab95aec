// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How a sweep ends at its particles: whatever follows from the sums of a particle alone is computed there, by a close,
// before the sums are forgotten. A close is written once, over numbers R as laws are,
//     close(at, sums)   at.get<F>() and at.set<F>(value) move fields of type ValueOf<F, R, D>; sums is a Values<R, D,
//     ...>,
// and meets a pack of particles, one a lane, on the host (R = Pack<double>) and one particle on a GPU
// (pairs/sweep_cuda.cuh; R = double). It may write any field of its own particles.

#include <algorithm>
#include <type_traits>

#include "coronet/core/simd.hpp"
#include "coronet/fields/particles.hpp"

namespace coronet {

/// Up to a pack of particles. The lanes behind the last of them hold the first one, and are not written.
template <int D>
class PackOfParticles {
public:
    using Number = Pack<double>;
    static constexpr int dimension = D;
    static constexpr int most = pack_size<double>;

    /// particle(lane) is the number of the particle in each of the first `count` lanes, in rising order.
    template <class Particle>
    PackOfParticles(View<D> const& view, int count, Particle const& particle) : view_(view), count_(count) {
        for (int lane = 0; lane < most; ++lane) index_[lane] = static_cast<Index>(particle(lane < count ? lane : 0));
        in_a_row_ = count == most && index_[most - 1] - index_[0] == most - 1;
    }
    int count() const { return count_; }
    std::size_t operator[](int lane) const { return static_cast<std::size_t>(index_[lane]); }

    template <class F>
    ValueOf<F, Number, D> get() const {
        ValueOf<F, Number, D> value;
        unrolled<components<F::rank, D>()>([&](int k) {
            double const* const from = view_.template at<F>(k);
            component(value, k) = in_a_row_ ? load(from + index_[0]) : fetch_one(from, index_);
        });
        return value;
    }
    template <class F>
    void set(ValueOf<F, Number, D> const& value) const {
        unrolled<components<F::rank, D>()>([&](int k) {
            double* const to = view_.template at<F>(k);
            if (in_a_row_) store(component(value, k), to + index_[0]);
            else scatter(component(value, k), to, index_, count_);
        });
    }

private:
    View<D> view_;
    int count_;
    bool in_a_row_;
    Index index_[most];
};

/// The values of one lane.
template <int D, class... F>
Values<double, D, Fields<F...>> lane_of(Values<Pack<double>, D, Fields<F...>> const& packs, int lane) {
    Values<double, D, Fields<F...>> values;
    auto const take = [&]<class G>(G) {
        unrolled<components<G::rank, D>()>(
            [&](int k) { component(G::of(values), k) = component(G::of(packs), k)[lane]; });
    };
    (take(F{}), ...);
    return values;
}

/// A close from one that takes its particles one after another, close(i, sums) with sums of doubles: for what is rare.
template <class Close>
struct OneByOne {
    Close close;

    template <int D, class Sums>
    void operator()(PackOfParticles<D> const& at, Sums const& sums) const {
        for (int lane = 0; lane < at.count(); ++lane) close(at[lane], lane_of(sums, lane));
    }
};
template <class Close>
OneByOne(Close) -> OneByOne<Close>;

}  // namespace coronet
