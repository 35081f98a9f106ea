// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The convention of a NetCDF file's directions: words, their order, writers that need none, and
// SWAN, whose words are wrong.
#include "direction_sense.hpp"

#include "contents.hpp"

namespace ocean::netcdf {
namespace {

constexpr const char* kTo = "sea_surface_wave_to_direction";
constexpr const char* kFrom = "sea_surface_wave_from_direction";

TEST(DirectionWords, SayWhetherWavesComeFromOrTravelTo) {
    for (const char* text : {
             kFrom,
             "sea_surface_primary_swell_wave_from_direction",
             "sea surface wave from direction",
             "wave direction, coming from",
             "Wave direction (coming from)",
             "degree_true, from",
             "degrees true from",
             "direction from which waves come",
             "direction the waves come from, clockwise from true north",
             "wave directions from, clockwise from true north",
             "mean wave direction, from, clockwise from north",
             "band a1 Fourier coefficient, coming from, north",
             "waves are coming from the north at 0 degrees",
             "direction of wave propagation, coming from",
             "wave from direction relative true north",
             "0 = from north, 90 = from east",
             "nautical convention",
             "meteorological convention",
             "Nautical",
             "coming-from",
             "direction in which the waves are coming",
             "direction of origin",
             "from",
         }) {
        EXPECT_EQ(direction_words(text).from, std::optional(true)) << text;
        EXPECT_NE(direction_words(text).from_east, std::optional(true)) << text;
    }
    for (const char* text : {
             kTo,
             "sea surface wave to direction",
             "wave direction, going to",
             "degree_true, to",
             "direction to which waves travel",
             "direction towards which waves propagate",
             "travelling to, clockwise from north",
             "traveling towards",
             "direction of propagation",
             "wave propagation direction",
             "oceanographic convention",
             "oceanographical",
             "heading to",
             "where the waves are going",
             "direction in which the waves are travelling",
             "to",
         }) {
        EXPECT_EQ(direction_words(text).from, std::optional(false)) << text;
    }
    for (const char* text : {
             "",
             "direction",
             "wave direction",
             "degree",
             "degrees_true",
             "degrees clockwise from north",
             "degrees from true north",
             "direction relative to true north",
             "direction, measured clockwise from north",
             "mean wave direction from spectral moments",
             "mean direction from first Fourier moments",
             "principal wave direction from the second spectral moment",
             "derived from a1 and b1",
             "coming from or going to",
         }) {
        EXPECT_EQ(direction_words(text).from, std::nullopt) << text;
    }
}

TEST(DirectionWords, SayWhereAnglesAreMeasuredFrom) {
    for (const char* text :
         {"counter-clockwise from east", "anticlockwise from the x-axis", "ccw from x",
          "radians, counterclockwise from east", "Cartesian", "mathematical convention"}) {
        const DirectionWords said = direction_words(text);
        EXPECT_EQ(said.counter_clockwise, std::optional(true)) << text;
        EXPECT_EQ(said.from_east, std::optional(true)) << text;
    }
    for (const char* text : {"clockwise from north", "degrees cw from true north"}) {
        const DirectionWords said = direction_words(text);
        EXPECT_EQ(said.counter_clockwise, std::optional(false)) << text;
        EXPECT_EQ(said.from_east, std::optional(false)) << text;
    }
    EXPECT_EQ(direction_words("cartesian").from, std::optional(false)) << "as SWAN has it";
    EXPECT_EQ(direction_words("cartesian, coming from").from, std::optional(true));
}

TEST(DirectionSense, AnglesAndMomentsBecomeThoseOfTheTravelDirection) {
    // 30 degrees: from north-north-east to south-south-west is 240 degrees from east.
    EXPECT_DOUBLE_EQ(kComingFrom.travel(30.0), 240.0);
    EXPECT_DOUBLE_EQ(kTravellingTo.travel(30.0), 60.0);
    EXPECT_DOUBLE_EQ(kTravellingToFromEast.travel(30.0), 30.0);
    const DirectionSense odd = {true, true, true};  // coming from, counter-clockwise from east
    EXPECT_DOUBLE_EQ(odd.travel(30.0), 210.0);
    for (const DirectionSense& sense : {kComingFrom, kTravellingTo, kTravellingToFromEast, odd}) {
        for (const int n : {1, 2}) {
            const auto measured = std::polar(0.8, n * 30.0 * kDegree);
            const auto wanted = std::polar(0.8, n * sense.travel(30.0) * kDegree);
            EXPECT_NEAR(std::abs(sense.travel_moment(measured, n) - wanted), 0.0, 1e-12);
        }
    }
}

struct Said {
    const char* key;
    const char* text;
};

/// The travel direction of the waves in the bin of 30 degrees, and the warnings, of wavespectra
/// content whose directions are called `direction`.
struct Read {
    double travel = kMissing;
    std::string warnings;
};
Read read_with(std::initializer_list<Said> of_directions,
               std::initializer_list<Said> of_spectrum = {},
               std::initializer_list<Said> of_file = {}) {
    Content content = wavespectra();
    for (const auto& [key, text] : of_file) content.attributes[key] = text;
    Variable& efth = find(content, "efth");
    for (const auto& [key, text] : of_spectrum) efth.attributes[key] = text;
    for (std::size_t i = 0; i < 32; ++i) efth.values[i] = i % 4 == 0 ? 1.0 : 0.0;
    Variable& direction = find(content, "dir");
    direction.name = "direction";
    for (double& d : direction.values) d += 30.0;
    for (const auto& [key, text] : of_directions) direction.attributes[key] = text;
    const SpectrumRecord record = records_from(content).front();
    Read read;
    for (std::size_t j = 0; j < 4; ++j) {
        if (record.directional_density[j] > 0.0) read.travel = record.direction[j];
    }
    for (const std::string& warning : record.warnings) read.warnings += warning;
    return read;
}

TEST(DirectionSense, TheNearestWordCounts) {
    constexpr double kIsFrom = 240.0;
    constexpr double kIsTo = 60.0;
    const auto expect = [](const Read& read, double travel, const std::string& warning = "") {
        EXPECT_NEAR(read.travel, travel, 1e-9) << read.warnings;
        EXPECT_EQ(read.warnings.empty(), warning.empty()) << read.warnings;
        EXPECT_TRUE(test::says(read.warnings, warning));
    };
    expect(read_with({}), kIsFrom, "nothing in the file says whether waves come from");
    expect(read_with({{"units", "degree_true, from"}}), kIsFrom);
    expect(read_with({{"long_name", "wave direction, coming from"}}), kIsFrom);
    expect(read_with({{"long_name", "sea surface wave to direction"}}), kIsTo);
    expect(read_with({{"convention", "oceanographic"}}), kIsTo);
    expect(read_with({{"direction_convention", "going to"}}), kIsTo);
    expect(read_with({{"comment", "direction towards which the waves travel"}}), kIsTo);
    expect(read_with({}, {{"comment", "directions are those that waves travel to"}}), kIsTo);
    expect(read_with({}, {{"direction_convention", "oceanographic"}}), kIsTo);
    expect(read_with({}, {}, {{"wave_direction_convention", "oceanographic"}}), kIsTo);
    expect(read_with({}, {}, {{"comment", "Wave directions are towards."}}), kIsTo);
    expect(read_with({}, {}, {{"summary", "Buoys of 2020. Directions are oceanographic (to)."}}),
           kIsTo);
    expect(read_with({}, {}, {{"summary", "Spectra of waves to the coast, from 1979 to 2020"}}),
           kIsFrom, "nothing in the file says");
    expect(read_with({}, {}, {{"comment", "Wind direction: going to. Waves by WAM."}}), kIsFrom,
           "nothing in the file says");
    expect(read_with({{"standard_name", kTo}}, {}, {{"direction_convention", "nautical"}}), kIsTo);
    expect(read_with({{"standard_name", kFrom}, {"long_name", "going to"}}), kIsFrom,
           "standard_name and long_name of direction contradict each other");
    // Counter-clockwise from east, travelling to: 30 degrees as they are.
    expect(read_with({{"standard_name", kTo}, {"comment", "counter-clockwise from east"}}), 30.0);
    expect(read_with({{"long_name", "coming from, cartesian"}}), 210.0);
}

TEST(DirectionSense, WavewatchTravelsToWithoutAWord) {
    EXPECT_NEAR(read_with({}, {{"globwave_name", "directional_variance_spectral_density"}}).travel,
                60.0, 1e-9);
    for (const Said said :
         {Said{"WAVEWATCH_III_version_number", "6.07"}, Said{"product_name", "ww3.201001_spec.nc"},
          Said{"source", "WAVEWATCH III"}}) {
        const Read read = read_with({}, {}, {said});
        EXPECT_NEAR(read.travel, 60.0, 1e-9) << said.key;
        EXPECT_EQ(read.warnings, "") << said.key;
    }
}

TEST(DirectionSense, BinsWithoutAUnitAreRadiansWhereTheyAreSoNarrow) {
    Content content = wavespectra();
    find(content, "dir").attributes.clear();
    for (double& d : find(content, "dir").values) d *= kDegree;
    const SpectrumRecord record = records_from(content).front();
    EXPECT_NEAR(value_from(record, 0, 90.0), 1.0, 1e-9);
    ASSERT_EQ(record.warnings.size(), 1u);
    EXPECT_TRUE(test::says(record.warnings[0], "taken as radians"));
}

/// SWAN's own: 16-bit densities per radian with a scale, over radians.
Content swan(const std::string& convention) {
    Content content;
    content.attributes = {{"Conventions", "CF-1.5"}, {"Directional_convention", convention}};
    content.dimensions = {{"time", 1}, {"points", 2}, {"direction", 4}, {"frequency", 2}};
    std::vector<double> values(16, 0.0);
    values[1 * 2 + 1] = 2000.0;  // the first point, from or to 90 degrees, at 0.2 Hz
    values[8 + 3 * 2 + 0] = 3000.0;
    content.variables = {
        numbers("time", {0}, {{"units", "seconds since 1970-01-01"}, {"calendar", "julian"}},
                {1709294400.0}),
        numbers("frequency", {3}, {{"units", "s-1"}, {"standard_name", "wave_frequency"}},
                {0.1, 0.2}),
        numbers("longitude", {1}, {{"units", "degrees_east"}}, {4.0, 5.0}),
        numbers("latitude", {1}, {{"units", "degrees_north"}}, {52.0, 53.0}),
        numbers("direction", {2}, {{"units", "radians"}, {"standard_name", kTo}},
                {0.0, 90.0 * kDegree, 180.0 * kDegree, 270.0 * kDegree}),
        numbers("density", {0, 1, 2, 3},
                {{"units", "m2 s rad-1"},
                 {"standard_name", "sea_surface_wave_directional_variance_spectral_density"}},
                values),
        numbers("scale_density", {0, 1}, {{"units", "1"}}, {1e-3, 1e-4}),
    };
    return content;
}

TEST(Swan, ScalesItsDensitiesAndMeansWhatItsConventionSays) {
    for (const char* nautical : {"nautical", "meteorological"}) {
        const std::vector<SpectrumRecord> records = records_from(swan(nautical));
        ASSERT_EQ(records.size(), 2u);
        EXPECT_EQ(records[0].time, "2024-03-01T12:00") << "its 'julian' is the usual calendar";
        EXPECT_NEAR(value_from(records[0], 1, 90.0), 2.0 * kDegree, 1e-12);
        EXPECT_NEAR(value_from(records[1], 0, 270.0), 0.3 * kDegree, 1e-12);
        EXPECT_TRUE(records[0].warnings.empty());
    }
    // Counter-clockwise from x, travelling to 90 degrees: to the north, from the south.
    const SpectrumRecord cartesian = records_from(swan("cartesian")).front();
    EXPECT_NEAR(value_from(cartesian, 1, 180.0), 2.0 * kDegree, 1e-12);
    EXPECT_TRUE(cartesian.warnings.empty());
}

TEST(Swan, WithoutItsConventionIsTakenAsComingFromWithAWarning) {
    Content content = swan("");
    content.attributes.clear();
    const SpectrumRecord record = records_from(content).front();
    EXPECT_NEAR(value_from(record, 1, 90.0), 2.0 * kDegree, 1e-12);
    ASSERT_EQ(record.warnings.size(), 1u);
    EXPECT_TRUE(test::says(record.warnings[0], "nothing in the file says"));
}

TEST(Swan, HasADirectionAndASpreadInEachFrequencyOfA1dSpectrum) {
    Content content = swan("meteorological");
    content.variables.resize(4);  // no directions
    content.variables.push_back(
        numbers("energy_1d", {0, 1, 3}, {{"units", "m2 s"}}, {1000.0, 2000.0, 3000.0, 4000.0}));
    content.variables.push_back(numbers("scale_energy_1d", {0, 1}, {}, {1e-3, 1e-2}));
    content.variables.push_back(
        numbers("theta_1d", {0, 1, 3}, {{"units", "degree"}}, {200.0, 200.0, 90.0, kMissing}));
    content.variables.push_back(
        numbers("spread_1d", {0, 1, 3}, {{"units", "degree"}}, {30.0, 30.0, 30.0, 30.0}));
    const auto expect = [&](double travel) {
        const std::vector<SpectrumRecord> records = records_from(content);
        EXPECT_EQ(records[0].density, (std::vector<double>{1.0, 2.0}));
        EXPECT_EQ(records[1].density, (std::vector<double>{30.0, 40.0}));
        const double r1 = 1.0 - 0.5 * std::pow(30.0 * kDegree, 2);
        ASSERT_TRUE(records[0].has_moments());
        EXPECT_NEAR(records[0].a1[0], r1 * std::cos(travel * kDegree), 1e-12);
        EXPECT_NEAR(records[0].b1[0], r1 * std::sin(travel * kDegree), 1e-12);
        EXPECT_TRUE(std::isnan(records[1].a1[1]));
        EXPECT_TRUE(records[0].warnings.empty());
    };
    expect(70.0);  // from 200
    content.attributes["Directional_convention"] = "cartesian";
    expect(200.0);
}

}  // namespace
}  // namespace ocean::netcdf
