// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/choices.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace coronet {

TEST(Choices, AreThoseOfTheSchema) {
    EXPECT_EQ(choices_of("method.gradient"), (Keys::Words{"sph", "cph", "fpm"}));
    EXPECT_FALSE(choices_of("method.precision").empty());
}

TEST(Choices, OfAKeyThatHasNoneAreAnError) {
    EXPECT_THROW(choices_of("method.support"), std::logic_error);
    EXPECT_THROW(choices_of("method.nothing"), std::logic_error);
}

}  // namespace coronet
