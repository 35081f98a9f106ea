// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A take folded into the parameters: pure, continuous, and settled after a while; and its effect on
// the surface within one frame.
#include "ocean/sea.hpp"

#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/make_surface.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr double kForever = 1e6;

TakeEvent event(double seconds, std::string_view name, ParameterValue value) {
    return {seconds, find_parameter(name), std::move(value)};
}

/// A sea in which every optional is set.
Sea sea_with(std::vector<TakeEvent> events, double glide = 0.5) {
    Sea sea;
    sea.parameters = test::wind_sea(32, 200.0);
    sea.parameters.time.glide = glide;
    sea.parameters.waves.front().wind_speed = 10.0;
    sea.parameters.waves.front().significant_wave_height = 2.0;
    sea.parameters.waves.front().peak_period = 6.0;
    sea.take.events = std::move(events);
    validate(sea);
    return sea;
}

WaveSystem waves_at(const Sea& sea, double time) {
    return sea.at(time).waves.front();
}

double wind_at(const Sea& sea, double time) {
    return waves_at(sea, time).wind();
}

double height_at(const Sea& sea, double time) {
    return *waves_at(sea, time).significant_wave_height;
}

std::vector<ParameterRef> live_parameters() {
    std::vector<ParameterRef> live;
    for (const ParameterInfo& info : parameter_table()) {
        if (info.change == ParameterClass::live) live.push_back({&info, 0});
    }
    return live;
}

TEST(Take, OfNothingChangesNothing) {
    const Sea sea = sea_with({});
    for (const ParameterRef& ref : live_parameters()) {
        EXPECT_EQ(value_of(sea.at(12.0), ref), value_of(sea.parameters, ref));
    }
}

TEST(Take, GlidesByAOnePoleFilterFromTheFilesValue) {
    const Sea sea = sea_with({event(3.0, "wind_speed", 14.0)}, 0.5);
    EXPECT_EQ(wind_at(sea, 2.9999), 10.0);
    EXPECT_EQ(wind_at(sea, 3.0), 10.0);
    EXPECT_NEAR(wind_at(sea, 3.5), 14.0 - 4.0 * std::exp(-1.0), 1e-12);
    EXPECT_NEAR(wind_at(sea, 5.0), 14.0 - 4.0 * std::exp(-4.0), 1e-12);
    EXPECT_EQ(wind_at(sea, 14.0), 14.0);
    EXPECT_EQ(sea.at(3.1).time.glide, 0.5);
}

TEST(Take, AnEventInTheMiddleOfAGlideGoesOnFromThere) {
    const Sea sea = sea_with({event(1.0, "wind_speed", 20.0), event(1.25, "wind_speed", 5.0),
                              event(1.25, "wind_speed", 6.0), event(40.0, "wind_speed", 7.0)},
                             0.5);
    const double reached = 20.0 - 10.0 * std::exp(-0.5);
    EXPECT_NEAR(wind_at(sea, 1.25), reached, 1e-12);
    EXPECT_NEAR(wind_at(sea, 1.5), 6.0 + (reached - 6.0) * std::exp(-0.5), 1e-12);
    EXPECT_EQ(wind_at(sea, 39.0), 6.0);
    EXPECT_NEAR(wind_at(sea, 40.5), 7.0 - std::exp(-1.0), 1e-12);
}

TEST(Take, WithoutGlideJumps) {
    const Sea sea = sea_with({event(3.0, "wind_speed", 14.0), event(5.0, "choppiness", 0.2)}, 0.0);
    EXPECT_EQ(wind_at(sea, std::nextafter(3.0, 0.0)), 10.0);
    EXPECT_EQ(wind_at(sea, 3.0), 14.0);
    EXPECT_EQ(sea.at(5.0).surface.choppiness, 0.2);
}

/// Another value in the soft range, or the next word.
ParameterValue other_value(const Parameters& parameters, const ParameterRef& ref) {
    const ParameterInfo& info = *ref.info;
    if (!info.choices().empty()) {
        const std::string now = to_text(value_of(parameters, ref));
        return std::string(info.choices().front() == now ? info.choices().back()
                                                         : info.choices().front());
    }
    return 0.35 * info.soft_min + 0.65 * info.soft_max;
}

