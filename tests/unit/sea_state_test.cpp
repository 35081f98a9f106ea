// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What `ocean info` says of a sea.
#include "ocean/sea_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/memory.hpp"
#include "ocean/parameter_table.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

SeaState state_of(const Parameters& parameters) {
    ThreadPool pool(2);
    return sea_state(make_directional_spectrum(parameters), parameters, pool);
}

bool warns(const SeaState& state, std::string_view of) {
    return std::any_of(state.warnings.begin(), state.warnings.end(),
                       [&](const std::string& text) { return text.find(of) != std::string::npos; });
}

TEST(SeaState, AskedAndResolvedAgreeOnAGoodGrid) {
    const SeaState state = state_of(test::wind_sea(512, 800.0));
    EXPECT_NEAR(state.significant_wave_height.asked, 2.0131, 5e-5);
    EXPECT_NEAR(state.significant_wave_height.resolved, 2.0131, 0.01);
    EXPECT_NEAR(state.peak_period.asked, kTwoPi / 1.03912, 1e-3);
    EXPECT_NEAR(state.peak_period.resolved, kTwoPi / 1.03912, 0.2);
    // Over JONSWAP of gamma 3.3: Te = 0.906 Tp and Tm01 = 0.834 Tp [DNV-RP-C205, 3.5.5.4].
    EXPECT_NEAR(state.energy_period.asked, 0.906 * state.peak_period.asked, 0.01);
    EXPECT_NEAR(state.mean_period.asked, 0.834 * state.peak_period.asked, 0.02);
    EXPECT_NEAR(state.energy_period.resolved, state.energy_period.asked, 0.05);
    EXPECT_NEAR(state.mean_period.resolved, state.mean_period.asked, 0.05);
    EXPECT_NEAR(state.peak_wavelength.asked, kTwoPi * 9.81 / (1.03912 * 1.03912), 0.05);
    EXPECT_NEAR(state.mean_direction.asked, 30.0, 0.01);
    EXPECT_NEAR(state.mean_direction.resolved, 30.0, 1.0);
    EXPECT_GT(state.energy_resolved, 0.99);
    EXPECT_TRUE(state.warnings.empty()) << state.warnings.front();
    EXPECT_EQ(state.period, 800.0);
    EXPECT_NEAR(state.foam_preroll_seconds, 25.0, 1e-9);
}

TEST(SeaState, DirectionalSpreadIsTheCircularDeviation) {
    Parameters parameters = test::wind_sea(512, 800.0);
    parameters.waves.front().spreading = SpreadingKind::cosine_squared;
    const SeaState state = state_of(parameters);
    const double r1 = 8.0 / (3.0 * kPi);  // of 2/pi cos^2
    const double spread = std::sqrt(2.0 * (1.0 - r1)) * 180.0 / kPi;
    EXPECT_NEAR(state.directional_spread.asked, spread, 0.01);
    EXPECT_NEAR(state.directional_spread.resolved, spread, 0.3);
}

TEST(SeaState, ReportsWhatALoopDoesToTheSpeedOfEachWavelength) {
    Parameters parameters = test::wind_sea(256, 400.0);
    EXPECT_TRUE(state_of(parameters).loop_errors.empty());
    EXPECT_EQ(state_of(parameters).loop_error, 0.0);
    parameters.time.loop_period = 10.0;
    const SeaState state = state_of(parameters);
    ASSERT_GT(state.loop_errors.size(), 5u);
    EXPECT_EQ(state.loop_errors.front().wavelength, state.longest_wave);
    for (const LoopError& error : state.loop_errors) {
        // Deep water: c = sqrt(g lambda / 2 pi); in the loop a wave passes its own length a whole
        // number of times.
        const double c = std::sqrt(9.81 * error.wavelength / kTwoPi);
        const double turns = std::max(1.0, std::round(10.0 * c / error.wavelength));
        EXPECT_NEAR(error.speed_error, turns * error.wavelength / 10.0 / c - 1.0, 1e-4)
            << error.wavelength;
    }
    EXPECT_GT(state.loop_error, 0.02);
    parameters.time.loop_period = 1000.0;
    EXPECT_LT(state_of(parameters).loop_error, state.loop_error / 30.0);
    parameters.time.loop_period = 3.0;
    EXPECT_TRUE(warns(state_of(parameters), "time.loop_period"));
    parameters.time.loop_period = 1000.0;
    EXPECT_FALSE(warns(state_of(parameters), "time.loop_period"));
}

