// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: frames_text is read back as the same frames, and only files of the pattern count as
// frames of the plan.
#include "ocean/bake/plan.hpp"

#include "ocean/internal/bake/existing_frames.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

TEST(FramesText, IsReadBackByParseFrames) {
    const auto text_of = [](const char* typed) { return frames_text(parse_frames(typed)); };
    EXPECT_EQ(text_of("1-3,7,9-11"), "1-3, 7, 9-11");
    EXPECT_EQ(text_of("10-30x10"), "10, 20, 30");  // a few are listed one by one
    EXPECT_EQ(text_of("10-60x10,61"), "10-60x10, 61");
    EXPECT_EQ(text_of("-2-1"), "-2-1");
    EXPECT_EQ(text_of("5,3,1"), "5, 3, 1");
    for (const char* typed : {"1-3,7,9-11", "10-60x10,61", "-12--2x2", "4"}) {
        EXPECT_EQ(parse_frames(text_of(typed)), parse_frames(typed)) << typed;
    }
    std::vector<int> squares;
    for (int i = 0; i < 1000; ++i) squares.push_back(i * i);
    EXPECT_LT(frames_text(squares).size(), 250u);
    EXPECT_TRUE(frames_text(squares).ends_with(" ... 998001"));
}

TEST(CommonStep, ReachesAllFrames) {
    EXPECT_EQ(common_step({4}), 1);
    EXPECT_EQ(common_step({10, 20, 30}), 10);
    EXPECT_EQ(common_step({1, 3, 9, 13}), 2);
    EXPECT_EQ(common_step({-3, 0, 6}), 3);
    constexpr int kMaxFrame = std::numeric_limits<int>::max();
    EXPECT_EQ(common_step({std::numeric_limits<int>::min(), kMaxFrame}), kMaxFrame);
}

TEST(OutputPattern, FindsTheNumberInAName) {
    const OutputPattern pattern("out/sea_####.df3");
    EXPECT_EQ(pattern.number_in("sea_0012.df3"), 12);
    EXPECT_EQ(pattern.number_in("sea_-002.df3"), -2);
    EXPECT_EQ(pattern.number_in("sea_12345_far1.df3"), 12345);
    EXPECT_EQ(pattern.number_in("see_0012.df3"), std::nullopt);
    EXPECT_EQ(pattern.number_in("sea_.df3"), std::nullopt);
    EXPECT_EQ(pattern.number_in("sea_99999999999.df3"), std::nullopt);
    EXPECT_EQ(OutputPattern("sea.df3").number_in("sea1.df3"), std::nullopt);
}

TEST(ExistingFrames, AreUnitedAndForeignOnesNamed) {
    EXPECT_EQ(united({3, 1, 2}, std::vector<int>{2, 5}), (std::vector<int>{1, 2, 3, 5}));
    const ExistingFrames there{{1}, {4, 5, 6, 9}};
    EXPECT_EQ(foreign_frames_warning(there, std::vector<int>{4, 9}, "a.usda"),
              "existing frames are of another sea or of other options: 5-6; a.usda leaves "
              "them out");
    EXPECT_EQ(foreign_frames_warning(there, std::vector<int>{4, 5, 6, 9}, "a.usda"), "");
}

}  // namespace
}  // namespace ocean