TEST(Take, EveryLiveParameterIsANumberThatGlidesOrAWordThatMixesOrSwitches) {
    for (const ParameterRef& ref : live_parameters()) {
        const Sea empty = sea_with({});
        const ParameterValue value = other_value(empty.parameters, ref);
        const Sea sea = sea_with({{2.0, ref, value}});
        EXPECT_EQ(value_of(sea.at(1.9), ref), value_of(empty.parameters, ref)) << ref.info->key;
        EXPECT_EQ(value_of(sea.at(kForever), ref), value) << ref.info->key;
        EXPECT_EQ(sea.at(kForever).waves.size(), 1u);
        const Parameters between = sea.at(2.2);
        if (ref.info->type() == "float") {
            const double from = std::get<double>(value_of(empty.parameters, ref));
            const double now = std::get<double>(value_of(between, ref));
            const double to = std::get<double>(value);
            EXPECT_GT((now - from) * (to - now), 0.0) << ref.info->key << " is between";
        } else if (ref.info->holds<&WaveSystem::spreading>()) {
            EXPECT_EQ(between.waves.size(), 2u);
        } else {
            EXPECT_TRUE(ref.info->holds<&SurfaceSettings::foam_coverage>());
            EXPECT_EQ(value_of(between, ref), value);
        }
    }
}

TEST(Take, ASettledSeaHasItsValueInEveryBitSoThatNothingIsBuiltAgain) {
    for (const ParameterRef& ref : live_parameters()) {
        const Sea sea = sea_with({{2.0, ref, other_value(sea_with({}).parameters, ref)}}, 1.0);
        for (const double time : {2.0 + 21.0, 30.0, 100.0}) {
            EXPECT_EQ(value_of(sea.at(time), ref), sea.take.events.front().value)
                << ref.info->key << " at " << time;
        }
    }
}

TEST(Take, ASmallStepSettlesSooner) {
    const Sea sea = sea_with({event(0.0, "wind_speed", 10.001)}, 1.0);
    EXPECT_EQ(wind_at(sea, 14.0), 10.001);
    EXPECT_NE(wind_at(sea, 10.0), 10.001);
}

TEST(Take, APeriodGlidesByFactorsAndAFetchAsTheHeightItMakes) {
    const Sea sea = sea_with({event(1.0, "fetch", 2e6), event(1.0, "peak_period", 12.0)});
    const double half = 1.0 + 0.5 * std::log(2.0);
    const WaveSystem system = waves_at(sea, half);
    EXPECT_NEAR(std::sqrt(system.fetch), 0.5 * (std::sqrt(1e5) + std::sqrt(2e6)), 1e-9);
    EXPECT_NEAR(*system.peak_period, std::sqrt(6.0 * 12.0), 1e-9);
}

TEST(Take, AHeightGlidesToAndFromNothing) {
    const Sea sea = sea_with(
        {event(1.0, "significant_wave_height", 0.0), event(30.0, "significant_wave_height", 3.0)});
    EXPECT_NEAR(height_at(sea, 1.5), 2.0 * std::exp(-1.0), 1e-12);
    EXPECT_EQ(height_at(sea, 29.0), 0.0);
    EXPECT_NEAR(height_at(sea, 30.5), 3.0 - 3.0 * std::exp(-1.0), 1e-12);
}

TEST(Take, DirectionsTurnTheShortWayAndStayInRange) {
    for (const auto& [from, to] : {std::pair(170.0, -170.0), std::pair(-350.0, 350.0),
                                   std::pair(10.0, 350.0), std::pair(0.0, 179.0)}) {
        Sea sea = sea_with({event(0.0, "wind_direction", to)});
        sea.parameters.waves.front().wind_direction = from;
        double last = from, turned = 0.0;
        for (double t = 0.0; t < 15.0; t += 0.01) {
            const double now = *waves_at(sea, t).wind_direction;
            EXPECT_LE(std::abs(now), 360.0);
            turned += std::remainder(now - last, 360.0);
            last = now;
        }
        EXPECT_NEAR(turned, std::remainder(to - from, 360.0), 1e-6) << from << " to " << to;
        EXPECT_EQ(*waves_at(sea, 15.0).wind_direction, to);
    }
}

