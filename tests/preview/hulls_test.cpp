// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The wakes of hulls in a picture: the drawn water has the heights of the library's region, trails
// are its foam, and where no wake is the open sea is drawn as ever.
#include "coast_windows.hpp"
#include "ocean/internal/preview/probe.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/ocean.hpp"
#include "preview/preview_fixture.hpp"

namespace ocean::preview {
namespace {

constexpr double kBoatTime = 3.0;
constexpr std::array<double, 3> kBoatEye = {-6.0, 12.0, 3.0};

/// A boat of 12 m that goes east and is at (15, 20) at the time.
Parameters sea_with_boat() {
    Parameters parameters = test::wind_sea(64, 200.0);
    Hull& hull = parameters.hulls.emplace_back();
    hull.length = 12.0;
    hull.beam = 3.0;
    hull.draught = 0.8;
    hull.wake_resolution = 64;
    auto track = std::make_shared<HullTrack>();
    track->rows = {{-100.0, -500.0, 20.0}, {100.0, 500.0, 20.0}};
    hull.track = track;
    return parameters;
}

class HullPreviewTest : public PreviewTest {
  protected:
    static Camera camera() { return looking(kBoatEye, {5.0, 20.0, 0.0}); }

    Ocean sea_{sea_with_boat()};
    SeaMaps maps_{small_windows()};
    Renderer renderer_{{.cells = 32}};
};

TEST_F(HullPreviewTest, VerticesAtSamplesOfAWindowHaveTheHeightsOfTheRegion) {
    const DrawnSea sea = maps_.show(sea_, kBoatTime, kBoatEye);
    const Domain labels{{-4.0, 16.0}, {8.0, 8.0}, {9, 9}, false};
    expect_heights_of_the_region(sea_, kBoatTime, labels, renderer_, sea, camera());
    Surface wake(labels, kBoatTime, Channel::height);
    sea_.wake_into(0, kBoatTime, labels, outputs_of(wake));
    EXPECT_GT(std::ranges::max(wake.channel(Channel::height)), 0.05f);
}

TEST_F(HullPreviewTest, TrailsAreFoamAndItsDepthIsThatOfTheOpenSea) {
    const DrawnSea sea = maps_.show(sea_, kBoatTime, kBoatEye);
    ASSERT_TRUE(sea.coast);
    EXPECT_FALSE(sea.coast->bed);
    const auto& windows = sea.coast->windows;
    const Domain row{{0.0, 20.0}, {9.0, 1.0}, {10, 2}, false};
    const Surface region = sea_.region(kBoatTime, row, channel_of(LandMask::trail));
    for (std::size_t i = 0; i < 10; ++i) {
        const auto x = static_cast<double>(i);
        const double trail = static_cast<double>(region.channel(channel_of(LandMask::trail))[i]);
        const auto cover = read_windows(windows, &CoastImage::traces, 0, x, 20.0);
        EXPECT_NEAR(cover.value_or(-1.0), trail, 1e-6);
        EXPECT_EQ(read_windows(windows, &CoastImage::shape, 3, x, 20.0), 1000.0);
    }
    EXPECT_GT(region.channel(channel_of(LandMask::trail))[5], 0.3f);
}

TEST_F(HullPreviewTest, WhereTheSumOfSeaAndWakeBreaksFoamIsDrawn) {
    Parameters parameters = sea_with_boat();
    parameters.hulls.front().factor = 4.0;
    parameters.hulls.front().trail_lifetime = 0.0;
    parameters.surface.foam_coverage = FoamCoverage::threshold;
    Ocean breaking(parameters);
    parameters.hulls.clear();
    Ocean open(parameters);
    const DrawnSea sea = maps_.show(breaking, kBoatTime, kBoatEye);
    SeaMaps other_maps(small_windows());
    const DrawnSea alone = other_maps.show(open, kBoatTime, kBoatEye);
    const Domain labels{{-3.0, 12.0}, {12.0, 12.0}, {25, 25}, false};
    const Surface region =
        breaking.region(kBoatTime, labels, {Channel::whitecap, Channel::dx, Channel::dy});
    const auto whitecaps = region.channel(Channel::whitecap);
    const double power = breaking.cover_power(kBoatTime);
    double most = 0.0, cover = 0.0, without = 0.0;
    for (std::size_t n = 0; n < whitecaps.size(); ++n) {
        const auto [x, y] = labels.place(static_cast<int>(n) % 25, static_cast<int>(n) / 25);
        const auto whitecap = static_cast<double>(whitecaps[n]);
        const auto drawn = read_windows(sea.coast->windows, &CoastImage::traces, 3, x, y);
        EXPECT_NEAR(drawn.value_or(-1.0), std::pow(whitecap, power), 1e-3) << x << " " << y;
        if (whitecap <= most) continue;
        most = whitecap;
        const std::array<double, 2> place{x + static_cast<double>(region.channel(Channel::dx)[n]),
                                          y + static_cast<double>(region.channel(Channel::dy)[n])};
        cover = probe(renderer_, sea, camera(), place).value().cover;
        without = probe(renderer_, alone, camera(), place).value().cover;
    }
    EXPECT_GT(most, 0.5);
    EXPECT_GT(cover, without + 0.2);
    // Windows whose cells are wide have none.
    EXPECT_EQ(read_windows({sea.coast->windows.back()}, &CoastImage::traces, 3, 6.0, 20.0), 0.0);
}

TEST_F(HullPreviewTest, WhereNoWakeIsTheOpenSeaIsDrawn) {
    Camera away = camera();
    away.eye = {-6.0, 2000.0, 3.0};
    away.look_at({-6.0, 2100.0, 0.0});
    Parameters parameters = sea_with_boat();
    parameters.hulls.clear();
    Ocean open(parameters);
    const auto with_hulls = picture(renderer_, maps_.show(sea_, kBoatTime, away.eye), away);
    const auto without = picture(renderer_, maps_.show(open, kBoatTime, away.eye), away);
    // The mesh is that of the windows, finer than the maps.
    double difference = 0.0;
    for (std::size_t i = 0; i < without.size(); ++i) {
        difference += std::abs(static_cast<double>(with_hulls[i]) - without[i]);
    }
    EXPECT_LT(difference / static_cast<double>(without.size()), 2.0);
}

}  // namespace
}  // namespace ocean::preview
