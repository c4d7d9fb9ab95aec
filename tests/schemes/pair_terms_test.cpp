// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/pair_terms.hpp"

#include <gtest/gtest.h>

namespace coronet {
namespace {

struct Attraction {
    using reads = Fields<Volume>;
    using own = Fields<>;
    using gives = Fields<Acceleration>;
};

// A scheme without sound asks the user for a speed of sound only if a term that acts wants one.
TEST(PairTerms, KnowWhatTheActiveOnesRead) {
    Sum<Attraction, ArtificialViscosity> terms;
    EXPECT_TRUE(any_active(terms));
    EXPECT_TRUE(any_reads<Volume>(terms));
    EXPECT_FALSE(any_reads<SoundSpeed>(terms));
    static_cast<ArtificialViscosity&>(terms).alpha = 0.1;
    EXPECT_TRUE(any_reads<SoundSpeed>(terms));
}

}  // namespace
}  // namespace coronet
