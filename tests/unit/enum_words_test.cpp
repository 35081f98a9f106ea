// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Words come from the enumerators themselves, in their number and order.
#include "ocean/enum_words.hpp"

#include <gtest/gtest.h>

namespace ocean {
namespace {

enum class Toy { alone };
enum class Toys { bear, kite, spinning_top };

TEST(EnumWords, AreTheEnumerators) {
    static_assert(enum_count<Toy>() == 1);
    static_assert(enum_count<Toys>() == 3);
    EXPECT_EQ(word_of(Toys::bear), "bear");
    EXPECT_EQ(word_of(Toys::spinning_top), "spinning_top");
    EXPECT_EQ(kEnumWords<Toys>[1], "kite");
    EXPECT_EQ(enumerator_word<static_cast<Toys>(3)>(), "");
}

}  // namespace
}  // namespace ocean