double height_of(const Parameters& parameters) {
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    return spectrum.moments(parameters.water).significant_wave_height();
}

/// The same with a system that leaves wind, height and period unset.
Sea unset_sea(std::vector<TakeEvent> events) {
    Sea sea = sea_with(std::move(events));
    WaveSystem& system = sea.parameters.waves.front();
    system.wind_speed.reset();
    system.significant_wave_height.reset();
    system.peak_period.reset();
    return sea;
}

TEST(Take, WhatIsUnsetGlidesFromWhatItStoodFor) {
    const Sea sea =
        unset_sea({event(1.0, "wind_speed", 15.0), event(1.4, "significant_wave_height", 1.0),
                   event(1.5, "peak_period", 3.0)});
    EXPECT_FALSE(waves_at(sea, 1.39).significant_wave_height.has_value());
    const double before = height_of(sea.at(1.4 - 1e-9));
    EXPECT_NEAR(height_at(sea, 1.4), before, 1e-5 * before);
    const double free_period =
        kTwoPi / make_directional_spectrum(sea.at(1.5 - 1e-9)).moments(Water{}).peak_omega;
    EXPECT_NEAR(*waves_at(sea, 1.5).peak_period, free_period, 1e-3 * free_period);
    EXPECT_EQ(height_at(sea, kForever), 1.0);
    EXPECT_EQ(*waves_at(sea, kForever).peak_period, 3.0);
}

TEST(Take, AFlatSeaHasNoPeriodToGlideFrom) {
    Sea sea =
        sea_with({event(1.0, "peak_period", 8.0), event(1.0, "significant_wave_height", 2.0)});
    WaveSystem& system = sea.parameters.waves.front();
    system = WaveSystem{};
    system.wind_speed = 0.0;
    EXPECT_EQ(*waves_at(sea, 1.0).peak_period, 8.0);
    EXPECT_EQ(height_at(sea, 1.0), 0.0);
}

/// The wind that makes whitecaps.
double whitecap_wind(const Sea& sea, double time) {
    return *waves_at(sea, time).wind_above();
}

TEST(Take, BringsWindOverASwellFromCalm) {
    Sea sea = sea_with({event(1.0, "wind_speed", 20.0), event(1.5, "wind_speed", 14.0)}, 0.5);
    WaveSystem& swell = sea.parameters.waves.front();
    swell.wind_speed.reset();
    EXPECT_EQ(whitecap_wind(sea, 0.0), 0.0);
    EXPECT_EQ(whitecap_wind(sea, 1.0), 0.0);
    for (double t = 1.0; t < 3.0; t += 0.01) {
        EXPECT_LT(std::abs(whitecap_wind(sea, t + 0.01) - whitecap_wind(sea, t)), 0.45) << t;
    }
    EXPECT_EQ(whitecap_wind(sea, 30.0), 14.0);
    // The waves were made with 10 m/s and glide on from there.
    EXPECT_EQ(wind_at(sea, 1.0), 10.0);

    sea.take = {};
    EXPECT_EQ(waves_at(sea, 0.0).wind_above(), std::nullopt);
    swell.wind_speed = 8.0;
    sea.take.events = {event(1.0, "wind_speed", 14.0)};
    EXPECT_EQ(whitecap_wind(sea, 1.0), 8.0) << "a wind that was given needs no onset";
}

TEST(Take, HeightAndPeriodOfAWindSeaDoNotStillItsWind) {
    const Sea sea = unset_sea({event(1.0, "significant_wave_height", 1.0),
                               event(1.2, "peak_period", 5.0), event(2.0, "wind_speed", 14.0)});
    for (const double time : {0.0, 1.1, 1.9, 2.0}) {
        EXPECT_EQ(whitecap_wind(sea, time), 10.0) << time;
    }
    EXPECT_EQ(whitecap_wind(sea, 30.0), 14.0);
}

