// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Crests on cue: the sea has each at its place and time, as its highest point near, and is
// otherwise a sea of its spectrum.
#include "ocean/internal/crests.hpp"

#include "crest_probe.hpp"
#include "ocean/ocean.hpp"
#include "ocean/parameter_table.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

using test::Highest;
using test::highest_near;
using test::wind_sea;

constexpr Crest kHero{33.3, 137.0, 412.0, {1.1, true}, {}};

Modes modes_of(const Parameters& parameters, int threads = 1) {
    ThreadPool pool(threads);
    return make_modes(make_directional_spectrum(parameters), parameters, pool);
}

double requested_height(const Parameters& parameters) {
    const SurfaceSettings& limits = parameters.surface;
    return make_directional_spectrum(parameters)
        .moments(parameters.water, limits.shortest_wavelength, limits.longest_wavelength)
        .significant_wave_height();
}

/// A storm of Hs 6 m and Tp 11 s, whose waves of 16 m and more the grid holds.
Parameters storm() {
    Parameters parameters = wind_sea(64, 500.0);
    WaveSystem& system = parameters.waves.front();
    system.significant_wave_height = 6.0;
    system.peak_period = 11.0;
    parameters.crests = {kHero};
    return parameters;
}

Parameters changed(const std::function<void(Parameters&)>& change) {
    Parameters parameters = storm();
    change(parameters);
    return parameters;
}

struct CrestSea {
    const char* name;
    Parameters parameters;

    /// Returns the peak of the system with the shorter waves [rad/s].
    double peak_omega() const {
        if (parameters.waves.size() > 1) return kTwoPi / *parameters.waves.back().peak_period;
        return make_directional_spectrum(parameters).moments(parameters.water).peak_omega;
    }
};

/// Seas of all kinds; the shortest wave of each is a twelfth of the peak's or a little less.
std::vector<CrestSea> crest_seas() {
    const auto phillips = [](Parameters& p) {
        p.waves = {WaveSystem{}};
        p.waves.front().wind_speed = 17.0;
    };
    const auto tma = [](Parameters& p) {
        p.waves.front().spectrum = SpectrumKind::tma;
        p.water.depth = 15.0;
        p.waves.front().significant_wave_height = 3.0;
    };
    const auto two_systems = [](Parameters& p) {
        p.waves.push_back(p.waves.front());
        p.waves[0].significant_wave_height = 2.5;
        p.waves[0].peak_period = 14.0;
        p.waves[0].wind_direction = -60.0;
        p.waves[0].swell = 0.5;
        p.waves[1].significant_wave_height = 3.0;
        p.waves[1].peak_period = 7.5;
    };
    const auto narrow_swell = [](Parameters& p) {
        p.waves.front().peak_period = 14.0;
        p.waves.front().peak_enhancement = 10.0;
        p.waves.front().swell = 1.0;
    };
    const auto loop = [](Parameters& p) { p.time.loop_period = 60.0; };
    const auto late = [](Parameters& p) { p.crests.front().time = 1e6; };
    const auto far_away = [](Parameters& p) {
        p.crests.front().x += 4000.0;
        p.crests.front().y -= 9000.0;
    };
    const auto three_cascades = [](Parameters& p) {
        p.grid.cascades = 3;
        p.grid.cascade_divisors = {1, 7, 53};
    };
    const auto measured = [](Parameters& p) {
        auto record = std::make_shared<SpectrumRecord>();
        for (double f = 0.05; f < 0.25; f += 0.005) {
            record->frequency.push_back(f);
            record->density.push_back(90.0 * std::exp(-std::pow((f - 0.09) / 0.02, 2.0)));
            record->a1.push_back(0.3);
            record->b1.push_back(0.8);
            record->a2.push_back(-0.5);
            record->b2.push_back(0.4);
        }
        p.waves = {WaveSystem{}};
        p.waves.front().spectrum = SpectrumKind::measured;
        p.waves.front().measured = record;
    };
    return {{"JONSWAP", storm()},
            {"Phillips", changed(phillips)},
            {"TMA", changed(tma)},
            {"two systems", changed(two_systems)},
            {"a narrow swell", changed(narrow_swell)},
            {"a loop", changed(loop)},
            {"a late time", changed(late)},
            {"a far place", changed(far_away)},
            {"three cascades", changed(three_cascades)},
            {"measured", changed(measured)}};
}

