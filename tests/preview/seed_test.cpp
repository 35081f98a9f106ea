// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the look `seed` is ten by ten equal periods around the origin and nothing else, in a fog
// that is full at 500 m.
#include "frame_block.hpp"
#include "preview_fixture.hpp"

namespace ocean::preview {
namespace {

constexpr int kSide = 48;

class SeedTest : public PreviewTest {
  protected:
    /// Returns the pixels of a square straight below, half the sea's period a side.
    std::vector<float> below(double x, double y, double height, double metres = 20.0,
                             bool wireframe = false) {
        const double degrees = 2.0 * std::atan(0.5 * metres / height) * 180.0 / kPi;
        return seed({.eye = {x, y, height}, .pitch = -90.0, .field_of_view = degrees}, wireframe);
    }
    std::vector<float> seed(const Camera& camera, bool wireframe = false) {
        const Canvas canvas(kSide, kSide, GL_RGBA32F);
        DrawOptions options;
        options.width = options.height = kSide;
        options.wireframe = wireframe;
        Look look;
        look.kind = LookKind::seed;
        renderer_.draw(shown_, camera, look, options);
        return canvas.rgba();
    }
    static double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
        double largest = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            largest = std::max(largest, static_cast<double>(std::abs(a[i] - b[i])));
        }
        return largest;
    }
    /// How many pixels are fog alone.
    static int fog(const std::vector<float>& pixels) {
        int count = 0;
        for (std::size_t p = 0; p < pixels.size(); p += 4) {
            const double off = std::abs(pixels[p] - kSeedFog.r) +
                               std::abs(pixels[p + 1] - kSeedFog.g) +
                               std::abs(pixels[p + 2] - kSeedFog.b);
            count += off < 1e-4 ? 1 : 0;
        }
        return count;
    }

    Ocean sea_{test::wind_sea(64, 40.0), {.foam_start = FoamStart::empty}};
    SeaMaps maps_{{.compute = false, .foam_resolution = 32}};
    Renderer renderer_{{.cells = 16}};
    DrawnSea shown_ = maps_.show(sea_, 7.0);
};

TEST_F(SeedTest, ThereAreTenByTenEqualTiles) {
    const double period = shown_.period;
    const auto first = below(3.0, -5.0, 20.0);
    EXPECT_EQ(fog(first), 0);
    for (const auto& [i, j] : {std::pair{1, 0}, {0, -3}, {4, 4}, {-4, 2}}) {
        EXPECT_LT(largest_difference(below(3.0 + i * period, -5.0 + j * period, 20.0), first), 2e-3)
            << i << ", " << j;
    }
    EXPECT_GT(largest_difference(below(13.0, -5.0, 20.0), first), 0.02);
    // So they are from one to three periods away, where other seas hide theirs.
    const auto ahead = [&](double x) {
        return seed({.eye = {x, 0.0, 30.0}, .pitch = -30.0, .field_of_view = 30.0});
    };
    EXPECT_LT(largest_difference(ahead(-3.0 * period), ahead(-2.0 * period)), 2e-3);
    // The middle of what would be the eleventh.
    for (const double x : {5.5 * period, -5.5 * period}) {
        EXPECT_EQ(fog(below(x, 0.0, 20.0)), kSide * kSide);
        EXPECT_EQ(fog(below(0.0, x, 20.0)), kSide * kSide);
    }
    // Straight over an edge there is water on one side alone.
    EXPECT_NEAR(fog(below(5.0 * period, 0.0, 20.0)), 0.5 * kSide * kSide, 0.1 * kSide * kSide);
}

TEST_F(SeedTest, FogIsLinearAndFullAt500Metres) {
    const auto red = [&](double height) {
        const auto pixels = below(0.0, 0.0, height);
        double sum = 0.0;
        for (std::size_t p = 0; p < pixels.size(); p += 4) sum += pixels[p];
        return 4.0 * sum / static_cast<double>(pixels.size());
    };
    const double at_50 = red(50.0), at_250 = red(250.0);
    // Red, of which the water has least: from 1/10 to 1/2 of the way to the fog.
    EXPECT_NEAR((kSeedFog.r - at_250) / (kSeedFog.r - at_50), 0.5 / 0.9, 0.02);
    EXPECT_LT(fog(below(0.0, 0.0, 480.0)), 10);
    EXPECT_EQ(fog(below(0.0, 0.0, 520.0)), kSide * kSide);
}

TEST_F(SeedTest, TheMeshAloneLetsTheBackgroundThrough) {
    const int seen = fog(below(0.0, 0.0, 5.0, 4.0, true));
    EXPECT_GT(seen, kSide * kSide / 4);
    EXPECT_LT(seen, kSide * kSide);
}

}  // namespace
}  // namespace ocean::preview