std::shared_ptr<const SpectrumRecord> buoy_record() {
    SpectrumRecord record;
    record.frequency = {0.08, 0.1, 0.12, 0.2};
    record.density = {0.0, 6.0, 2.0, 0.5};
    record.a1 = {0.0, 0.0, 0.1, 0.0};
    record.b1 = {0.8, 0.8, 0.8, 0.7};
    record.a2 = {-0.5, -0.5, -0.5, -0.4};
    record.b2 = {0.0, 0.0, 0.0, 0.0};
    return std::make_shared<const SpectrumRecord>(record);
}

TEST(Take, AMeasuredSeaGlidesFromItsOwnHeightPeriodAndDirection) {
    Sea sea = sea_with({});
    WaveSystem& system = sea.parameters.waves.front();
    system = WaveSystem{};
    system.spectrum = SpectrumKind::measured;
    system.measured = buoy_record();
    const double before = height_of(sea.at(0.0));
    sea.take.events = {event(1.0, "significant_wave_height", 1.0), event(1.0, "peak_period", 12.0),
                       event(1.0, "wind_direction", 0.0)};
    const WaveSystem then = waves_at(sea, 1.0);
    EXPECT_NEAR(*then.significant_wave_height, before, 1e-9);
    EXPECT_NEAR(*then.peak_period, 10.0, 1e-9);
    EXPECT_NEAR(*then.wind_direction, 90.0, 5.0);
    EXPECT_EQ(then.measured, system.measured);
}

TEST(Take, SpreadingsMixAndTheirEnergiesAddUp) {
    const Sea sea =
        sea_with({event(1.0, "spreading", "mitsuyasu"), event(1.3, "spreading", "donelan_banner"),
                  event(1.6, "spreading", "hasselmann")});
    const double height = height_of(sea.at(0.0));
    std::size_t most = 0;
    for (double t = 0.9; t < 14.0; t += 0.1) {
        const Parameters now = sea.at(t);
        double energy = 0.0;
        for (const WaveSystem& system : now.waves) energy += system.energy_share;
        EXPECT_NEAR(energy, 1.0, 1e-12);
        most = std::max(most, now.waves.size());
    }
    const Parameters mixed = sea.at(1.7);
    EXPECT_EQ(mixed.waves.size(), 3u);
    EXPECT_NEAR(height_of(mixed), height, 1e-5 * height);
    EXPECT_EQ(most, 3u);
    EXPECT_EQ(sea.at(13.0).waves.size(), 1u);
    EXPECT_EQ(waves_at(sea, 13.0).energy_share, 1.0);
    EXPECT_EQ(waves_at(sea, 13.0).spreading, SpreadingKind::hasselmann);
}

TEST(Take, CopiesStandBehindTheSystemsAndShareTheirOtherChanges) {
    Sea sea = sea_with(
        {event(1.0, "waves.0.spreading", "mitsuyasu"), event(1.0, "waves.0.wind_speed", 20.0)});
    sea.parameters.waves.push_back(WaveSystem{});
    const Parameters now = sea.at(1.2);
    ASSERT_EQ(now.waves.size(), 3u);
    EXPECT_EQ(now.waves[1].spectrum, SpectrumKind::phillips);
    EXPECT_EQ(now.waves[2].spreading, SpreadingKind::hasselmann);
    EXPECT_EQ(now.waves[2].wind_speed, now.waves[0].wind_speed);
}

TEST(Take, TheFoamLifetimeIsThatOfTheParameters) {
    const Sea sea = sea_with({event(1.0, "foam_lifetime", 9.0), event(1.2, "wind_speed", 20.0),
                              event(1.4, "foam_lifetime", 2.0)});
    for (const double t : {0.5, 1.0, 1.3, 1.4, 1.5, 40.0}) {
        EXPECT_EQ(sea.foam_lifetime(t), sea.at(t).surface.foam_lifetime) << t;
    }
}