TEST(SeaState, WarnsOfAGridThatIsTooSmallOrTooCoarse) {
    EXPECT_LT(state_of(test::wind_sea(512, 20.0)).energy_resolved, 0.9);
    EXPECT_FALSE(state_of(test::wind_sea(512, 20.0)).warnings.empty());
    EXPECT_FALSE(state_of(test::wind_sea(32, 4000.0)).warnings.empty());
}

TEST(SeaState, WarnsOfWavesTooHighForTheirDepth) {
    Parameters parameters = test::wind_sea(64, 200.0);
    parameters.waves.front().significant_wave_height = 3.0;
    parameters.water.depth = 5.01;
    EXPECT_FALSE(warns(state_of(parameters), "water.depth"));
    parameters.water.depth = 4.99;
    EXPECT_TRUE(warns(state_of(parameters), "water.depth"));
    // Depth-limited by its own spectrum.
    parameters.waves.front().significant_wave_height.reset();
    parameters.waves.front().spectrum = SpectrumKind::tma;
    EXPECT_FALSE(warns(state_of(parameters), "water.depth"));
}

TEST(SeaState, TheFoldedShareIsThatOfTheMapsAndWarnsFromOnePercent) {
    Parameters parameters = test::wind_sea(128, 200.0);
    const auto state = [&] { return Ocean(parameters, {.threads = 1}).state(); };
    EXPECT_LT(state().folded_share, 1e-10);
    EXPECT_FALSE(warns(state(), "folded over"));

    parameters.surface.choppiness = 4.0;
    double folded = 0.0;
    double samples = 0.0;
    for (parameters.seed = 1; parameters.seed <= 16; ++parameters.seed) {
        const Surface surface =
            Ocean(parameters, {.threads = 1}).evaluate(7.0, {Channel::jacobian});
        for (const float jacobian : surface.channel(Channel::jacobian)) {
            folded += jacobian < 0.0f ? 1.0 : 0.0;
            samples += 1.0;
        }
    }
    const double share = state().folded_share;
    EXPECT_NEAR(share, folded / samples, 0.06 * share);
    EXPECT_EQ(warns(state(), "folded over"), share > 0.01) << share;

    parameters.water.depth = 3.0;
    EXPECT_GT(state().folded_share, 0.01);
    EXPECT_TRUE(warns(state(), "folded over"));
}

TEST(SeaState, BandLimitsCountAsAskedFor) {
    Parameters parameters = test::wind_sea(256, 400.0);
    parameters.surface.shortest_wavelength = 20.0;
    const SeaState state = state_of(parameters);
    EXPECT_LT(state.significant_wave_height.asked, 1.99);
    EXPECT_NEAR(state.energy_resolved, 1.0, 0.02);
    EXPECT_GE(state.shortest_wave, 20.0);
}