TEST(Crests, StandAtTheirPlaceAndTimeWhateverTheSea) {
    for (CrestSea& sea : crest_seas()) {
        for (const double height : {1.3, -0.9}) {
            sea.parameters.crests.front().height = {height, true};
            const Modes modes = modes_of(sea.parameters);
            WaveSum sum(modes, sea.parameters.water);
            const Crest& crest = sea.parameters.crests.front();
            sum.set_time(crest.time);
            const LinearSample sample = sum.at_label(crest.x, crest.y);
            EXPECT_NEAR(sample.height, height * requested_height(sea.parameters), 1e-4) << sea.name;
            EXPECT_NEAR(sample.displacement_x, 0.0, 1e-4) << sea.name;
            EXPECT_NEAR(sample.displacement_y, 0.0, 1e-4) << sea.name;
        }
    }
}

// In a sea of long waves alone the water is level and neither rises nor falls.
TEST(Crests, AreLevelAndAtTheirHighestMoment) {
    Parameters parameters = storm();
    parameters.surface.shortest_wavelength = 20.0;
    WaveSum sea(modes_of(parameters), parameters.water);
    sea.set_time(kHero.time);
    const LinearSample sample = sea.at_label(kHero.x, kHero.y);
    EXPECT_NEAR(sample.slope_x, 0.0, 1e-5);
    EXPECT_NEAR(sample.slope_y, 0.0, 1e-5);
    EXPECT_NEAR(sample.height_rate, 0.0, 1e-4);
}

TEST(Crests, AreTheHighestPointsNearThem) {
    for (CrestSea& sea : crest_seas()) {
        const double wanted = 1.1 * requested_height(sea.parameters);
        for (const std::uint32_t seed : {1u, 2u}) {
            sea.parameters.seed = seed;
            const Modes modes =
                test::long_waves(modes_of(sea.parameters), sea.parameters.water, sea.peak_omega());
            const Highest highest =
                highest_near(sea.parameters, modes, sea.parameters.crests.front(), 16.0, 0.8);
            EXPECT_NEAR(highest.height / wanted, 1.0, 0.005) << sea.name << ", seed " << seed;
            EXPECT_NEAR(highest.time, sea.parameters.crests.front().time, 0.15)
                << sea.name << ", seed " << seed;
        }
    }
}

TEST(Crests, OfOneSeaAreManyAndMayBeTroughs) {
    Parameters parameters = storm();
    parameters.crests = {{20.0, 100.0, 100.0, {5.0, false}, {}},
                         {35.0, 350.0, 50.0, {6.0, false}, {}},
                         {20.0, 300.0, 300.0, {-3.0, false}, {}}};
    const Modes modes = modes_of(parameters);
    WaveSum sea(modes, parameters.water);
    for (const Crest& crest : parameters.crests) {
        sea.set_time(crest.time);
        EXPECT_NEAR(sea.at_label(crest.x, crest.y).height, crest.height.value, 1e-4);
    }
}

/// The correlations of the heights at two places and times with modes of that variance.
double covariance(const Parameters& parameters, const Modes& modes, double x, double y,
                  double time) {
    const auto spectrum = make_directional_spectrum(parameters);
    const int half = parameters.grid.resolution / 2;
    double sum = 0.0;
    for (int m = 1 - half; m < half; ++m) {
        for (int n = 1 - half; n < half; ++n) {
            const std::size_t at = mode_index(n, m, parameters.grid.resolution);
            const double rate = static_cast<double>(modes.cascades[0].rate_high[at]) +
                                static_cast<double>(modes.cascades[0].rate_low[at]);
            const double step = modes.lattice.wavenumber_step();
            sum += modal_variance(spectrum, parameters, n, m) *
                   std::cos(step * (n * x + m * y) - kTwoPi * rate * time);
        }
    }
    return sum;
}

