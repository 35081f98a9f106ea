// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Channels come out of their rows in the table: with any backend, whether it has code for them or
// not, and those that a host adds like those that are built in.
#include "ocean/channel.hpp"

#include "refusal.hpp"
#include "test_seas.hpp"
#include "waves/surface/map_writer.hpp"

namespace ocean {
namespace {

constexpr LinearSet kSlopes = {Linear::slope_x, Linear::slope_y};
constexpr LinearSet kGradients = {Linear::gradient_xx, Linear::gradient_yy, Linear::gradient_xy};

constexpr ChannelInfo kFurther[] = {
    {"steepness", "", kSlopes, kSlopes,
     [](const auto& p) {
         return p[Linear::slope_x] * p[Linear::slope_x] + p[Linear::slope_y] * p[Linear::slope_y];
     }},
    {"east", "m", Linear::displacement_x, ChannelInfo::Factor::minus_choppiness},
    {"spread",
     "",
     kGradients,
     {},
     [](const auto& p) {
         return p.choppiness * (p[Linear::gradient_xx] + p[Linear::gradient_yy]);
     }},
    {"fresh",
     "",
     kGradients,
     {},
     [](const auto& p) { return channel_formula::whitecap_of(p); },
     FoamUse::threshold},
    {"old",
     "",
     kGradients,
     {},
     [](const auto& p) { return 2 * channel_formula::foam_of(p); },
     FoamUse::past},
};
constexpr auto kSteepness = static_cast<Channel>(kChannelCount);
constexpr auto kEast = static_cast<Channel>(kChannelCount + 1);
constexpr auto kSpread = static_cast<Channel>(kChannelCount + 2);
constexpr auto kFresh = static_cast<Channel>(kChannelCount + 3);
constexpr auto kOld = static_cast<Channel>(kChannelCount + 4);
constexpr auto kNone = static_cast<Channel>(kChannelCount + 5);

Parameters stormy_sea() {
    Parameters parameters = test::wind_sea(32, 60.0, {.choppiness = 1.3, .depth = 12.0});
    parameters.surface.foam_lifetime = 0.3;
    return parameters;
}

class HostChannels : public testing::TestWithParam<Backend> {
  protected:
    Ocean ocean(const Parameters& parameters = stormy_sea()) {
        return Ocean(parameters, {.threads = 2, .backend = GetParam(), .channels = kFurther});
    }
};

TEST_P(HostChannels, AreTheirFormulasOfTheLinearFields) {
    using enum Channel;
    Ocean sea = ocean();
    const ChannelSet asked = {kSteepness, kEast, kFresh,   kOld, slope_x,
                              slope_y,    dx,    whitecap, foam};
    const Surface s = sea.evaluate(3.21, asked);
    EXPECT_GT(test::variance(s.channel(foam)), 0.0);
    for (std::size_t i = 0; i < s.channel(slope_x).size(); ++i) {
        const float hx = s.channel(slope_x)[i];
        const float hy = s.channel(slope_y)[i];
        ASSERT_EQ(s.channel(kSteepness)[i], hx * hx + hy * hy);
        ASSERT_FLOAT_EQ(s.channel(kEast)[i], s.channel(dx)[i]);
        ASSERT_NEAR(s.channel(kFresh)[i], s.channel(whitecap)[i], 1e-5f);
        ASSERT_NEAR(s.channel(kOld)[i], 2.0f * s.channel(foam)[i], 2e-5f);
    }
}

TEST_P(HostChannels, MixWithOthersInOneBufferAndLeaveTheRestAlone) {
    using enum Channel;
    Ocean sea = ocean();
    constexpr std::size_t kSamples = 64 * 64;
    std::vector<float> mixed(4 * kSamples, -7.0f);
    const MapOutput output{
        mixed.data(), 4, {{{height, 1.0f}, {kSteepness, -2.0f}, {}, {Linear::height, 3.0f}}}};
    sea.evaluate_into(1.0, {&output, 1}, 64);
    const Surface s = sea.evaluate(1.0, {height, kSteepness}, 64);
    for (std::size_t i = 0; i < kSamples; ++i) {
        ASSERT_EQ(mixed[4 * i], s.channel(height)[i]);
        ASSERT_EQ(mixed[4 * i + 1], -2.0f * s.channel(kSteepness)[i]);
        ASSERT_EQ(mixed[4 * i + 2], -7.0f);
        ASSERT_EQ(mixed[4 * i + 3], 3.0f * s.channel(height)[i]);
    }
}

TEST_P(HostChannels, CloseTheSeamOfAPeriod) {
    using enum Channel;
    Ocean sea = ocean();
    constexpr std::size_t kSide = 64;
    constexpr std::size_t kPitch = 3 * (kSide + 1) + 5;
    const Surface s = sea.evaluate(1.0, {height, kSteepness}, kSide);
    std::vector<float> expected((kSide + 1) * kPitch, -7.0f);
    for (const auto [i, j] : test::pairs<std::size_t>(kSide + 1, kSide + 1)) {
        const std::size_t sample = j % kSide * kSide + i % kSide;
        expected[j * kPitch + 3 * i] = s.channel(kSteepness)[sample];
        expected[j * kPitch + 3 * i + 2] = -s.channel(height)[sample];
    }
    std::vector<float> closed(expected.size(), -7.0f);
    MapOutput output{closed.data(), 3, {{{kSteepness, 1.0f}, {}, {height, -1.0f}}}, kPitch, true};
    sea.evaluate_into(1.0, {&output, 1}, kSide);
    EXPECT_EQ(closed, expected);

    std::vector<float> tight(3 * (kSide + 1) * (kSide + 1), -7.0f);
    output.data = tight.data();
    output.row_pitch = 0;
    sea.evaluate_into(1.0, {&output, 1}, kSide);
    for (const auto [i, j, at] : test::cells<std::size_t>(3 * (kSide + 1), kSide + 1)) {
        ASSERT_EQ(tight[at], expected[j * kPitch + i]);
    }
}

TEST_P(HostChannels, KnowTheChoppiness) {
    Parameters parameters = stormy_sea();
    parameters.surface.choppiness = 0.0;
    const Surface flat = ocean(parameters).evaluate(2.0, {kSpread, kSteepness});
    EXPECT_EQ(test::variance(flat.channel(kSpread)), 0.0);
    EXPECT_GT(test::variance(flat.channel(kSteepness)), 0.0);
}

TEST_P(HostChannels, ThatHaveNoRowAreRefused) {
    Ocean sea = ocean();
    for (const Channel channel : {kNone, static_cast<Channel>(kMaxChannels - 1),
                                  static_cast<Channel>(kMaxChannels), static_cast<Channel>(-5)}) {
        EXPECT_THROW(sea.evaluate(0.0, {Channel::height, channel}), Error);
        float value = 0.0f;
        const MapOutput output{&value, 1, {{{channel, 1.0f}}}};
        EXPECT_THROW(sea.evaluate_into(0.0, {&output, 1}), Error);
        EXPECT_EQ(value, 0.0f);
    }
    EXPECT_THROW(Ocean(stormy_sea()).evaluate(0.0, {kSteepness}), Error);
}

TEST_P(HostChannels, OfACopyAreItsOwn) {
    Ocean built = ocean();
    built.evaluate(0.0, {kSteepness});
    Ocean copy(built,
               {.threads = 1, .backend = GetParam(), .channels = std::span(kFurther).last(1)});
    EXPECT_NO_THROW(copy.evaluate(0.0, {kSteepness}));  // its first row: old
    EXPECT_THROW(copy.evaluate(0.0, {kEast}), Error);
    EXPECT_EQ(copy.stage_runs().modes, 0);
    EXPECT_EQ(copy.stage_runs().packing, 0);
}

INSTANTIATE_TEST_SUITE_P(Backends, HostChannels,
                         testing::Values(Backend::cpu, Backend::radix2, Backend::dft),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Channels, WithoutCodeOfABackendAreMadeOfItsLinearFields) {
    for (const Backend& backend : core_backends()) {
        Backend bare = backend;
        bare.makes = {};
        for (const double choppiness : {0.0, 1.3}) {
            Parameters parameters = stormy_sea();
            parameters.surface.choppiness = choppiness;
            const ChannelSet asked = test::kAllChannels | Channel::foam;
            const Surface own = Ocean(parameters, {.backend = backend}).evaluate(5.0, asked);
            const Surface made = Ocean(parameters, {.backend = bare}).evaluate(5.0, asked);
            for (const Channel channel : test::channels_of(own)) {
                EXPECT_LE(test::largest_difference(own.channel(channel), made.channel(channel)),
                          2e-5)
                    << backend.name << ' ' << channel_info(channel).name;
            }
        }
    }
}

TEST(Channels, OfAFormulaThatReadsMoreThanItsRowSaysAreNotANumber) {
    static constexpr ChannelInfo kSloppy[] = {
        {"sloppy",
         "",
         kGradients,
         {},
         [](const auto& p) { return channel_formula::whitecap_of(p); }},
        {"sloppier",
         "",
         kGradients,
         {},
         [](const auto& p) { return p.previous_foam + channel_formula::whitecap_of(p); },
         FoamUse::threshold},
        {"sloppiest", "", kSlopes, kSlopes, [](const auto& p) { return p[Linear::height]; }}};
    Ocean sea(stormy_sea(), {.channels = kSloppy});
    const Surface s = sea.evaluate(0.0, {kSteepness, kEast, kSpread});
    for (const Channel channel : {kSteepness, kEast, kSpread}) {
        EXPECT_TRUE(std::isnan(s.channel(channel).front()));
    }
}

TEST(Channels, HaveTheNamesOfTheirEnumerators) {
    EXPECT_EQ(channel_info(Channel::dx).name, "dx");
    EXPECT_EQ(channel_info(Channel::slope_y).name, "slope_y");
    EXPECT_EQ(channel_info(Channel::vz).name, "vz");
    EXPECT_EQ(channel_info(kEast, kFurther).name, "east");
}

TEST(Products, AreFoundByNameAmongThoseThatThereAre) {
    EXPECT_EQ(find_product("velocity").unit, "m/s");
    EXPECT_EQ(find_product("normal").set(), (ChannelSet{Channel::nx, Channel::ny, Channel::nz}));
    EXPECT_THROW(find_product("steepness"), Error);
    std::vector<Product> products(kProducts.begin(), kProducts.end());
    products.push_back({"steepness", {kSteepness}, 1, ""});
    EXPECT_EQ(find_product("steepness", products).channels[0], kSteepness);
    EXPECT_EQ(test::message_of([&] { find_product("steep", products); }),
              "unknown product 'steep'; did you mean steepness?; known: height, "
              "displacement, slope, normal, jacobian, whitecap, foam, velocity, "
              "derivatives, cover, steepness");
}

/// Image files whose options leave the type open store float for products that move geometry, else
/// half.
TEST(Products, StateHowFilesKeepThem) {
    std::string full, always, of_halves;
    for (const Product& product : kProducts) {
        const std::string name = " " + std::string(product.name);
        if (product.precision == Precision::full) full += name;
        if (product.run_lengths == RunLengths::always) always += name;
        if (product.run_lengths == RunLengths::of_halves) of_halves += name;
    }
    EXPECT_EQ(full, " displacement velocity");
    EXPECT_EQ(always, " slope whitecap foam cover");
    EXPECT_EQ(of_halves, " normal jacobian derivatives");
}

TEST(Backends, AreFoundByName) {
    EXPECT_EQ(find_backend("dft"), Backend::dft);
    EXPECT_THROW(find_backend("gl"), Error);
    EXPECT_THROW(find_backend("gpu"), Error);
}

}  // namespace
}  // namespace ocean