TEST(Take, ThatCannotBePlayedIsRefused) {
    const auto message = [](std::vector<TakeEvent> events, double loop = 0.0) {
        Sea sea;
        sea.parameters.time.loop_period = loop;
        sea.take.events = std::move(events);
        return test::message_of([&] { validate(sea); });
    };
    EXPECT_EQ(message({event(1.0, "swell", 0.5)}), "");
    EXPECT_TRUE(test::says(message({event(1.0, "seed", 3.0)}), "random.seed: is not live"));
    EXPECT_TRUE(test::says(message({event(1.0, "foam_step", 0.1)}), "foam_step: is not live"));
    EXPECT_TRUE(
        test::says(message({event(1.0, "swell", 3.0)}), "waves.0.swell = 3: is out of range"));
    EXPECT_TRUE(test::says(message({event(1.0, "waves.1.swell", 0.5)}), "waves.1.swell"));
    EXPECT_TRUE(test::says(message({event(1.0, "peak_period", std::string())}), "has no value"));
    EXPECT_TRUE(
        test::says(message({event(2.0, "swell", 0.5), event(1.0, "swell", 0.5)}), "in order"));
    EXPECT_TRUE(test::says(message({event(std::nan(""), "swell", 0.5)}), "-1e9 .. 1e9 s"));
    EXPECT_TRUE(test::says(message({event(1.1e9, "swell", 0.5)}), "-1e9 .. 1e9 s"));
    EXPECT_TRUE(
        test::says(message({event(1.0, "swell", 0.5)}, 10.0), "time.loop_period = 10 s: a loop"));
}

/// A patch of about six of the longest waves, so that all of the energy is on it.
double patch_for(const Parameters& a, const Parameters& b) {
    double longest = 1.0;
    for (const Parameters* parameters : {&a, &b}) {
        const DirectionalSpectrum spectrum = make_directional_spectrum(*parameters);
        if (spectrum.flat()) continue;
        const double omega = spectrum.moments(parameters->water).peak_omega;
        longest = std::max(longest, kTwoPi / Dispersion(parameters->water).wavenumber(omega));
    }
    return 6.0 * longest;
}

Surface shown(const Parameters& parameters, double time) {
    return make_surface(test::modes_of(parameters), parameters.surface, time,
                        {Channel::dx, Channel::dy, Channel::height}, Backend::cpu, test::pool());
}

double rms_distance(const Surface& a, const Surface& b) {
    double sum = 0.0;
    for (const Channel channel : {Channel::dx, Channel::dy, Channel::height}) {
        sum += std::pow(test::rms(test::difference(a.channel(channel), b.channel(channel))), 2);
    }
    return std::sqrt(sum);
}

/// How far an event moves the vertices within a time, rms.
double moved(const Sea& sea, const TakeEvent& step, double within) {
    Sea stepped = sea;
    stepped.take.events = {step};
    const double time = step.seconds + within;
    return rms_distance(shown(sea.at(time), time), shown(stepped.at(time), time));
}

/// Seas of every kind that a take may begin with.
std::vector<Sea> base_seas() {
    std::vector<Sea> seas(5);
    for (Sea& sea : seas) sea.parameters.grid.resolution = 32;
    seas[0].parameters.waves.front() = test::wind_sea().waves.front();
    seas[2].parameters.waves.front().spectrum = SpectrumKind::pierson_moskowitz;
    seas[2].parameters.waves.front().wind_speed = 20.0;
    WaveSystem& shallow = seas[3].parameters.waves.front();
    shallow.spectrum = SpectrumKind::tma;
    shallow.spreading = SpreadingKind::mitsuyasu;
    shallow.wind_speed = 15.0;
    seas[3].parameters.water.depth = 10.0;
    WaveSystem& swell = seas[4].parameters.waves.front();
    swell.spectrum = SpectrumKind::jonswap;
    swell.spreading = SpreadingKind::donelan_banner;
    swell.peak_enhancement = 7.0;
    swell.swell = 1.0;
    swell.significant_wave_height = 2.0;
    swell.peak_period = 14.0;
    return seas;
}

/// A live number that moves the surface, from anywhere in its soft range by a tenth of it.
TakeEvent random_step(Sea& sea, std::mt19937_64& random) {
    std::vector<ParameterRef> numbers;
    for (const ParameterRef& ref : live_parameters()) {
        const bool foam = ref.info->dirties == Stage::foam;
        if (ref.info->type() == "float" && !foam) numbers.push_back(ref);
    }
    const ParameterRef ref = numbers[random() % numbers.size()];
    const double low = ref.info->soft_min;
    const double high = ref.info->soft_max;
    const double from = std::uniform_real_distribution<double>(low, high)(random);
    const double tenth = 0.1 * (high - low);
    const bool down = from + tenth > high || (from - tenth >= low && random() % 2 == 0);
    assign(sea.parameters, ref, from);
    return {100.0, ref, down ? from - tenth : from + tenth};
}