/// Means over seeds at one place: of the height with a crest, of the part of the drawn height that
/// the crest replaces, and of their products.
struct SeedSums {
    double height = 0.0, replaced = 0.0;
    double height_squared = 0.0, replaced_squared = 0.0, product = 0.0;

    void add(double with_crest, double drawn, double share) {
        const double part = drawn - with_crest;
        height += share * with_crest;
        replaced += share * part;
        height_squared += share * with_crest * with_crest;
        replaced_squared += share * part * part;
        product += share * with_crest * part;
    }
    double variance() const { return std::max(0.0, height_squared - height * height); }
    double replaced_variance() const { return replaced_squared - replaced * replaced; }
    double covariance() const { return product - height * replaced; }
};

// The mean over all seeds is A r / m0, NewWave: no other row is correlated with the height at its
// own place. What is left of the draw is independent of what the crest replaces, so that both
// variances add up to the sea's own.
TEST(Crests, SeedsHaveMeanAndVarianceOfTheory) {
    Parameters parameters = wind_sea(32, 600.0);
    parameters.waves.front().significant_wave_height = 6.0;
    parameters.waves.front().peak_period = 14.0;
    const Crest crest{0.0, 300.0, 300.0, {1.2, true}, {}};
    constexpr int kSeeds = 160;
    const std::vector<double> along = {0.0, 15.0, 40.0, 100.0, 250.0};
    const double x = std::cos(30.0 * kPi / 180.0);
    const double y = std::sin(30.0 * kPi / 180.0);
    std::vector<SeedSums> sums(along.size());
    const auto spectrum = make_directional_spectrum(parameters);
    ThreadPool pool(1);
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        parameters.seed = seed;
        parameters.crests.clear();
        const WaveSum drawn(make_modes(spectrum, parameters, pool), parameters.water);
        parameters.crests = {crest};
        const WaveSum sea(make_modes(spectrum, parameters, pool), parameters.water);
        for (std::size_t i = 0; i < along.size(); ++i) {
            const double at_x = 300.0 + along[i] * x;
            const double at_y = 300.0 + along[i] * y;
            sums[i].add(sea.at_label(at_x, at_y).height, drawn.at_label(at_x, at_y).height,
                        1.0 / kSeeds);
        }
    }
    const Modes modes = modes_of(parameters);
    const double m0 = covariance(parameters, modes, 0.0, 0.0, 0.0);
    const double height = 1.2 * requested_height(parameters);
    for (std::size_t i = 0; i < along.size(); ++i) {
        SCOPED_TRACE(along[i]);
        const double variance = sums[i].variance();
        const double replaced = sums[i].replaced_variance();
        const double r = covariance(parameters, modes, along[i] * x, along[i] * y, 0.0);
        EXPECT_NEAR(sums[i].height, height * r / m0, 3.0 * std::sqrt(variance / kSeeds) + 1e-4);
        EXPECT_NEAR(sums[i].covariance(), 0.0,
                    3.0 * std::sqrt(variance * replaced / kSeeds) + 1e-6);
        EXPECT_NEAR((variance + replaced) / m0, 1.0, 3.0 * std::sqrt(2.0 / kSeeds));
        EXPECT_GE(replaced / m0, r * r / (m0 * m0) * (1.0 - 3.0 * std::sqrt(2.0 / kSeeds)))
            << "it replaces at least what its height alone determines";
    }
    EXPECT_NEAR(sums.front().variance(), 0.0, 1e-6);
    EXPECT_GT(sums.back().variance(), 0.7 * m0) << "far away the sea is free";
}

