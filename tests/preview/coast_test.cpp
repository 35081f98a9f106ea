// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A coast in a picture: the drawn water has the heights of the library's region, its windows stand
// still in the world, and land and water leave no gap.
#include "bed_ground.hpp"
#include "coast_windows.hpp"
#include "ocean/internal/preview/probe.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/ocean.hpp"
#include "preview/beach_sea.hpp"
#include "preview/preview_fixture.hpp"

namespace ocean::preview {
namespace {

constexpr double kTime = 20.0;
constexpr std::array<double, 3> kEye = {224.3, 96.4, 2.0};

class CoastPreviewTest : public PreviewTest {
  protected:
    static Camera camera() { return looking(kEye, {260.0, 96.0, 0.0}); }
    const DrawnSea& shown() {
        shown_ = maps_.show(sea_, kTime, kEye);
        return shown_;
    }

    bool coast_is_computed_ = false;
    Ocean sea_{test::beach_sea(),
               {.build_progress = [this](std::string_view, double) { coast_is_computed_ = true; }}};
    SeaMaps maps_{small_windows()};
    Renderer renderer_{{.cells = 32}};
    DrawnSea shown_;
};

TEST_F(CoastPreviewTest, VerticesAtSamplesOfAWindowHaveTheHeightsOfTheRegion) {
    const DrawnSea& sea = shown();
    // Labels of the finest window within the finest level of the mesh.
    const Domain labels{{220.0, 92.0}, {8.0, 8.0}, {9, 9}, false};
    EXPECT_GT(expect_heights_of_the_region(sea_, kTime, labels, renderer_, sea, camera()), 0.05);
}

TEST_F(CoastPreviewTest, WaterEndsWhereTheRegionIsDry) {
    const DrawnSea& sea = shown();
    const Domain row{{180.0, 96.0}, {80.0, 1.0}, {161, 3}, false};
    const Surface region = sea_.region(kTime, row, channel_of(LandMask::depth));
    const auto depth = region.channel(channel_of(LandMask::depth));
    int wet = 0, dry = 0;
    for (std::size_t i = 0; i < 161; i += 5) {
        const auto [x, y] = row.place(static_cast<int>(i), 0);
        if (std::abs(depth[i]) < 0.1f) continue;  // a coarser mesh has another line
        const auto found = probe(renderer_, sea, camera(), {x, y});
        EXPECT_EQ(found.has_value(), depth[i] > 0.0f) << x << ": " << depth[i];
        ++(depth[i] > 0.0f ? wet : dry);
    }
    EXPECT_GT(wet, 5);
    EXPECT_GT(dry, 5);
}

TEST_F(CoastPreviewTest, LandAndWaterLeaveNoGap) {
    const DrawnSea& sea = shown();
    const Canvas canvas(96, 96, GL_RGBA32F);
    canvas.bind();
    renderer_.draw_from_above(sea, camera(), 225.0, 96.0, 90.0, {.width = 96, .height = 96});
    const std::vector<float> pixels = canvas.rgba();
    int holes = 0;
    for (std::size_t n = 3; n < pixels.size(); n += 4) holes += pixels[n] < 1.0f ? 1 : 0;
    EXPECT_EQ(holes, 0);
}

TEST_F(CoastPreviewTest, WindowsStandStillInTheWorldAndKeepTheirFoam) {
    CoastMapsOptions options;
    options.samples = 64;
    CoastSurface surface(options);
    // Surf breaks for some seconds.
    for (int tick = 0; tick < 24; ++tick) surface.at(sea_, kTime + 0.25 * tick, kEye);
    const double time = kTime + 6.0;
    const std::vector<CoastImage> before = surface.at(sea_, time, kEye);
    const std::vector<CoastImage> after = surface.at(sea_, time, {kEye[0] + 3.3, kEye[1], 2.0});
    ASSERT_NE(before[0].window, after[0].window);
    double foam = 0.0;
    for (int i = 0; i < 20; ++i) {
        const double x = 214.0 + i, y = 96.0;
        for (const auto& [image, component] :
             {std::pair{&CoastImage::shape, 2u}, std::pair{&CoastImage::traces, 0u},
              std::pair{&CoastImage::traces, 2u}, std::pair{&CoastImage::traces, 3u}}) {
            const auto was = read_windows(before, image, component, x, y);
            const auto is = read_windows(after, image, component, x, y);
            ASSERT_TRUE(was && is);
            EXPECT_NEAR(*was, *is, 1e-6) << x;
        }
        foam = std::max(foam, *read_windows(after, &CoastImage::traces, 0, x, y));
    }
    EXPECT_GT(foam, 0.05);
}

TEST_F(CoastPreviewTest, TheWetEdgeOfAnObliqueShoreIsNoStaircaseFarAway) {
    // A beach of 1:10 that rises to the north-east, under ripples, in a window whose cells are 8 m:
    // the line where wet ground ends is straight within a sixteenth of a cell.
    Sea sea = test::beach_sea();
    GivenBed given;
    given.grid = {{0.0, 0.0}, {400.0, 400.0}, {81, 81}, false};
    const auto height = [](double x, double y) { return (0.8 * x + 0.6 * y - 280.0) / 10.0; };
    for (int j = 0; j < 81; ++j) {
        for (int i = 0; i < 81; ++i) {
            given.heights.push_back(static_cast<float>(std::max(-8.0, height(5.0 * i, 5.0 * j))));
        }
    }
    Parameters parameters = sea.parameters;
    parameters.waves.front().wind_speed = 1.0;
    parameters.water.bed = nullptr;
    parameters.water.bed = make_sea_bed(std::move(given), parameters.water);
    Ocean ripples(Sea{parameters, {}});
    CoastMapsOptions options;
    options.samples = 64;
    CoastSurface surface(options);
    const std::vector<CoastImage> images = surface.at(ripples, kTime, {20.0, 200.0, 2.0});
    double least = 1e9, most = -1e9;
    for (double y = 150.0; y < 250.0; y += 1.0) {
        double x = 150.0;
        const auto read = [&](std::size_t n) {
            return *read_windows(images, &CoastImage::traces, n, x, y);
        };
        while (read(2) > 0.2 && read(3) > 0.0) x += 0.05;
        const double across = 10.0 * height(x, y);  // from the line of still water [m]
        least = std::min(least, across);
        most = std::max(most, across);
    }
    EXPECT_LT(most - least, 1.0);
}

TEST_F(CoastPreviewTest, FoamIsWhatBreaksOrWhatIsLeftOfIt) {
    CoastMapsOptions options;
    options.samples = 64;
    CoastSurface surface(options);
    surface.at(sea_, kTime, kEye);
    const std::vector<CoastImage> then = surface.at(sea_, kTime + 0.5, kEye);
    const double left = std::exp(-0.5 / sea_.parameters().water.shore.surf_foam_lifetime);
    const Domain row{{212.0, 96.0}, {40.0, 1.0}, {81, 3}, false};
    const Channel breaking = channel_of(LandMask::breaking);
    const Surface first = sea_.region(kTime, row, breaking);
    const Surface second = sea_.region(kTime + 0.5, row, breaking);
    double highest = 0.0;
    for (std::size_t i = 0; i < 81; ++i) {
        const auto [x, y] = row.place(static_cast<int>(i), 0);
        const double expected = std::max(static_cast<double>(second.channel(breaking)[i]),
                                         left * static_cast<double>(first.channel(breaking)[i]));
        const auto found = read_windows(then, &CoastImage::traces, 0, x, y);
        if (!found || std::abs(x - kEye[0]) > 14.0) continue;  // the finest window
        EXPECT_NEAR(*found, std::pow(expected, 1.35), 1e-4) << x;
        highest = std::max(highest, expected);
    }
    EXPECT_GT(highest, 0.02);
}

TEST_F(CoastPreviewTest, ASettledPictureHasThePastThatATickAfterTheOtherLeaves) {
    CoastMapsOptions options;
    options.samples = 64;
    CoastSurface followed(options);
    const double lifetimes = 3.0 * sea_.parameters().water.shore.surf_foam_lifetime;
    for (double ago = std::max(25.0, lifetimes + 1.0); ago > 0.0;) {
        followed.at(sea_, kTime - ago, kEye);
        ago -= ago > lifetimes ? 1.0 : 0.25;
    }
    const std::vector<CoastImage> expected = followed.at(sea_, kTime, kEye);
    options.foam_start = FoamStart::settled;
    CoastSurface settled(options);
    const std::vector<CoastImage>& found = settled.at(sea_, kTime, kEye);
    ASSERT_EQ(found.size(), expected.size());
    float foam = 0.0f, drying = 0.0f;
    // Along the border of the bed the open sea, which runs up nowhere, mixes in.
    const Domain& bed = sea_.parameters().water.bed->domain;
    const auto is_inside = [&](const CoastWindow& window, int at) {
        const auto place = window.domain().place(at % window.samples, at / window.samples);
        return std::ranges::all_of(std::array{0u, 1u}, [&](unsigned axis) {
            const double off = (place[axis] - bed.origin[axis]) / bed.size[axis];
            return off > 0.125 && off < 0.875;
        });
    };
    for (std::size_t w = 0; w < found.size(); ++w) {
        ASSERT_EQ(found[w].traces.size(), expected[w].traces.size());
        for (std::size_t i = 0; i < found[w].traces.size(); i += kWindowComponents) {
            ASSERT_NEAR(found[w].traces[i], expected[w].traces[i], 1e-4f) << w << " " << i;
            const float wet = found[w].traces[i + 2];
            if (is_inside(found[w].window, static_cast<int>(i / kWindowComponents))) {
                // A region's depth is that of the displaced label.
                ASSERT_NEAR(wet, expected[w].traces[i + 2], 0.06f) << w << " " << i;
            }
            foam = std::max(foam, found[w].traces[i]);
            if (found[w].shape[i + 3] < 0.0f) drying = std::max(drying, wet);
        }
    }
    EXPECT_GT(foam, 0.05f);
    EXPECT_GT(drying, 0.5f) << "sand that the swash has left";
}

TEST_F(CoastPreviewTest, ACoastInWorkIsGroundInTheOpenSea) {
    const DrawnSea ground = maps_.show(sea_, kTime, std::nullopt);
    ASSERT_TRUE(ground.coast);
    EXPECT_TRUE(ground.coast->windows.empty());
    EXPECT_NEAR(ground.coast->surface_at(300.0, 96.0), 3.0, 1e-5);
    EXPECT_FALSE(coast_is_computed_);
    const auto land = picture(renderer_, ground, camera());
    const auto sea = picture(renderer_, shown(), camera());
    EXPECT_TRUE(coast_is_computed_);
    EXPECT_NE(land, sea);
}

/// Pictures of the bed from above, under a light wind.
class CoastBedTest : public PreviewTest {
  protected:
    /// Returns the range of light that the middle half of the pixels has: glitter and foam are few
    /// pixels. The bed is that of beach_sea().
    double contrast(double depth, const char* water_type) {
        Camera camera;
        camera.eye = {240.0 - 20.0 * depth, 96.0, 1.0};
        camera.pitch = -90.0;
        camera.field_of_view = 40.0;
        const DrawnSea sea = maps_.show(sea_, kTime, camera.eye);
        Look look;
        look.water_type = water_type;
        look.sun_altitude = 60.0;
        const std::vector<float> pixels = light(renderer_, sea, camera, look, kSide, kSide);
        std::vector<double> green;
        for (std::size_t n = 1; n < pixels.size(); n += 4) green.push_back(double{pixels[n]});
        std::ranges::sort(green);
        const std::size_t n = green.size();
        return green[3 * n / 4] - green[n / 4];
    }

