// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the drawn land is the terrain's own map, sample by sample and between the samples; its
// tiles meet without a seam; its mesh has no holes; shadows fall on the side away from the sun; and
// views that only a sea has are refused.
#include "ocean/error.hpp"
#include "ocean/internal/preview/land_maps.hpp"
#include "ocean/internal/preview/probe.hpp"
#include "ocean/terrain.hpp"
#include "preview_fixture.hpp"

namespace ocean::preview {
namespace {

TerrainModel small_terrain() {
    TerrainModel terrain;
    terrain.resolution = 64;
    terrain.patch_size = 512.0;
    terrain.beta = 2.1;
    terrain.rms = 30.0;
    terrain.mean = 700.0;
    return terrain;
}

class LandTest : public PreviewTest {
  protected:
    /// Returns the square of `metres` a side around a place from straight above.
    std::vector<float> from_above(const std::array<double, 2>& middle, double metres, int side,
                                  View view) {
        const Canvas canvas(side, side, GL_RGBA32F);
        DrawOptions options;
        options.width = options.height = side;
        options.view = view;
        options.linear = true;
        Camera camera;
        camera.eye = {middle[0], middle[1], 1500.0};
        renderer_.draw_from_above(shown_, camera, middle[0], middle[1], metres, options);
        return canvas.rgba();
    }

