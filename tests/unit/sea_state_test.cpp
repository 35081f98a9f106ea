// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The statistics of `ocean info`.
#include "ocean/sea_state.hpp"

#include "ocean/enum_words.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/parameter_table.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

TEST(SeaState, AskedAndResolvedAgreeOnAGoodGrid) {
    const SeaState state = test::state_of(test::wind_sea(512, 800.0));
    EXPECT_NEAR(state.significant_wave_height.asked, 2.0131, 5e-5);
    EXPECT_NEAR(state.significant_wave_height.resolved, 2.0131, 0.01);
    EXPECT_NEAR(state.peak_period.asked, kTwoPi / 1.03912, 1e-3);
    EXPECT_NEAR(state.peak_period.resolved, kTwoPi / 1.03912, 0.2);
    // The closed formula of JONSWAP with gamma 3.3, integrated to 30 fp: Te and Tm01 over Tp.
    EXPECT_NEAR(state.energy_period.asked / state.peak_period.asked, 0.9033, 5e-4);
    EXPECT_NEAR(state.mean_period.asked / state.peak_period.asked, 0.8344, 2e-3);
    EXPECT_NEAR(state.energy_period.resolved, state.energy_period.asked, 0.05);
    EXPECT_NEAR(state.mean_period.resolved, state.mean_period.asked, 0.05);
    EXPECT_NEAR(state.peak_wavelength.asked, kTwoPi * 9.81 / (1.03912 * 1.03912), 0.05);
    EXPECT_NEAR(state.mean_direction.asked, 30.0, 0.01);
    EXPECT_NEAR(state.mean_direction.resolved, 30.0, 1.0);
    EXPECT_NEAR(state.directional_spread.resolved, state.directional_spread.asked, 0.3);
    EXPECT_GT(state.energy_resolved, 0.99);
    EXPECT_TRUE(state.warnings.empty()) << state.warnings.front();
    EXPECT_EQ(state.period, 800.0);
    EXPECT_NEAR(state.foam_preroll_seconds, 25.0, 1e-9);
}

TEST(SeaState, ReportsWhatALoopDoesToTheSpeedOfEachWavelength) {
    Parameters parameters = test::wind_sea(256, 400.0);
    EXPECT_TRUE(test::state_of(parameters).loop_errors.empty());
    EXPECT_EQ(test::state_of(parameters).loop_error, 0.0);
    parameters.time.loop_period = 10.0;
    const SeaState state = test::state_of(parameters);
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
    EXPECT_LT(test::state_of(parameters).loop_error, state.loop_error / 30.0);
    parameters.time.loop_period = 3.0;
    EXPECT_TRUE(test::says(test::state_of(parameters).warnings, "time.loop_period"));
    parameters.time.loop_period = 1000.0;
    EXPECT_FALSE(test::says(test::state_of(parameters).warnings, "time.loop_period"));
}

TEST(SeaState, WarnsOfAGridThatIsTooSmallOrTooCoarse) {
    EXPECT_LT(test::state_of(test::wind_sea(512, 20.0)).energy_resolved, 0.9);
    EXPECT_FALSE(test::state_of(test::wind_sea(512, 20.0)).warnings.empty());
    EXPECT_FALSE(test::state_of(test::wind_sea(32, 4000.0)).warnings.empty());
}

TEST(SeaState, WarnsOfWavesTooHighForTheirDepth) {
    Parameters parameters = test::wind_sea(64, 200.0, {.height = 3.0, .depth = 5.01});
    EXPECT_FALSE(test::says(test::state_of(parameters).warnings, "water.depth"));
    parameters.water.depth = 4.99;
    EXPECT_TRUE(test::says(test::state_of(parameters).warnings, "water.depth"));
    // Depth-limited by its own spectrum.
    parameters.waves.front().significant_wave_height.reset();
    parameters.waves.front().spectrum = SpectrumKind::tma;
    EXPECT_FALSE(test::says(test::state_of(parameters).warnings, "water.depth"));
}