TEST(Crests, KeepTheBitsOfASeaWithoutThem) {
    Parameters parameters = storm();
    parameters.crests.clear();
    const Modes plain = modes_of(parameters);
    const Modes with_crest = modes_of(storm(), 3);
    const Modes again = modes_of(storm(), 1);
    const auto& a = plain.cascades[0].h0;
    const auto& b = with_crest.cascades[0].h0;
    const auto bytes = a.size() * sizeof(a[0]);
    EXPECT_NE(std::memcmp(a.data(), b.data(), bytes), 0);
    EXPECT_EQ(std::memcmp(b.data(), again.cascades[0].h0.data(), bytes), 0)
        << "any number of threads";
    EXPECT_EQ(std::memcmp(&plain.cascades[0].rate_high[0], &with_crest.cascades[0].rate_high[0],
                          a.size() * sizeof(float)),
              0);
}

// The waves of the second cascade repeat every 125 m: they may not carry the crest, although some
// of them are as long as its long waves. They are level there.
TEST(Crests, AreNotMadeOfWavesThatRepeatWithinThePatch) {
    Parameters parameters = storm();
    parameters.grid = {32, 500.0, 2, {1, 4}};
    Modes modes = modes_of(parameters);
    std::fill(modes.cascades[0].h0.begin(), modes.cascades[0].h0.end(), 0.0f);
    WaveSum sea(modes, parameters.water);
    sea.set_time(kHero.time);
    EXPECT_NEAR(sea.at_label(kHero.x, kHero.y).height, 0.0, 1e-4);
    EXPECT_GT(std::abs(sea.at_label(kHero.x + 40.0, kHero.y).height), 1e-3);
}

// A finer grid adds short waves, which are level at the crest; it moves no long one.
TEST(Crests, OfAFinerGridAreMadeOfTheSameLongWaves) {
    Parameters parameters = storm();
    const Modes coarse = modes_of(parameters);
    parameters.grid.resolution = 128;
    const Modes fine = modes_of(parameters);
    double largest = 0.0;
    for (int m = -20; m <= 20; ++m) {
        for (int n = -20; n <= 20; ++n) {
            const std::complex<float> a = coarse.cascades[0].h0[mode_index(n, m, 64)];
            const std::complex<float> b = fine.cascades[0].h0[mode_index(n, m, 128)];
            largest = std::max(largest, static_cast<double>(std::abs(a - b)));
        }
    }
    EXPECT_LT(largest, 1e-3);
    WaveSum sea(fine, parameters.water);
    sea.set_time(kHero.time);
    EXPECT_NEAR(sea.at_label(kHero.x, kHero.y).height, 1.1 * 6.0, 1e-3);
}

// Two systems cross: the direction of the crest picks the one whose way it goes.
TEST(Crests, TravelInTheirDirection) {
    for (const double direction : {-60.0, 30.0}) {
        Parameters parameters = crest_seas()[3].parameters;
        parameters.crests.front().direction = direction;
        const Crest& crest = parameters.crests.front();
        const Modes modes = modes_of(parameters);
        // The highest point, followed over two seconds.
        const auto top = [&](double time) {
            Crest later = crest;
            later.time = time;
            return highest_near(parameters, modes, later, 20.0, 0.0);
        };
        const Highest before = top(crest.time - 1.0);
        const Highest after = top(crest.time + 1.0);
        const double way = std::atan2(after.y - before.y, after.x - before.x) * 180.0 / kPi;
        EXPECT_NEAR(std::remainder(way - direction, 360.0), 0.0, 25.0) << direction;
        WaveSum sea(modes, parameters.water);
        sea.set_time(crest.time);
        EXPECT_NEAR(sea.at_label(crest.x, crest.y).height, 1.1 * requested_height(parameters),
                    1e-4);
    }
}