    Terrain land_{small_terrain(), {.threads = 1}};
    LandMaps maps_;
    Renderer renderer_{{.land_threads = 2}};
    DrawnLand shown_ = maps_.show(land_, 128);
};

TEST_F(LandTest, TheDrawnHeightIsThatOfTheMap) {
    const Surface map = land_.surface({Channel::height}, 128);
    const double texel = texel_of(shown_);
    ASSERT_EQ(texel, 4.0);
    for (const auto& [i, j] : {std::pair{0, 0}, {127, 3}, {64, 127}, {31, 90}}) {
        // Samples, seen from tiles away too.
        const std::array<double, 2> place = {i * texel - 512.0, j * texel + 1024.0};
        Camera camera;
        camera.eye = {place[0] + 3.0, place[1] - 5.0, 900.0};
        const auto found = probe(renderer_, shown_, camera, place);
        ASSERT_TRUE(found);
        const double height = static_cast<double>(map.channel(
            Channel::height)[static_cast<std::size_t>(j) * 128 + static_cast<std::size_t>(i)]);
        EXPECT_NEAR(found->map_height, height, 1e-5 * shown_.rms);
        EXPECT_NEAR(found->mesh_height, height, 1e-3 * shown_.rms);
        EXPECT_NEAR(shown_.image->height_at(place[0], place[1]), height, 1e-6 * shown_.rms);
    }
}

TEST_F(LandTest, BetweenSamplesItIsNearTheSumOfAllWaves) {
    double worst = 0.0;
    for (int n = 0; n < 40; ++n) {
        const WorldPoint point{17.3 * n - 200.0, 411.0 - 29.7 * n};
        QuerySample exact{};
        land_.query({&point, 1}, {&exact, 1}, {.exact = true});
        const double drawn = shown_.image->height_at(point.x, point.y);
        worst = std::max(worst, std::abs(drawn - exact.height));
        if (n % 10 != 0) continue;
        Camera camera;
        camera.eye = {point.x, point.y, 900.0};
        const auto found = probe(renderer_, shown_, camera, {point.x, point.y});
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->map_height, drawn, 1e-5 * shown_.rms);
    }
    EXPECT_LT(worst, 5e-3 * shown_.rms);
}

TEST_F(LandTest, TilesMeetWithoutASeam) {
    constexpr int kSide = 128;
    constexpr int kNear = 6;  // columns beside a border: more than a texel
    for (const std::array<double, 2>& corner : {std::array{0.0, 0.0}, {512.0, -1024.0}}) {
        const std::vector<float> pixels = from_above(corner, 128.0, kSide, View::normal);
        // Means of the differences between neighbouring columns, and rows.
        const auto step = [&](int at, bool rows) {
            double sum = 0.0;
            for (int k = 0; k < kSide; ++k) {
                const int a = rows ? at * kSide + k : k * kSide + at;
                const int b = rows ? a + kSide : a + 1;
                sum += std::abs(static_cast<double>(pixels[4 * static_cast<std::size_t>(a) + 1] -
                                                    pixels[4 * static_cast<std::size_t>(b) + 1]));
            }
            return sum / kSide;
        };
        for (const bool rows : {false, true}) {
            double others = 0.0;
            for (int at = 0; at + 1 < kSide; ++at) {
                if (std::abs(at - kSide / 2) > kNear) others = std::max(others, step(at, rows));
            }
            for (int at = kSide / 2 - kNear; at <= kSide / 2 + kNear; ++at) {
                EXPECT_LT(step(at, rows), others) << at << " of " << corner[0];
            }
        }
    }
}

TEST_F(LandTest, TheMeshHasNoHoles) {
    for (const double heading : {10.0, 130.0, 250.0}) {
        for (const double above : {2.0, 40.0, 400.0}) {
            Camera camera;
            camera.eye = {33.0, -70.0, shown_.image->height_at(33.0, -70.0) + above};
            camera.heading = heading;
            camera.pitch = -60.0;
            constexpr int kSide = 96;
            const Canvas canvas(kSide, kSide, GL_RGBA32F);
            renderer_.draw(shown_, camera, {},
                           {.width = kSide, .height = kSide, .view = View::numbers});
            const std::vector<float> pixels = canvas.rgba();
            int holes = 0;
            for (std::size_t i = 0; i < pixels.size(); i += 4) holes += pixels[i] == 0.0f ? 1 : 0;
            EXPECT_EQ(holes, 0) << heading << " " << above;
        }
    }
}

TEST_F(LandTest, TheSunThatTheGroundHidesDoesNotLightIt) {
    constexpr int kSide = 64;
    Camera camera;
    camera.eye = {0.0, 0.0, 1000.0};
    camera.pitch = -89.0;
    Look low;
    low.sun_altitude = 8.0;
    low.land_colours = LandColours::seed;
    Renderer without({.shadow_steps = 0});
    const auto mean = [&](Renderer& renderer) {
        const Canvas canvas(kSide, kSide, GL_RGBA32F);
        DrawOptions options;
        options.width = options.height = kSide;
        options.linear = true;
        renderer.draw(shown_, camera, low, options);
        double sum = 0.0;
        const std::vector<float> pixels = canvas.rgba();
        for (std::size_t i = 0; i < pixels.size(); i += 4) sum += static_cast<double>(pixels[i]);
        return sum;
    };
    EXPECT_LT(mean(renderer_), 0.9 * mean(without));
}

TEST_F(LandTest, TheRampReachesTheColoursOfTheTeachingPrograms) {
    // Without sun, haze and slopes the light is the albedo times that of the sky.
    TerrainModel flat = small_terrain();
    flat.rms = 1e-3;
    land_.set_model(flat);
    shown_ = maps_.show(land_, 128);
    constexpr int kSide = 256;
    const Canvas canvas(kSide, kSide, GL_RGBA32F);
    Camera camera;
    camera.eye = {256.0, 256.0, 1200.0};
    camera.pitch = -90.0;
    Look look;
    look.sun_altitude = -3.0;
    look.visibility = 0.0;
    look.land_colours = LandColours::seed;
    DrawOptions options;
    options.width = options.height = kSide;
    options.linear = true;
    renderer_.draw(shown_, camera, look, options);
    const std::vector<float> pixels = canvas.rgba();
    double low = 1e9, high = 0.0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        const auto ratio = static_cast<double>(pixels[i] / pixels[i + 2]);  // red over blue
        low = std::min(low, ratio);
        high = std::max(high, ratio);
    }
    const auto linear = [](double c) { return std::pow((c / 255.0 + 0.055) / 1.055, 2.4); };
    const double sky = low / (linear(255) / linear(156));
    EXPECT_NEAR(high / sky, linear(66) / linear(18), 0.15 * linear(66) / linear(18));
}

TEST_F(LandTest, ViewsOfASeaAloneAreRefused) {
    EXPECT_EQ(view_names(SceneKind::land),
              (std::vector<std::string>{"shaded", "height", "normal", "slope"}));
    EXPECT_THROW(view_of("foam", SceneKind::land), Error);
    EXPECT_THROW(
        renderer_.draw(shown_, Camera{}, Look{}, {.width = 8, .height = 8, .view = View::foam}),
        Error);
}

TEST_F(LandTest, TheMapIsMadeOnlyForAChange) {
    const int before = land_.runs().maps;
    const auto image = maps_.show(land_, 128).image;
    EXPECT_EQ(land_.runs().maps, before);
    EXPECT_EQ(image, shown_.image);
    land_.set("mean", "12");
    const DrawnLand lower = maps_.show(land_, 128);
    EXPECT_EQ(land_.runs().maps, before + 1);
    EXPECT_EQ(lower.mean, 12.0);
    // The land that was shown before keeps its image.
    EXPECT_NEAR(shown_.image->height_at(5.0, 9.0) - lower.image->height_at(5.0, 9.0), 688.0, 1e-3);
}

}  // namespace
}  // namespace ocean::preview