Parameters fetch_limited(double wind, double fetch, SpectrumKind kind = SpectrumKind::jonswap) {
    Parameters parameters;
    WaveSystem& system = parameters.waves.front();
    system.spectrum = kind;
    system.wind_speed = wind;
    system.fetch = fetch;
    return parameters;
}

std::string development_warning(const Parameters& parameters) {
    const std::vector<std::string> warnings = full_development_warnings(parameters);
    EXPECT_LE(warnings.size(), 1u);
    return warnings.empty() ? "" : warnings.front();
}

// Pierson and Moskowitz: m0 = 8.1e-3 (1.026 U)^4 / (4 * 0.74 g^2), 0.561 m at 5 m/s and 0.0225 m
// at 1 m/s. JONSWAP with gamma = 3.3 has that at chi = g F/U^2 = 1.196e4: 30.5 km and 1.22 km.
TEST(SeaState, WarnsOfAFetchBeyondFullDevelopmentWithBothHeights) {
    const std::string five = development_warning(fetch_limited(5.0, 300e3));
    EXPECT_TRUE(test::says(five, {"waves.0.fetch = 300000 m", "a wind of 5 m/s", "1.97 m",
                                  "0.561 m", "30500 m", "waves.0.significant_wave_height"}));
    Parameters tma = fetch_limited(1.0, 300e3, SpectrumKind::tma);
    tma.water.depth = 40.0;
    const std::string one = development_warning(tma);
    EXPECT_TRUE(test::says(one, {"0.464 m", "0.0225 m", "1220 m"}));
    EXPECT_TRUE(test::says(test::state_of(tma).warnings, "full development"));
    EXPECT_FALSE(test::says(test::state_of(test::wind_sea()).warnings, "full development"));
}

TEST(SeaState, AFetchOfFullDevelopmentGivesTheHeightThatTheWarningNames) {
    for (const double gamma : {1.0, 3.3, 7.0}) {
        for (const double gravity : {3.7, 9.81}) {
            Parameters parameters = fetch_limited(12.0, 1e6);
            parameters.water.gravity = gravity;
            parameters.waves.front().peak_enhancement = gamma;
            const std::string text = development_warning(parameters);
            const std::size_t at = text.find("from a fetch of ");
            ASSERT_NE(at, std::string::npos) << text;
            parameters.waves.front().fetch = std::stod(text.substr(at + 16));
            const double height = make_directional_spectrum(parameters)
                                      .moments(parameters.water)
                                      .significant_wave_height();
            const double wind = 1.026 * 12.0;
            const double developed = 4.0 * std::sqrt(8.1e-3 / 2.96) * wind * wind / gravity;
            EXPECT_NEAR(height / developed, 1.0, 3e-3) << text;
            EXPECT_EQ(development_warning(parameters), "");
        }
    }
}

// A quarter of the energy is the scatter of fully developed seas, (3.6 +- 0.9)e-3 [Young 1999]. The
// energy is proportional to chi^1.1 [Hasselmann 1973].
TEST(SeaState, WarnsOfMoreThanTheScatterOfFullyDevelopedSeas) {
    const double limit = 1.196e4 * 100.0 / 9.81 * std::pow(1.25, 1.0 / 1.1);
    EXPECT_EQ(development_warning(fetch_limited(10.0, 0.99 * limit)), "");
    EXPECT_NE(development_warning(fetch_limited(10.0, 1.01 * limit)), "");
}

// The peak of Pierson and Moskowitz at 5 m/s: 2 pi 1.026 * 5 / (0.8772 * 9.81) = 3.75 s; that of
// JONSWAP over 300 km: 6.86 s. They meet at chi = 1.88e4: 48 km.
TEST(SeaState, WarnsOfThePeriodAloneWhereTheHeightIsGiven) {
    Parameters parameters = fetch_limited(5.0, 300e3);
    WaveSystem& system = parameters.waves.front();
    system.significant_wave_height = 0.5;
    const std::string text = development_warning(parameters);
    EXPECT_TRUE(
        test::says(text, {"a peak period of 6.86 s", "3.75 s", "47900 m", "waves.0.peak_period"}));
    EXPECT_FALSE(test::says(text, "significant"));
    system.fetch = 60e3;
    EXPECT_EQ(development_warning(parameters), "") << "8 % of the period, within its scatter";
    system.fetch = 300e3;
    system.peak_period = 9.0;
    EXPECT_EQ(development_warning(parameters), "") << "swell: nothing follows from the fetch";
    system.significant_wave_height.reset();
    EXPECT_TRUE(test::says(development_warning(parameters),
                           "1.97 m, where a fully developed sea has 0.561 m"))
        << "the period alone is given";
}