TEST(TakeMotion, AStepOfATenthOfTheSoftRangeMovesLittleWithinAFrame) {
    const std::vector<Sea> seas = base_seas();
    std::mt19937_64 random(5);
    for (int i = 0; i < 40; ++i) {
        Sea sea = seas[random() % seas.size()];
        const TakeEvent step = random_step(sea, random);
        Parameters settled = sea.parameters;
        assign(settled, step.parameter, step.value);
        sea.parameters.grid.patch_size = patch_for(sea.parameters, settled);
        const double height = std::max(height_of(sea.parameters), height_of(settled));
        const double from = std::get<double>(value_of(sea.parameters, step.parameter));
        EXPECT_LE(moved(sea, step, 1.0 / 60.0), 0.02 * height)
            << step.parameter.info->key << " from " << from << " to " << to_text(step.value)
            << ", spectrum " << static_cast<int>(sea.parameters.waves.front().spectrum);
    }
}

TEST(TakeMotion, HalvesWithTheFrameOrMoreForAnyStep) {
    for (const ParameterRef& ref : live_parameters()) {
        if (ref.info->dirties == Stage::foam) continue;
        Sea sea;
        sea.parameters = test::wind_sea(32, 200.0);
        sea.parameters.waves.front().spreading = SpreadingKind::cosine_squared;
        TakeEvent step{100.0, ref, std::string("donelan_banner")};
        if (ref.info->type() == "float") step.value = ref.info->soft_max;
        const double frame = moved(sea, step, 1.0 / 60.0);
        const double half = moved(sea, step, 1.0 / 120.0);
        const double tiny = moved(sea, step, 1.0 / 6000.0);
        EXPECT_GT(frame, 0.0) << ref.info->key;
        EXPECT_LT(half / frame, 0.6) << ref.info->key;
        EXPECT_LT(tiny / frame, 0.015) << ref.info->key;
    }
}

TEST(WaveSystems, ComeAndGoWithWhatATakePlaysOfThem) {
    Sea sea = sea_with({event(1.0, "waves.0.wind_speed", 11.0), event(2.0, "choppiness", 0.5)});
    add_wave_system(sea, "waves.1");
    sea.parameters.waves[1].wind_speed = 5.0;
    sea.take.events.push_back(event(3.0, "waves.1.wind_speed", 6.0));
    validate(sea);
    const auto played = [&] {
        std::vector<std::string> names;
        for (const TakeEvent& e : sea.take.events) {
            names.push_back(e.parameter.info->path(e.parameter.item));
        }
        return names;
    };
    using Names = std::vector<std::string>;
    add_wave_system(sea, "waves.0");
    EXPECT_EQ(sea.parameters.waves[2].wind_speed, 5.0);
    EXPECT_EQ(played(), (Names{"waves.1.wind_speed", "surface.choppiness", "waves.2.wind_speed"}));
    remove_wave_system(sea, "waves.1");
    EXPECT_EQ(sea.parameters.waves[1].wind_speed, 5.0);
    EXPECT_EQ(played(), (Names{"surface.choppiness", "waves.1.wind_speed"}));
    remove_wave_system(sea, "waves.1");
    EXPECT_EQ(played(), Names{"surface.choppiness"});
    validate(sea);

    for (const char* name : {"waves.0", "waves.1", "waves.", "waves.0x", "wave.0", ""}) {
        EXPECT_THROW(remove_wave_system(sea, name), Error) << name;
    }
    for (const char* name : {"waves.2", "waves.-1", "waves.99999999999", "0"}) {
        EXPECT_THROW(add_wave_system(sea, name), Error) << name;
    }
    while (sea.parameters.waves.size() < kMaxWaveSystems) add_wave_system(sea, "waves.1");
    EXPECT_THROW(add_wave_system(sea, "waves.1"), Error);
    EXPECT_EQ(played(), Names{"surface.choppiness"});
}

}  // namespace
}  // namespace ocean
