// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Beds of seas: placed by origin, unit, sign and level, refused with numbers, described to users.
#include "ocean/sea_bed.hpp"

#include "ocean/internal/grid.hpp"
#include "ocean/ocean.hpp"
#include "ocean/parameter_table.hpp"
#include "refusal.hpp"
#include "test_beds.hpp"

namespace ocean {
namespace {

/// Returns a beach that rises to the east: x / slope - depth, samples `cell` apart.
GivenBed beach(int nx, int ny, double cell, double depth = 10.0, double slope = 20.0) {
    return test::bed_of(nx, ny, cell, [=](double x, double) { return x / slope - depth; });
}

TEST(SeaBed, UnitSignAndLevelGiveHeightsOverStillWater) {
    Water water;
    water.seabed_unit = BedUnit::ft;
    water.seabed_sign = BedSign::down;
    water.level = 1.5;
    water.seabed_origin = {-100.0, 250.0};
    const auto bed = make_sea_bed(beach(41, 5, 10.0), water);
    EXPECT_EQ(bed->domain.origin, (std::array{-100.0, 250.0}));
    EXPECT_FALSE(bed->domain.wraps);
    EXPECT_EQ(bed->cell(), 10.0);
    // 40 samples of 10 m at 1:20 rise from -10 to 10: depths in feet.
    EXPECT_FLOAT_EQ(bed->heights.front(), static_cast<float>(10.0 * 0.3048 - 1.5));
    EXPECT_FLOAT_EQ(bed->heights[40], static_cast<float>(-10.0 * 0.3048 - 1.5));
    EXPECT_FLOAT_EQ(bed->given()[40], 10.0f);
}

TEST(SeaBed, AMovedBedComesBackToItsBits) {
    Parameters parameters = test::over({}, beach(33, 9, 3.7));
    const auto first = parameters.water.bed;
    set_parameter(parameters, "level", "0.1");
    EXPECT_NE(parameters.water.bed, first);
    EXPECT_EQ(parameters.water.bed->sha256, first->sha256) << "the identity is that of the file";
    EXPECT_FLOAT_EQ(parameters.water.bed->heights[7], first->heights[7] - 0.1f);
    set_parameter(parameters, "water.seabed_unit", "us_ft");
    set_parameter(parameters, "water.seabed_sign", "down");
    set_parameter(parameters, "water.seabed_origin", "[5, 6]");
    for (const char* name : {"level", "seabed_unit", "seabed_sign", "seabed_origin"}) {
        set_parameter(parameters, name, get_parameter(Parameters{}, name));
    }
    EXPECT_EQ(parameters.water.bed->heights, first->heights);
    EXPECT_EQ(parameters.water.bed->domain, first->domain);
}

TEST(SeaBed, WaterComparesBedsByTheirHeights) {
    const Parameters a = test::over({}, beach(33, 9, 5.0)), b = test::over({}, beach(33, 9, 5.0));
    const Parameters other = test::over({}, beach(33, 9, 5.0, 11.0)), none;
    EXPECT_EQ(a.water, b.water);
    EXPECT_NE(a.water, other.water);
    EXPECT_NE(a.water, none.water);
    EXPECT_EQ(first_dirty_stage(a, b), std::nullopt);
    EXPECT_EQ(first_dirty_stage(a, other), Stage::surface);
    Parameters foam = a;
    set_parameter(foam, "surf_foam_lifetime", "5");
    EXPECT_EQ(first_dirty_stage(a, foam), Stage::foam);
}

TEST(SeaBed, BadGridsAndHeightsAreRefusedWithNumbers) {
    const Water water;
    const auto says = [&](GivenBed given) {
        return test::message_of([&] { make_sea_bed(std::move(given), water); });
    };
    GivenBed oblong = beach(5, 5, 10.0);
    oblong.grid.size[1] = 60.0;
    const std::string not_square = says(oblong);
    EXPECT_TRUE(test::says(not_square, "10 m long to the east and 15 m to the north"));
    EXPECT_TRUE(test::says(says(beach(1, 5, 10.0)), "1 x 5 samples"));
    EXPECT_TRUE(test::says(says(beach(8193, 2, 1.0)), "8193 x 2 samples"));
    EXPECT_EQ(says(beach(8192, 2, 1.0, 300.0)), "");
    EXPECT_TRUE(test::says(says(beach(101, 2, 1001.0)), "100100 m x 1001 m"));
    EXPECT_EQ(says(beach(101, 2, 1000.0)), "");
    GivenBed torn = beach(5, 5, 10.0);
    torn.heights[7] = std::numeric_limits<float>::quiet_NaN();
    torn.heights[9] = -2e5f;
    EXPECT_TRUE(test::says(says(torn), {"2 of 25 heights", "x = 20 m, y = 10 m (column 2, row 1"}));
    torn.heights.resize(24);
    EXPECT_TRUE(test::says(says(torn), "24 heights"));
}

TEST(SeaBed, TheSummaryCountsWhatIsWetAndWhatWavesFeel) {
    Water water;
    water.depth = 5.0;
    const auto bed = make_sea_bed(beach(41, 3, 10.0), water);
    const SeaBedSummary facts = summarize(*bed, water);
    EXPECT_EQ(facts.samples, (std::array{41, 3}));
    EXPECT_EQ(facts.cell, 10.0);
    EXPECT_FLOAT_EQ(static_cast<float>(facts.lowest), -10.0f);
    EXPECT_FLOAT_EQ(static_cast<float>(facts.highest), 10.0f);
    EXPECT_DOUBLE_EQ(facts.wet, 20.0 / 41.0);     // samples 0 .. 19
    EXPECT_DOUBLE_EQ(facts.shallow, 9.0 / 41.0);  // samples 11 .. 19: above -5 m
    EXPECT_NEAR(facts.mean, 0.0, 1e-6);
}

TEST(SeaBed, WarningsNameAWrongSignUnitAndDatumAndNothingOfABeach) {
    Water water;
    water.depth = 30.0;
    const auto warnings = [&](const GivenBed& given) {
        return bed_warnings(*make_sea_bed(given, water), water);
    };
    EXPECT_TRUE(warnings(beach(41, 3, 10.0)).empty());
    const std::pair<GivenBed, const char*> kWrong[] = {
        {beach(400, 3, 10.0, 1.0), "heights may be depths"},
        {beach(41, 3, 10.0, -1.0), "land alone"},
        {beach(41, 3, 10.0, 25.0), "no shore"},
        {beach(41, 3, 10.0, 500.0), "another datum"},
        {beach(41, 3, 10.0, 500.0), "do not feel it"},
        {beach(41, 3, 10.0, -250.0), "more than 250 m above"},
        {beach(41, 3, 10.0, 10.0, 0.04), "check seabed_unit"},
        {beach(41, 3, 10.0, 0.01, 1e5), "less than on any coast"}};
    for (const auto& [given, words] : kWrong) EXPECT_TRUE(test::says(warnings(given), words));
}

TEST(SeaBed, ABedThatDoesNotSuitItsWavesIsWarnedOf) {
    const auto warnings_in = [](const GivenBed& given, const IncomingWaves& waves) {
        return coast_warnings(*test::over({}, given).water.bed, waves);
    };
    const auto warnings = [&](const GivenBed& given, double direction, double wavelength,
                              double period, double depth = 100.0) {
        return warnings_in(given, {{{"", wavelength, direction}}, wavelength, period, depth});
    };
    // 2 m of water in the west, dry land in the east.
    const GivenBed bed = beach(321, 11, 0.25, 2.0);
    EXPECT_TRUE(warnings(bed, 0.0, 3.9, 1000.0).empty());
    EXPECT_TRUE(
        test::says(warnings(bed, 0.0, 40.0, 1000.0), "half a peak wavelength, 20 m, down to 2 m"));
    EXPECT_TRUE(test::says(warnings(bed, kPi, 3.9, 1000.0), "no wave reaches the bed"));
    EXPECT_TRUE(test::says(warnings(bed, 0.0, 1.5, 1000.0), "are coarse for waves"));
    EXPECT_TRUE(test::says(warnings(bed, 0.0, 3.9, 15.0), "repeat every 15 m"));
    // Its western half is deeper than half a metre, which waves of 1.2 m feel and of 0.9 m do not.
    EXPECT_TRUE(
        test::says(warnings(bed, 0.0, 1.2, 1000.0, 0.5), "deeper than water.depth = 0.5 m"));
    EXPECT_FALSE(test::says(warnings(bed, 0.0, 0.9, 1000.0, 0.5), "deeper than"));
    EXPECT_TRUE(test::says(warnings(bed, 0.0, 90.0, 1000.0),
                           "80 m long, less than a peak wavelength, 90 m"));
    // The warning names the one of two systems that comes from the land.
    const std::vector<std::string> both =
        warnings_in(bed, {{{"waves.0", 3.9, 0.0}, {"waves.1", 3.9, kPi}}, 3.9, 1000.0, 100.0});
    EXPECT_TRUE(test::says(both, "the waves of waves.1 come in are land alone"));
    EXPECT_FALSE(test::says(both, "waves.0"));
}

/// Returns a bed of 41 x 31 samples 10 m apart, by a function of the place.
template <typename Height>
GivenBed small_bed(const Height& height) {
    return test::bed_of(41, 31, 10.0, height);
}

bool warns(const GivenBed& given, double degrees, const std::string& words, double depth = 20.0) {
    const IncomingWaves waves{{{"", 80.0, degrees * kPi / 180.0}}, 80.0, 1000.0, depth};
    return bool(test::says(coast_warnings(*test::over({}, given).water.bed, waves), words));
}

TEST(SeaBed, ABedThatIsUpsideDownIsRecognised) {
    constexpr char kWords[] =
        "water, 7.5 m deep in the mean: the bed may be upside down, which "
        "seabed_sign = \"down\" turns over";
    const auto plane = [](double x, double) { return 27.5 * x / 400.0 - 20.0; };
    const auto turned = [&](double x, double y) { return -plane(x, y); };
    EXPECT_TRUE(warns(small_bed(turned), 0.0, kWords));
    EXPECT_TRUE(warns(small_bed(turned), 0.0, "by sides that are 100 % land"));
    EXPECT_TRUE(warns(small_bed(turned), 30.0, "may be upside down"));
    EXPECT_TRUE(warns(small_bed(turned), -40.0, "may be upside down"));
    for (const double degrees : {0.0, 30.0, 90.0, -90.0}) {
        EXPECT_FALSE(warns(small_bed(plane), degrees, "upside down")) << degrees;
    }
}

TEST(SeaBed, CoastsWithLandAtTheirBordersAreNotTakenForUpsideDown) {
    const auto island = [](double x, double y) {
        return 12.0 - 0.15 * std::hypot(x - 200.0, y - 150.0);
    };
    // A lake or an atoll's lagoon, whose land reaches the borders; a bay with a deep, narrow mouth
    // and a shallow head; waves along a shore; a lagoon behind a barrier with an inlet.
    const auto lagoon = [&](double x, double y) { return -island(x, y); };
    const auto bay = [](double x, double y) {
        const bool is_mouth = x < 120.0 && std::abs(y - 150.0) > 60.0;
        return is_mouth ? 15.0 : 0.03 * x - 18.0;
    };
    const auto shore = [](double, double y) { return 0.1 * y - 20.0; };
    const auto barrier = [](double x, double y) {
        if (x < 60.0 && std::abs(y - 150.0) > 20.0) return 3.0;
        return x > 60.0 ? -2.5 : -4.0;
    };
    for (double degrees = -180.0; degrees < 180.0; degrees += 15.0) {
        EXPECT_FALSE(warns(small_bed(island), degrees, "upside down")) << degrees;
        EXPECT_FALSE(warns(small_bed(lagoon), degrees, "upside down")) << degrees;
    }
    EXPECT_FALSE(warns(small_bed(bay), 0.0, "upside down"));
    EXPECT_FALSE(warns(small_bed(barrier), 0.0, "upside down"));
    EXPECT_FALSE(warns(small_bed(shore), 0.0, "upside down"));
}

TEST(SeaBed, ADepthThatIsTheSeasInFeetIsAWarning) {
    const auto plane = [](double x, double) { return 27.5 * x / 400.0 - 20.0; };
    const auto feet = [&](double x, double y) { return plane(x, y) / 0.3048; };
    EXPECT_TRUE(warns(small_bed(feet), 0.0,
                      "it is 65.62 m deep where the waves come in, 3.28 times water.depth = 20 m"));
    EXPECT_FALSE(warns(small_bed(plane), 0.0, "seabed_unit"));
    EXPECT_FALSE(warns(small_bed(feet), 0.0, "seabed_unit", 66.0));
    EXPECT_FALSE(warns(small_bed(feet), 0.0, "seabed_unit", 22.0));
}

TEST(SeaBed, IncomingWavesAreThoseOfEachSystemThatHasEnergy) {
    Parameters parameters;
    parameters.waves.front().wind_direction = 180.0;
    const IncomingWaves one = incoming_waves(parameters);
    ASSERT_EQ(one.systems.size(), 1u);
    EXPECT_EQ(one.systems[0].name, "");
    EXPECT_NEAR(std::abs(one.systems[0].direction), kPi, 0.05);  // the table's own accuracy
    EXPECT_EQ(one.systems[0].peak_wavelength, one.peak_wavelength);
    parameters.waves.push_back(parameters.waves.front());
    parameters.waves.push_back(parameters.waves.front());
    parameters.waves[1].wind_speed = 0.0;
    parameters.waves[2].wind_direction = 0.0;
    const IncomingWaves two = incoming_waves(parameters);
    ASSERT_EQ(two.systems.size(), 2u);
    EXPECT_EQ(two.systems[1].name, "waves.2");
    EXPECT_NEAR(two.systems[1].direction, 0.0, 0.05);
}

TEST(SeaBed, HeightsOfARegionAreLinearAndGoOnBeyondTheBorder) {
    const Parameters parameters = test::over({}, beach(41, 3, 10.0));
    const SeaBed& bed = *parameters.water.bed;
    const Domain region{{-15.0, 5.0}, {450.0, 10.0}, {31, 2}, false};
    std::vector<float> heights(region.count());
    write_bed_heights(bed, region, heights);
    for (int i = 0; i < 31; ++i) {
        const double x = std::clamp(-15.0 + 15.0 * i, 0.0, 400.0);
        EXPECT_NEAR(heights[static_cast<std::size_t>(i)], x / 20.0 - 10.0, 1e-5);
    }
    ASSERT_EQ(region_warnings(bed, region).size(), 1u);
    // Three of 31 columns lie beyond the bed: x = -15, 405 and 420 .. 435 m.
    EXPECT_TRUE(
        test::says(region_warnings(bed, region)[0], "12.9 % of the region lies beyond the bed"));
    EXPECT_TRUE(region_warnings(bed, bed.domain).empty());
}

TEST(SeaBed, ASeaWithABedHasTheStateOfTheOpenSeaAndTheBed) {
    Parameters parameters = test::over({}, beach(33, 9, 5.0));
    parameters.grid.resolution = 32;
    Ocean sea(parameters, {.threads = 1});
    const SeaState state = sea.state();
    ASSERT_TRUE(state.bed.has_value());
    EXPECT_EQ(state.bed->sha256, parameters.water.bed->sha256);
    Parameters open = parameters;
    open.water.bed = nullptr;
    EXPECT_EQ(state.significant_wave_height.asked,
              Ocean(open, {.threads = 1}).state().significant_wave_height.asked);
}

TEST(SeaBed, TakesAndPerformancesOverABedAreRefused) {
    Parameters parameters = test::over({}, beach(33, 9, 5.0));
    parameters.grid.resolution = 32;
    Ocean sea(parameters, {.threads = 1});
    EXPECT_TRUE(test::says(test::message_of([&] { sea.perform(1.0, "wind_speed", "12"); }),
                           "plays no take"));
    Sea played{parameters, {}};
    EXPECT_NO_THROW(validate(played));
    const ParameterRef wind = find_parameter("wind_speed");
    played.take.events.push_back({1.0, wind, ParameterValue(12.0)});
    EXPECT_TRUE(test::says(test::message_of([&] { validate(played); }), "plays no take"));
}

TEST(SeaBed, RulesBetweenItsParametersAreChecked) {
    Parameters parameters = test::over({}, beach(33, 9, 5.0));
    EXPECT_NO_THROW(validate(parameters));
    parameters.water.level = 3.0;  // behind the back of set_parameter
    EXPECT_TRUE(test::says(test::message_of([&] { validate(parameters); }), "lies elsewhere"));
    Parameters unread;
    unread.water.seabed = "bed.asc";
    EXPECT_TRUE(test::says(test::message_of([&] { validate(unread); }), "has not been read"));
    Parameters lopsided;
    set_parameter(lopsided, "seabed_origin", "[5]");
    EXPECT_TRUE(test::says(test::message_of([&] { validate(lopsided); }), "has 1 numbers"));
}

}  // namespace
}  // namespace ocean