TEST(SeaState, NamesTheWaveSystemWhoseFetchIsTooLong) {
    Parameters parameters = fetch_limited(15.0, 300e3);
    parameters.waves.push_back(fetch_limited(4.0, 300e3).waves.front());
    parameters.waves.push_back(parameters.waves.back());
    const std::vector<std::string> warnings = full_development_warnings(parameters);
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_EQ(warnings[0].find("waves.1.fetch"), 0u);
    EXPECT_EQ(warnings[1].find("waves.2.fetch"), 0u);
}

TEST(SeaState, SpectraWithoutFetchAndSeasWithoutWindAreNotBeyondFullDevelopment) {
    for (const SpectrumKind kind : {SpectrumKind::phillips, SpectrumKind::pierson_moskowitz}) {
        EXPECT_EQ(development_warning(fetch_limited(5.0, 1e7, kind)), "");
    }
    EXPECT_EQ(development_warning(fetch_limited(0.0, 1e7)), "");
    EXPECT_NE(development_warning(fetch_limited(1e-5, 1e7)), "") << "finite numbers";
    EXPECT_EQ(development_warning(fetch_limited(75.0, 1e6)), "");
}

// At a depth of 2 m waves grow less with the fetch: 300 km, of 274 km of full development, give
// 1.35 m, and 3000 km 2.27 m, where the deep formulas give 5.2 m and 18 m.
TEST(SeaState, ShallowWaterIsComparedWithAFullyDevelopedSeaOfItsDepth) {
    Parameters parameters = fetch_limited(15.0, 300e3, SpectrumKind::tma);
    parameters.water.depth = 2.0;
    EXPECT_EQ(development_warning(parameters), "");
    parameters.waves.front().fetch = 3e6;
    const std::string text = development_warning(parameters);
    EXPECT_TRUE(test::says(text, "2.27 m, where a fully developed sea has 1.33 m"));
    parameters.waves.front().fetch = 1.196e4 * 225.0 / 9.81;
    const double developed =
        make_directional_spectrum(parameters).moments(parameters.water).significant_wave_height();
    EXPECT_NEAR(developed, 1.33, 0.005);
}

// A take that lets the wind fall leaves the fetch: the warning is that of the moment, and a gliding
// spreading, which has two shares of one wave system, gives one.
TEST(SeaState, WarnsOfTheMomentOfATake) {
    Sea sea;
    sea.parameters = fetch_limited(20.0, 300e3);
    sea.take.events = {
        {10.0, find_parameter("wind_speed"), 5.0},
        {10.0, find_parameter("spreading"), std::string("hasselmann")},
    };
    EXPECT_EQ(development_warning(sea.at(9.0)), "");
    ASSERT_EQ(sea.at(10.5).waves.size(), 2u);
    EXPECT_NE(development_warning(sea.at(10.5)), "");
    EXPECT_TRUE(test::says(development_warning(sea.at(60.0)), "a wind of 5 m/s"));
}

TEST(SeaState, TheFoldedShareIsThatOfTheMapsAndWarnsFromOnePercent) {
    Parameters parameters = test::wind_sea(128, 200.0);
    const auto state = [&] { return Ocean(parameters, {.threads = 1}).state(); };
    EXPECT_LT(state().folded_share, 1e-10);
    EXPECT_FALSE(test::says(state().warnings, "folded over"));

    parameters.surface.choppiness = 4.0;
    double folded = 0.0, samples = 0.0;
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
    EXPECT_EQ(bool(test::says(state().warnings, "folded over")), share > 0.01) << share;

    parameters.water.depth = 3.0;
    EXPECT_GT(state().folded_share, 0.01);
    EXPECT_TRUE(test::says(state().warnings, "folded over"));
}