  private:
    static constexpr int kSide = 96;
    static Sea light_wind() {
        Sea sea = test::beach_sea();
        sea.parameters.waves.front().wind_speed = 2.5;
        return sea;
    }
    static SeaMapsOptions options() {
        SeaMapsOptions options;
        options.compute = false;
        options.detail = true;
        options.coast.samples = 64;
        return options;
    }

    Ocean sea_{light_wind()};
    SeaMaps maps_{options()};
    Renderer renderer_{{.cells = 32}};
};

TEST_F(CoastBedTest, TheNetOfLightFadesWithDepthAndInTurbidWater) {
    const double shallow = contrast(1.0, "jerlov_i");
    const double deep = contrast(4.0, "jerlov_i");
    const double turbid = contrast(4.0, "jerlov_9c");
    EXPECT_GT(shallow, 0.1);  // a bed that is lit evenly: 0.002
    EXPECT_GT(shallow, 1.25 * deep);
    EXPECT_GT(deep, 10.0 * turbid);
    EXPECT_LT(contrast(1.0, "jerlov_9c"), 0.5 * shallow);
}

TEST(BedImage, OfALargeBedCoversItWithFewerTexels) {
    const auto bed = test::beach_sea({1000.0, 500.0}).parameters.water.bed;
    const LandImage whole = bed_image(*bed, 2048);
    const LandImage fewer = bed_image(*bed, 41);
    EXPECT_EQ(whole.resolution, 81);
    EXPECT_EQ(fewer.resolution, 41);
    const auto texel = [](const LandImage& image, std::size_t i, std::size_t j) {
        return &image.texels[4 * (j * static_cast<std::size_t>(image.resolution) + i)];
    };
    for (std::size_t j = 0; j < 25; ++j) {  // the bed's rows; the edge is held beyond them
        for (std::size_t i = 0; i < 41; ++i) {
            ASSERT_EQ(texel(fewer, i, j)[0], texel(whole, 2 * i, 2 * j)[0]) << i << ' ' << j;
        }
    }
    EXPECT_FLOAT_EQ(texel(fewer, 38, 3)[1], 1.0f / 20.0f);
    for (const LandImage* image : {&whole, &fewer}) {
        EXPECT_EQ(image->origin, bed->domain.origin);
        // From the first texel to the last one: the longer side.
        EXPECT_DOUBLE_EQ(image->period * (image->resolution - 1) / image->resolution, 320.0);
    }
}

TEST_F(CoastPreviewTest, WindowsGrowWithTheHeightOfTheEye) {
    const CoastMapsOptions options;
    const auto low = coast_windows({0.0, 0.0, 2.0}, options);
    const auto high = coast_windows({0.0, 0.0, 300.0}, options);
    EXPECT_EQ(low[0].cell, 0.5);
    EXPECT_EQ(high[0].cell, 4.0);
    for (std::size_t w = 1; w < low.size(); ++w) EXPECT_EQ(low[w].cell, 4.0 * low[w - 1].cell);
}

}  // namespace
}  // namespace ocean::preview
