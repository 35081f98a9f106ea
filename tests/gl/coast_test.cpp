// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A coast by the backend `gl`: its surface is that of the processor.
#include "ocean/gl/backend.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/ocean.hpp"
#include "preview/beach_sea.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

constexpr double kTime = 20.0;
constexpr ChannelSet kSurface = {Channel::dx,
                                 Channel::dy,
                                 Channel::height,
                                 Channel::slope_x,
                                 Channel::slope_y,
                                 Channel::dx_x,
                                 Channel::dy_y,
                                 Channel::dx_y,
                                 Channel::vx,
                                 Channel::vy,
                                 Channel::vz,
                                 channel_of(LandMask::depth),
                                 channel_of(LandMask::breaking)};

/// So far from the world's origin that a carrier in single precision would be off by 1e-3.
constexpr std::array<double, 2> kCorner = {40000.0, -30000.0};
/// From beyond the border of the bed, where the open sea fades in, over the surf to dry land.
const Domain kRegion{{kCorner[0] - 8.0, kCorner[1] + 60.0}, {288.0, 24.0}, {149, 13}, false};

double largest_difference(const Surface& a, const Surface& b, Channel channel) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.channel(channel).size(); ++i) {
        // std::max would drop a NaN.
        const double difference = std::abs(static_cast<double>(a.channel(channel)[i]) -
                                           static_cast<double>(b.channel(channel)[i]));
        if (!(difference <= largest)) largest = difference;
    }
    return largest;
}

class GlCoast : public ::testing::Test {
  protected:
    /// Compares the channels of a region; `bound` is in significant wave heights.
    void expect_equal(double time, ChannelSet channels, double bound = 1e-5) {
        const Surface expected = cpu_.region(time, kRegion, channels);
        const Surface made = gpu_.region(time, kRegion, channels);
        for (int c = 0; c < kFirstMask + kMaskCount; ++c) {
            const auto channel = static_cast<Channel>(c);
            if (!channels.contains(channel)) continue;
            const auto values = expected.channel(channel);
            const auto [low, high] = std::ranges::minmax(values);
            EXPECT_GT(high - low, 0.02f) << c;
            EXPECT_LE(largest_difference(made, expected, channel), bound * height_) << c;
        }
    }

    Sea sea_ = test::beach_sea(kCorner);
    Ocean cpu_{sea_};
    Ocean gpu_{sea_, {.backend = gl::kBackend}};
    double height_ = cpu_.state().significant_wave_height.resolved;
};

TEST_F(GlCoast, HasTheSurfaceOfTheProcessor) {
    expect_equal(kTime, kSurface);
}

TEST_F(GlCoast, SumsWhatChannelsNeed) {
    expect_equal(kTime, {Channel::height, channel_of(LandMask::depth)});
    expect_equal(kTime + 3.0, {Channel::height, Channel::slope_x, Channel::slope_y});
}

TEST_F(GlCoast, FollowsTheSeaWhenTheWindTurns) {
    expect_equal(kTime, Channel::height);
    const Surface before = gpu_.region(kTime, kRegion, Channel::height);
    for (Ocean* const ocean : {&cpu_, &gpu_}) ocean->set("wind_direction", "40");
    expect_equal(kTime, Channel::height);
    const Surface after = gpu_.region(kTime, kRegion, Channel::height);
    EXPECT_GT(largest_difference(before, after, Channel::height), 0.1 * height_);
}

TEST_F(GlCoast, LeavesTracesOfThePastToTheProcessor) {
    // Sand is wet from 2 cm of water on: an error of the height counts so much more.
    expect_equal(kTime, channel_of(LandMask::wetness), 1e-3);
}

}  // namespace
}  // namespace ocean