TEST(SeaState, BandLimitsCountAsAskedFor) {
    Parameters parameters = test::wind_sea(256, 400.0);
    parameters.surface.shortest_wavelength = 20.0;
    const SeaState state = test::state_of(parameters);
    EXPECT_LT(state.significant_wave_height.asked, 1.99);
    EXPECT_NEAR(state.energy_resolved, 1.0, 0.02);
    EXPECT_GE(state.shortest_wave, 20.0);
}

TEST(SeaState, SlopesOfACoarserMapAreThoseOfACoarserGrid) {
    const SeaState state = test::state_of(test::wind_sea(256, 400.0));
    ASSERT_EQ(state.map_slopes.size(), 14u);
    for (const MapSlope& map : state.map_slopes) {
        if (map.resolution < kMinResolution || map.resolution > 256) continue;
        const double expected =
            test::state_of(test::wind_sea(map.resolution, 400.0)).mean_square_slope.resolved;
        EXPECT_NEAR(map.mean_square_slope, expected, 1e-9 * expected) << map.resolution;
    }
    EXPECT_EQ(state.map_slopes.front().mean_square_slope, 0.0);
    EXPECT_NEAR(state.map_slopes.back().mean_square_slope, state.mean_square_slope.resolved, 1e-12);

    // 64 samples of 100 m hold the same waves as 256 of 400 m.
    Parameters cascades = test::wind_sea(64, 400.0, {.cascades = 2});
    cascades.grid.cascade_divisors = {1, 4};
    const SeaState both = test::state_of(cascades);
    EXPECT_NEAR(both.map_slopes[8].mean_square_slope, both.mean_square_slope.resolved, 1e-12);
    EXPECT_LT(both.map_slopes[7].mean_square_slope, 0.95 * both.mean_square_slope.resolved);
}

TEST(SeaState, AFlatSeaHasNumbersToo) {
    Parameters parameters = test::wind_sea(128, 400.0, {.wind = 0.0});
    const SeaState state = test::state_of(parameters);
    EXPECT_EQ(state.significant_wave_height.asked, 0.0);
    EXPECT_EQ(state.peak_period.asked, 0.0);
    EXPECT_FALSE(test::says(sea_state_json(state), "nan"));
    EXPECT_FALSE(test::says(sea_state_json(state), "inf"));
    ASSERT_EQ(state.warnings.size(), 1u);
}

TEST(SeaState, ParametersCountForTheSpectraThatTheTableSaysUseThem) {
    const auto numbers = [](const Parameters& parameters) {
        const SeaState state = test::state_of(parameters);
        return std::array{state.significant_wave_height.asked, state.mean_square_slope.asked,
                          state.directional_spread.asked};
    };
    std::size_t tried = 0;
    for (const ParameterInfo& info : parameter_table()) {
        if (!info.in_list() || info.used_by.empty() || info.type() == "text") continue;
        if (info.key == "estimator") continue;  // for measured directions only
        for (const std::string_view kind : kEnumWords<SpectrumKind>) {
            if (kind == word_of(SpectrumKind::measured)) continue;
            Parameters parameters = test::wind_sea(64, 200.0);
            parameters.water.depth = 20.0;            // for tma
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
    EXPECT_TRUE(test::says(json, R"("warnings": ["a \"b\"\u000A", "c"])"));
    state.period = std::numeric_limits<double>::infinity();
    EXPECT_THROW(sea_state_json(state), Error);
}

TEST(SeaState, MoreMemoryThanThereIsIsSaidBeforehand) {
    EXPECT_NO_THROW(require_memory(1 << 20, "a little"));
    const auto refusal =
        test::refusal_of([] { require_memory(std::uint64_t{1} << 60, "the whole sea"); });
    EXPECT_EQ(refusal.kind, ErrorKind::out_of_memory);
    EXPECT_TRUE(test::says(refusal.message, "the whole sea needs"));
}

}  // namespace
}  // namespace ocean