TEST(SeaState, SlopesOfACoarserMapAreThoseOfACoarserGrid) {
    const SeaState state = state_of(test::wind_sea(256, 400.0));
    ASSERT_EQ(state.map_slopes.size(), 14u);
    for (const MapSlope& map : state.map_slopes) {
        if (map.resolution < kMinResolution || map.resolution > 256) continue;
        const double expected =
            state_of(test::wind_sea(map.resolution, 400.0)).mean_square_slope.resolved;
        EXPECT_NEAR(map.mean_square_slope, expected, 1e-9 * expected) << map.resolution;
    }
    EXPECT_EQ(state.map_slopes.front().mean_square_slope, 0.0);
    EXPECT_NEAR(state.map_slopes.back().mean_square_slope, state.mean_square_slope.resolved, 1e-12);

    // 64 samples of 100 m hold what 256 of 400 m do.
    Parameters cascades = test::wind_sea(64, 400.0);
    cascades.grid.cascades = 2;
    cascades.grid.cascade_divisors = {1, 4};
    const SeaState both = state_of(cascades);
    EXPECT_NEAR(both.map_slopes[8].mean_square_slope, both.mean_square_slope.resolved, 1e-12);
    EXPECT_LT(both.map_slopes[7].mean_square_slope, 0.95 * both.mean_square_slope.resolved);
}

TEST(SeaState, AFlatSeaHasNumbersToo) {
    Parameters parameters = test::wind_sea();
    parameters.waves.front().wind_speed = 0.0;
    const SeaState state = state_of(parameters);
    EXPECT_EQ(state.significant_wave_height.asked, 0.0);
    EXPECT_EQ(state.peak_period.asked, 0.0);
    EXPECT_EQ(sea_state_json(state).find("nan"), std::string::npos);
    EXPECT_EQ(sea_state_json(state).find("inf"), std::string::npos);
    ASSERT_EQ(state.warnings.size(), 1u);
}

TEST(SeaState, ParametersCountForTheSpectraThatTheTableSaysUseThem) {
    const auto numbers = [](const Parameters& parameters) {
        const SeaState state = state_of(parameters);
        return std::array{state.significant_wave_height.asked, state.mean_square_slope.asked,
                          state.directional_spread.asked};
    };
    std::size_t tried = 0;
    for (const ParameterInfo& info : parameter_table()) {
        if (!info.per_wave_system() || info.used_by.empty() || info.type() == "text") continue;
        if (info.key == "estimator") continue;  // of measured directions
        for (const std::string_view kind : kEnumWords<SpectrumKind>) {
            if (kind == word_of(SpectrumKind::measured)) continue;
            Parameters parameters = test::wind_sea(64, 200.0);
            parameters.water.depth = 20.0;            // of tma
            parameters.waves.front().opposing = 0.0;  // so that directions have a mean
            set_parameter(parameters, "waves.0.spectrum", kind);
            const auto before = numbers(parameters);
            const std::string_view other = info.type() == "enum"  ? "mitsuyasu"
                                           : info.type() == "int" ? "10"
                                                                  : "4000";
            set_parameter(parameters, info.path(),
                          info.max < 4000.0 && info.type() == "float" ? "7" : other);
            const auto after = numbers(parameters);
            const bool counts = !std::ranges::equal(
                before, after, [](double a, double b) { return std::abs(a - b) < 1e-6 * a; });
            EXPECT_EQ(counts, info.used_by.find(kind) != std::string_view::npos)
                << info.key << ", " << kind;
            ++tried;
        }
    }
    EXPECT_EQ(tried, 6 * (enum_count<SpectrumKind>() - 1));
}

TEST(SeaState, JsonHoldsAnyWarningAndNoNumberThatJsonLacks) {
    SeaState state;
    state.warnings = {"a \"b\"\n", "c"};
    const std::string json = sea_state_json(state);
    EXPECT_NE(json.find(R"("warnings": ["a \"b\"\u000A", "c"])"), std::string::npos) << json;
    state.period = std::numeric_limits<double>::infinity();
    EXPECT_THROW(sea_state_json(state), Error);
}

TEST(SeaState, MoreMemoryThanThereIsIsSaidBeforehand) {
    EXPECT_NO_THROW(require_memory(1 << 20, "a little"));
    try {
        require_memory(std::uint64_t{1} << 60, "the whole sea");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::out_of_memory);
        EXPECT_NE(std::string(error.what()).find("the whole sea needs"), std::string::npos);
    }
}

}  // namespace
}  // namespace ocean
