// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a stage fills the picture with squares of whole pixels, a plane stands beside its
// energetic middle, and a plane that is too large shows the brightest pixel of each square.
#include "stage_picture.hpp"
#include "testing.hpp"

namespace ocean::app {
namespace {

StagePicture plane(int side, int middle) {
    StagePicture stage{side, side, std::vector<std::uint8_t>(3u * side * side), middle};
    for (std::size_t i = 0; i < stage.rgb.size(); i += 3) {
        const auto pixel = static_cast<int>(i / 3);
        stage.rgb[i] = static_cast<std::uint8_t>(pixel % side);
        stage.rgb[i + 1] = static_cast<std::uint8_t>(pixel / side);
        stage.rgb[i + 2] = 200;
    }
    return stage;
}

std::array<int, 3> pixel(const StagePicture& picture, int x, int y) {
    const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                        static_cast<std::size_t>(x));
    return {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
}

TEST(StageLayout, AWholePlaneStandsLeftAndItsMiddleRight) {
    const StagePicture stage = plane(64, 8);
    const StagePicture picture = laid_out(stage, 408, 200);
    ASSERT_EQ(picture.width, 408);
    ASSERT_EQ(picture.height, 200);
    // Each half has 200 pixels: the whole three times as large, 17 waves eleven times.
    const int left = 200 - 192, low = 4;
    for (const int n : {0, 1, 40, 63}) {
        EXPECT_EQ(pixel(picture, left + 3 * n + 1, low + 1), (std::array{n, 0, 200}));
        EXPECT_EQ(pixel(picture, left + 1, low + 3 * n + 2), (std::array{0, n, 200}));
    }
    const int right = 208, below = (200 - 187) / 2;
    EXPECT_EQ(pixel(picture, right + 5, below + 5), (std::array{24, 24, 200}));
    EXPECT_EQ(pixel(picture, right + 11 * 8, below + 11 * 8), (std::array{32, 32, 200}));
    EXPECT_EQ(pixel(picture, right + 186, below + 186), (std::array{40, 40, 200}));
    // The frame around the middle in the whole.
    EXPECT_EQ(pixel(picture, left + 3 * 24 - 1, low + 3 * 30), (std::array{255, 255, 255}));
    EXPECT_EQ(pixel(picture, 0, 0), (std::array{24, 24, 24}));
}

TEST(StageLayout, ATooLargePlaneShowsTheBrightestPixels) {
    StagePicture stage{64, 64, std::vector<std::uint8_t>(3u * 64 * 64), 8};
    stage.rgb[3 * (64 * 50 + 52)] = 250;
    const StagePicture picture = laid_out(stage, 72, 40);  // half as large
    int bright = 0;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 32; ++x) bright += pixel(picture, x, y) == std::array{250, 0, 0};
    }
    EXPECT_EQ(bright, 1);
    EXPECT_EQ(pixel(picture, 52 / 2, 4 + 50 / 2), (std::array{250, 0, 0}));
}

TEST(StageLayout, APlanFillsThePicture) {
    StagePicture stage{7, 128, std::vector<std::uint8_t>(3u * 7 * 128), 0};
    for (std::size_t i = 0; i < stage.rgb.size(); i += 3) {
        stage.rgb[i] = static_cast<std::uint8_t>(i / 3 % 7 + 1);
        stage.rgb[i + 1] = static_cast<std::uint8_t>(i / 21);
    }
    const StagePicture picture = laid_out(stage, 1280, 720);  // 182 x 5
    EXPECT_EQ(pixel(picture, 3, 40), (std::array{1, 0, 0}));
    EXPECT_EQ(pixel(picture, 3 + 182 * 6 + 181, 40 + 5 * 127 + 4), (std::array{7, 127, 0}));
    EXPECT_EQ(pixel(picture, 1, 360), (std::array{24, 24, 24}));
}

}  // namespace
}  // namespace ocean::app
