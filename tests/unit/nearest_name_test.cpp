// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A hint names the mistyped word, and nothing for a word that was not mistyped.
#include "ocean/internal/nearest_name.hpp"

#include <gtest/gtest.h>

#include <array>

namespace ocean {
namespace {

TEST(NearestName, NamesWhatWasMistypedAndNothingElse) {
    constexpr std::array<std::string_view, 7> kNames = {"x",         "y",    "a1",  "name",
                                                        "direction", "time", "west"};
    constexpr std::pair<std::string_view, std::string_view> kHints[] = {
        {"nome", "name"},
        {"names", "name"},
        {"dirction", "direction"},
        {"wset", "west"},
        {"direction_to", "direction"},
        // Other columns of people's tables beside x and y, and texts without a word.
        {"", ""},
        {"z", ""},
        {"x?y", ""},
        {"1,5", ""},
        {"a", ""},
        {"id", ""},
        {"lon", ""},
        {"lat", ""},
        {"depth", ""},
        {"station", ""},
        {"foam", ""},
        {"a3", ""},
        {"u10", ""},
        {"naame", "name"}};
    for (const auto& [word, hint] : kHints) EXPECT_EQ(nearest_name(word, kNames), hint) << word;
}

}  // namespace
}  // namespace ocean
