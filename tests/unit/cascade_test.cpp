// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Cascades: the energy does not depend on their number, no wave appears twice or is missing, and
// small maps add up to the one surface.
#include "ocean/internal/cascades.hpp"

#include <cstdint>

#include "ocean/internal/cascade_map.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/map_request.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"
#include "wave/wave.hpp"
#include "waves/labels/open_surface.hpp"
#include "waves/query/query_bounds.hpp"
#include "waves/surface/plane_channels.hpp"

namespace ocean {
namespace {

/// A sea of `divisors.size()` cascades with waves down to patch / (resolution/2 * last divisor).
Parameters cascade_sea(int resolution, double patch, std::vector<int> divisors) {
    Parameters parameters =
        test::wind_sea(resolution, patch, {.cascades = static_cast<int>(divisors.size())});
    parameters.grid.cascade_divisors = std::move(divisors);
    return parameters;
}

double squared(double x) {
    return x * x;
}

/// A map of all cascades has one rate for each of its modes, whichever cascade has the waves. Loops
/// that leave a shared mode's turns between two whole numbers: one last bit more is one turn more.
TEST(Cascades, AgreeToTheBitOnTheModesThatTheyShare) {
    Parameters parameters = cascade_sea(64, 500.0, {1, 3, 7});
    const double omega = Dispersion(parameters.water).at(3 * kTwoPi / 500.0).angular_frequency;
    const double tie = 7.5 * kTwoPi / omega;
    for (const double loop : {0.0, std::nextafter(tie, 0.0), tie, std::nextafter(tie, 1e9)}) {
        parameters.time.loop_period = loop;
        const Modes modes = test::modes_of(parameters);
        const CascadeModes& first = modes.cascades.front();
        int shared = 0;
        for (const CascadeModes& cascade : modes.cascades) {
            const int half = half_of(64, cascade.divisor, 64);
            for (const auto [n, m] : test::pairs({-half + 1, half}, {-half + 1, half})) {
                const std::size_t own = mode_index(n, m, 64);
                const std::size_t at = mode_index(n * cascade.divisor, m * cascade.divisor, 64);
                ASSERT_EQ(cascade.rate_high[own], first.rate_high[at]) << loop;
                ASSERT_EQ(cascade.rate_low[own], first.rate_low[at]) << loop;
                ASSERT_EQ(cascade.displacement[own], first.displacement[at]) << loop;
                ++shared;
            }
        }
        EXPECT_EQ(shared, 63 * 63 + 21 * 21 + 9 * 9);
    }
}

TEST(Cascades, ChosenOnesHoldWhatTheSpectrumHasOnEveryGrid) {
    for (const int resolution : {32, 64, 128, 256}) {
        for (int cascades = 2; cascades <= 5; ++cascades) {
            Parameters parameters = test::wind_sea(resolution, 1500.0, {.cascades = cascades});
            const double shortest =
                1500.0 / (cascade_divisors(parameters.grid).back() * resolution / 2);
            parameters.surface.shortest_wavelength = shortest;
            const SpectralMoments asked =
                make_directional_spectrum(parameters).moments(parameters.water, shortest);
            const SeaState state = test::state_of(parameters);
            EXPECT_NEAR(squared(state.significant_wave_height.resolved / 4.0) / asked.m0, 1.0, 2e-3)
                << resolution << " samples, " << cascades << " cascades";
            // The slope is that of rings cut out of a lattice: coarse ones on a small grid.
            if (resolution < 128) continue;
            EXPECT_NEAR(state.mean_square_slope.resolved / asked.mean_square_slope, 1.0, 1e-2);
        }
    }
}

TEST(Cascades, EveryWaveOfThePatchBelongsToOneBandAtMostAndToOneInAll) {
    const Parameters parameters = cascade_sea(32, 500.0, {1, 2, 5});
    const auto bands = cascade_bands(parameters.grid);
    ASSERT_EQ(bands.size(), 3u);
    for (const auto [n, m] : test::pairs({-79, 80}, {-79, 80})) {
        int on_lattice = 0, rings = 0;
        for (const CascadeBand& band : bands) {
            const double length = std::hypot(n, m);
            rings += length >= band.inner && length < band.outer ? 1 : 0;
            if (n % band.divisor != 0 || m % band.divisor != 0) continue;
            on_lattice += band.contains(n / band.divisor, m / band.divisor) ? 1 : 0;
        }
        EXPECT_EQ(rings, 1) << n << ", " << m;
        EXPECT_LE(on_lattice, 1) << n << ", " << m;
    }
}

TEST(Cascades, HaveNoiseOfTheirOwn) {
    Parameters parameters = cascade_sea(128, 400.0, {1, 2});
    const Modes modes = test::modes_of(parameters);
    // Both seas have the same waves: mode (n, m) of the second lattice is (2n, 2m) of a finer one.
    parameters.grid = {256, 400.0, 1, {}};
    const Modes lone = test::modes_of(parameters);
    std::complex<double> product = 0.0;
    double a = 0.0, b = 0.0;
    for (const auto [n, m] : test::pairs({-63, 64}, {-63, 64})) {
        const std::complex<double> x = modes.cascades[1].h0[mode_index(n, m, 128)];
        if (std::norm(x) == 0.0) continue;
        for (const std::complex<double> y :
             {std::complex<double>(modes.cascades[0].h0[mode_index(n, m, 128)]),
              std::complex<double>(lone.cascades[0].h0[mode_index(2 * n, 2 * m, 256)])}) {
            product += x * std::conj(y);
            a += std::norm(x);
            b += std::norm(y);
        }
    }
    EXPECT_GT(a, 0.0);
    EXPECT_LT(std::abs(product) / std::sqrt(a * b), 0.05);
}

TEST(Cascades, WavesThatAMapHidesExcuseNoCoarseSpline) {
    Parameters parameters = cascade_sea(32, 4000.0, {1, 2, 5});
    parameters.waves.front().wind_speed = 15.0;
    const Modes modes = test::modes_of(parameters);
    constexpr int kShown = 64;
    const double hidden = query_bounds(modes, kShown, kMaxResolution, true, test::pool()).error;
    EXPECT_GT(hidden, 0.1);
    for (double tolerance = 0.5; tolerance > 1e-3; tolerance *= 0.8) {
        const double error = OpenSurface(modes, kShown, tolerance, test::pool()).height_error();
        EXPECT_LE(std::sqrt(error * error - hidden * hidden), tolerance);
    }
}

TEST(Cascades, TheModesHaveTheEnergyThatIsReported) {
    Parameters parameters = cascade_sea(32, 4000.0, {1, 2, 5});
    parameters.waves.front().wind_speed = 15.0;
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    const auto bands = cascade_bands(parameters.grid);
    const Modes modes = make_modes(spectrum, parameters, test::pool());
    double m0 = 0.0, most_scaled = 0.0;
    for (std::size_t c = 0; c < bands.size(); ++c) {
        double drawn = 0.0, unscaled = 0.0, variance = 0.0;
        for (const auto [n, m] : test::pairs({-15, 16}, {-15, 16})) {
            const double v = modal_variance(spectrum, parameters, n, m, bands[c]);
            const auto xi = wave::double_precision::gaussian_noise(
                parameters.seed, static_cast<std::uint32_t>(c), n, m);
            const std::size_t at = mode_index(n, m, 32);
            drawn += std::norm(modes.cascades[c].h0[at]);
            unscaled += 0.25 * v * (xi.re * xi.re + xi.im * xi.im);
            variance += v;
        }
        m0 += variance * drawn / unscaled;
        most_scaled = std::max(most_scaled, std::abs(drawn / unscaled - 1.0));
    }
    EXPECT_NEAR(16.0 * m0 / squared(test::state_of(parameters).significant_wave_height.resolved),
                1.0, 1e-5);
    EXPECT_GT(most_scaled, 1e-3) << "no ring needs to be scaled: the test would see nothing";
}

TEST(Cascades, TheMapIsTheSumOfTheSmallMaps) {
    // A map of 512 samples holds every mode of 3 cascades of 64 samples, 5 to the last.
    const Parameters parameters = cascade_sea(64, 700.0, {1, 3, 7});
    ASSERT_EQ(complete_map_resolution(parameters.grid), 512);
    constexpr int kSize = 512;
    constexpr double kTime = 77.7;
    Ocean sea(parameters, {.threads = 2});
    const Surface map = sea.evaluate(kTime, test::kAllChannels, kSize);

    LinearPlanes<float> sums;
    for (const Linear field : kLinears) sums[field].assign(std::size_t{kSize} * kSize, 0.0f);
    for (std::size_t c = 0; c < 3; ++c) {
        CascadeMap map_of_cascade(c, kSize);
        const LinearPlanes<float>& small =
            map_of_cascade.planes(sea.modes(), kTime, fields_of(test::kAllChannels), test::pool());
        const int divisor = sea.modes().cascades[c].divisor;
        for (const Linear field : kLinears) {
            for (const auto [i, j, at] : test::cells(kSize, kSize)) {
                sums[field][at] += small[field][static_cast<std::size_t>(
                    j * divisor % kSize * kSize + i * divisor % kSize)];
            }
        }
    }
    const SurfaceSettings settings = with_threshold(parameters.surface, sea.modes(), kSize);
    Surface sum(Lattice{kSize, 700.0}, kTime, test::kAllChannels);
    const std::vector<MapOutput> outputs = outputs_of(sum);
    MapRequest request{{}, settings, outputs, {}};
    request.modes.resolution = kSize;
    write_channels(sums, request, {}, test::pool());
    const double hs = sea.state().significant_wave_height.resolved;
    for (const Channel channel : test::channels_of(map)) {
        const double worst = test::largest_difference(map.channel(channel), sum.channel(channel));
        EXPECT_LT(worst, 1e-5 * hs) << channel_info(channel).name;
    }
}

int packings = 0;

/// The cpu backend, which says how often it packs.
const Backend kCounting = {"counting", {}, [] {
                               return MapFunction([cpu = Backend::cpu.start()](
                                                      const MapRequest& request, ThreadPool& pool) {
                                   const bool packed = cpu(request, pool);
                                   packings += packed ? 1 : 0;
                                   return packed;
                               });
                           }};

TEST(CascadeMap, PacksAgainOnlyWhereTheModesAreOthers) {
    Ocean sea(cascade_sea(32, 300.0, {1, 3}), {.threads = 1});
    CascadeMap kept(1, 64, kCounting);
    const auto same = [&](double time, const Backend& backend) {
        CascadeMap fresh(1, 64, backend);
        const LinearSet fields = {Linear::height, Linear::gradient_xy};
        const auto& a = kept.planes(sea.modes(), time, fields, test::pool());
        const auto& b = fresh.planes(sea.modes(), time, fields, test::pool());
        EXPECT_LT(test::relative_error(a[Linear::height], b[Linear::height]), 2e-6);
        return a[Linear::height] == b[Linear::height] &&
               a[Linear::gradient_xy] == b[Linear::gradient_xy] && b[Linear::slope_x].empty();
    };
    packings = 0;
    EXPECT_TRUE(same(1.0, Backend::cpu));
    EXPECT_TRUE(same(2.0, Backend::cpu));
    EXPECT_EQ(packings, 1);
    sea.set("choppiness", "0.5");  // affects no mode
    EXPECT_TRUE(same(2.0, Backend::cpu));
    EXPECT_EQ(packings, 1);
    sea.set("wind_speed", "14");
    EXPECT_TRUE(same(2.0, Backend::cpu));
    EXPECT_EQ(packings, 2);
    same(2.0, Backend::dft);
    // Modes without a revision are never confused with others.
    Modes scaled = sea.modes();
    scaled.revision = {};
    kept.planes(scaled, 2.0, {Linear::height}, test::pool());
    kept.planes(scaled, 2.0, {Linear::height}, test::pool());
    EXPECT_EQ(packings, 4);
    EXPECT_THROW(CascadeMap(0, 48), Error);
    EXPECT_THROW(kept.planes(scaled, std::nan(""), {}, test::pool()), Error);
}

TEST(Cascades, SharesSayWhatRepeatsMoreOften) {
    const SeaState coprime = test::state_of(cascade_sea(128, 4000.0, {1, 7, 53}));
    ASSERT_EQ(coprime.cascades.size(), 3u);
    EXPECT_NEAR(coprime.cascades[0].height, 1.0, 1e-12);
    EXPECT_NEAR(coprime.cascades[0].slope, 1.0, 1e-12);
    EXPECT_NEAR(coprime.cascades[1].period, 4000.0 / 7.0, 1e-9);
    EXPECT_LT(coprime.cascades[2].height, coprime.cascades[1].height);
    // With 1, 4, 16 the last cascade repeats at the second one's period too.
    const SeaState nested = test::state_of(cascade_sea(128, 4000.0, {1, 4, 16}));
    EXPECT_GT(nested.cascades[1].slope, nested.cascades[2].slope);
    const double second_alone = nested.cascades[1].slope - nested.cascades[2].slope;
    EXPECT_GT(second_alone, 0.0);
    // A small first lattice leaves most of the slope to the others, and says so.
    const auto warns = [](const SeaState& state) {
        return bool(test::says(state.warnings, "repeat every"));
    };
    const SeaState poor = test::state_of(cascade_sea(32, 4000.0, {1, 4, 16}));
    EXPECT_TRUE(warns(poor));
    EXPECT_GT(poor.cascades[1].slope, 0.5);
    EXPECT_FALSE(warns(test::state_of(cascade_sea(512, 4000.0, {1, 7, 53}))));
}

TEST(Cascades, ChosenDivisorsAreOneAndPrimesThatKeepTheirDistance) {
    Grid grid{512, 4000.0, 3, {}};
    EXPECT_EQ(cascade_divisors(grid), (std::vector<int>{1, 7, 53}));
    for (const int resolution : {32, 64, 128, 512, 8192}) {
        grid = {resolution, 4000.0, 5, {}};
        Parameters parameters;
        parameters.grid = grid;
        parameters.grid.cascade_divisors = cascade_divisors(grid);
        EXPECT_NO_THROW(validate(parameters)) << resolution;
    }
}

TEST(Cascades, DefaultMapsHoldFourTimesTheSamplesAtMost4096) {
    EXPECT_EQ(default_map_resolution({512, 500.0, 1, {}}), 512);
    EXPECT_EQ(default_map_resolution({8192, 500.0, 1, {}}), 8192);
    EXPECT_EQ(default_map_resolution({512, 500.0, 3, {}}), 2048);
    EXPECT_EQ(default_map_resolution({2048, 500.0, 3, {}}), 4096);
    EXPECT_EQ(default_map_resolution({8192, 500.0, 3, {}}), 8192);
    EXPECT_EQ(default_map_resolution({64, 500.0, 2, {1, 2}}), 128);
}

TEST(Cascades, DivisorsThatMakeNoSenseAreRefused) {
    const auto message = [](std::vector<int> divisors, int cascades) {
        Parameters parameters;
        parameters.grid.resolution = 64;
        parameters.grid.cascades = cascades;
        parameters.grid.cascade_divisors = std::move(divisors);
        return test::message_of([&] { validate(parameters); });
    };
    EXPECT_EQ(message({1, 5}, 2), "");
    EXPECT_TRUE(test::says(message({1, 5}, 3), "must have 3 numbers"));
    EXPECT_TRUE(test::says(message({2, 5}, 2), "must begin with 1"));
    EXPECT_TRUE(test::says(message({1, 1}, 2), "must ascend"));
    EXPECT_TRUE(test::says(message({1, 9}, 2), "too far above"));
}

}  // namespace
}  // namespace ocean