TEST(Crests, ThatASeaCannotMakeAreRefusedWhenItOpens) {
    const auto expect = [](const std::string& part,
                           const std::function<void(Parameters&)>& change) {
        EXPECT_TRUE(test::says(test::message_of([&] { Ocean sea(changed(change)); }), part));
    };
    EXPECT_EQ(test::message_of([] { Ocean sea(storm()); }), "");
    expect("one crest in 10^14", [](Parameters& p) { p.crests[0].height = {2.01, true}; });
    expect("2.17 Hs", [](Parameters& p) { p.crests[0].height = {13.0, false}; });
    expect("neither a crest", [](Parameters& p) { p.crests[0].height = {0.0, false}; });
    expect("one height", [](Parameters& p) {
        p.crests.push_back(p.crests[0]);
        p.crests[1].height = {0.5, true};
        p.crests[1].x += p.grid.patch_size;
    });
    expect("contradicts", [](Parameters& p) {
        p.crests.push_back(p.crests[0]);
        p.crests[1].height = {-1.0, true};
        p.crests[1].time += 0.5;
    });
    expect("flat sea", [](Parameters& p) { p.waves[0].significant_wave_height = 0.0; });
    expect("the grid holds", [](Parameters& p) {
        p.surface.longest_wavelength = 0.0;
        p.grid.patch_size = 40.0;
    });
    expect("travels that way", [](Parameters& p) {
        p.waves[0].opposing = 0.0;
        p.crests[0].direction = -150.0;
    });
    expect("no number", [](Parameters& p) { p.crests[0].x = std::nan(""); });
    expect("17 crests", [](Parameters& p) { p.crests.resize(17); });
}

TEST(Crests, ChangeTheModesAndNoEarlierStage) {
    const Parameters before = storm();
    Parameters after = before;
    EXPECT_EQ(first_dirty_stage(before, after), std::nullopt);
    after.crests[0].time = 40.0;
    EXPECT_EQ(first_dirty_stage(before, after), Stage::modes);
    after.crests.clear();
    EXPECT_EQ(first_dirty_stage(before, after), Stage::modes);
    EXPECT_EQ(first_dirty_stage(after, before), Stage::modes);
}

// One crest in N for Hs 6 m, Tm01 9.3 s [Forristall 2000].
TEST(Crests, AreAsRareAsForristallSays) {
    EXPECT_NEAR(1.0 / rayleigh_exceedance(6.0, 6.0), 2981.0, 1.0);
    const Water deep;
    EXPECT_NEAR(1.0 / forristall_exceedance(6.0, 6.0, 9.3, deep), 1000.0, 100.0);
    EXPECT_NEAR(1.0 / forristall_exceedance(7.5, 6.0, 9.3, deep), 41000.0, 4000.0);
    Water shallow;
    shallow.depth = 15.0;
    EXPECT_NEAR(1.0 / forristall_exceedance(6.0, 6.0, 9.3, shallow), 135.5, 1.0);
}

TEST(Crests, AreDescribedByTheStateOfTheirSea) {
    Parameters parameters = storm();
    parameters.crests[0].height = {1.3, true};
    const SeaState state = Ocean(parameters).state();
    ASSERT_EQ(state.crests.size(), 1u);
    EXPECT_NEAR(state.crests[0].height, 7.8, 1e-2);
    EXPECT_NEAR(state.crests[0].relative_height, 1.3, 1e-9);
    EXPECT_GT(state.crests[0].one_in_rayleigh, state.crests[0].one_in_forristall);
    EXPECT_GT(state.crest_variance, 1.05);
    EXPECT_LT(state.crest_variance, 2.0);
    EXPECT_TRUE(
        test::says(state.warnings, {"1.30 Hs: one crest in", "variance of the whole patch"}));
    parameters.crests.clear();
    EXPECT_FALSE(test::says(sea_state_json(Ocean(parameters).state()), "crest"));
}

}  // namespace
}  // namespace ocean
