// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A hint names the mistyped word, and nothing for a word that was not mistyped.
#include "ocean/internal/nearest_name.hpp"

#include "testing.hpp"

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
        {"DIRECTION", "direction"},
        {"direction_x", "direction"},
        // Three edits, and a name that was not mistyped.
        {"direction_to", ""},
        {"direction", ""},
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
        {"naame", "name"},
        // The beginning of a name, of four letters at least.
        {"Direct", "direction"},
        {"dire", "direction"},
        {"dir", ""}};
    for (const auto& [word, hint] : kHints) EXPECT_EQ(nearest_name(word, kNames), hint) << word;
}

TEST(NearestName, TwoEditsNeedSixLettersAndThreeAreAnotherWord) {
    constexpr std::array<std::string_view, 2> kNames = {"spray", "streaks"};
    EXPECT_EQ(nearest_name("spry", kNames), "spray");
    EXPECT_EQ(nearest_name("spy", kNames), "");
    EXPECT_EQ(nearest_name("strkas", kNames), "streaks");
    EXPECT_EQ(nearest_name("streaks_of", kNames), "");
}

TEST(DidYouMean, ListsAllNamesThatAreEquallyNear) {
    constexpr std::array<std::string_view, 4> kNames = {"GET", "SET", "OUT", "SUBSCRIBE"};
    EXPECT_EQ(did_you_mean("SUBSCRXBE", kNames), "; did you mean SUBSCRIBE?");
    EXPECT_EQ(did_you_mean("bet", kNames), "; did you mean GET or SET?");
    EXPECT_EQ(did_you_mean("HELP", kNames), "");
    std::array<std::string, 12> texts;
    std::array<std::string_view, 12> many;
    for (std::size_t i = 0; i < many.size(); ++i) {
        texts[i] = std::string("row") + static_cast<char>('a' + i);
        many[i] = texts[i];
    }
    EXPECT_EQ(did_you_mean("rowx", many),
              "; did you mean rowa, rowb, rowc, rowd, rowe, rowf, rowg, rowh, rowi or rowj?");
}

TEST(DidYouMean, ShowsTheNameThatATypedFormStandsFor) {
    constexpr std::array<KnownName, 3> kNames = {
        {{"fetch", "waves.0.fetch"}, {"waves.fetch", "waves.0.fetch"}, {"time.fps", "time.fps"}}};
    EXPECT_EQ(did_you_mean("fetsh", kNames), "; did you mean waves.0.fetch?");
    EXPECT_EQ(did_you_mean("wavesfetch", kNames), "; did you mean waves.0.fetch?");
    EXPECT_EQ(did_you_mean("timeqfps", kNames), "; did you mean time.fps?");
}

}  // namespace
}  // namespace ocean
