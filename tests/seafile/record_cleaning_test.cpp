// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Artefacts that estimators leave in spectra and that no sea has: bins of 0 Hz, densities below 0.
// And the usable records of a file with a broken one.

#include "helpers.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/record_rules.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean::test {
namespace {

SpectrumRecord record_of(std::vector<double> frequency, std::vector<double> density) {
    SpectrumRecord record;
    record.frequency = std::move(frequency);
    record.density = std::move(density);
    return record;
}

SeaState state_of(const Parameters& parameters) {
    ThreadPool pool(1);
    return sea_state(make_directional_spectrum(parameters), parameters, pool);
}

SpectrumRecord with_fault(const std::string& time, const std::string& fault) {
    SpectrumRecord record;
    record.time = time;
    record.fault = fault;
    return record;
}

TEST(CleanRecord, ANegativeDensityCountsAsZeroAndTheEnergyStays) {
    SpectrumRecord record = record_of({0.1, 0.2, 0.3, 0.4}, {-0.2, 4.0, 2.0, -0.1});
    const double m0 = summarize(record).m0;
    clean_record(record);
    EXPECT_EQ(record_fault(record), "");
    EXPECT_EQ(record.density[0], 0.0);
    EXPECT_EQ(record.density[3], 0.0);
    EXPECT_NEAR(record.density[1] / record.density[2], 2.0, 1e-12) << "the shape stays";
    EXPECT_NEAR(summarize(record).m0, m0, 1e-12 * m0);
    ASSERT_EQ(record.warnings.size(), 1u);
    EXPECT_EQ(record.warnings[0],
              "2 of 4 densities are below 0, the lowest by 5.00 % of the highest: they count as 0, "
              "and the others keep the energy");
}

TEST(CleanRecord, OverDirectionsEachFrequencyKeepsItsEnergyToo) {
    SpectrumRecord record = record_of({0.1, 0.2}, {(4.0 - 0.2) * 90.0, 1.0 * 90.0});
    record.direction = {0, 90, 180, 270};
    record.directional_density = {4.0, 0.0, -0.2, 0.0, 0.5, 0.5, 0.0, 0.0};
    const double m0 = summarize(record).m0;
    clean_record(record);
    EXPECT_EQ(record_fault(record), "");
    EXPECT_NEAR(summarize(record).m0, m0, 1e-12 * m0);
    EXPECT_NEAR(record.directional_density[0], 3.8, 1e-12);
    EXPECT_EQ(record.directional_density[2], 0.0);
    EXPECT_NEAR(record.directional_density[4], 0.5, 1e-12);
    EXPECT_EQ(record.warnings.size(), 1u);
}

TEST(CleanRecord, ATenthOfThePeakIsTheMostThatIsNoise) {
    SpectrumRecord noise = record_of({0.1, 0.2, 0.3}, {1.0, 4.0, -0.4});
    clean_record(noise);
    EXPECT_EQ(record_fault(noise), "");
    SpectrumRecord wrong = record_of({0.1, 0.2, 0.3}, {1.0, 4.0, -0.41});
    clean_record(wrong);
    EXPECT_EQ(record_fault(wrong), "the density of bin 3 is not within 0 .. 1e6 m^2/Hz");
    EXPECT_TRUE(wrong.warnings.empty());
    SpectrumRecord upside_down = record_of({0.1, 0.2, 0.3}, {-1.0, -4.0, -1.0});
    clean_record(upside_down);
    EXPECT_NE(record_fault(upside_down), "");
}

TEST(CleanRecord, ABinOfZeroHertzIsLeftOutWithAllThatBelongsToIt) {
    SpectrumRecord record = record_of({0.0, 0.1, 0.2}, {7.0, 4.0, 2.0});
    record.a1 = record.b1 = record.a2 = record.b2 = {0.1, 0.2, 0.3};
    clean_record(record);
    EXPECT_EQ(record.frequency, (std::vector<double>{0.1, 0.2}));
    EXPECT_EQ(record.density, (std::vector<double>{4.0, 2.0}));
    EXPECT_EQ(record.a1, (std::vector<double>{0.2, 0.3}));
    EXPECT_EQ(record.b2, (std::vector<double>{0.2, 0.3}));
    ASSERT_EQ(record.warnings.size(), 1u);
    EXPECT_EQ(record.warnings[0],
              "a density of 7 m^2/Hz at 0 Hz, which is not a wave, is left out");
    SpectrumRecord grid = record_of({0.0, 0.1, 0.2}, {0.0, 360.0, 360.0});
    grid.direction = {0, 120, 240};
    grid.directional_density = {0, 0, 0, 1, 2, 3, 4, 5, 6};
    clean_record(grid);
    EXPECT_EQ(grid.directional_density, (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_TRUE(grid.warnings.empty()) << "nothing was lost";
}

TEST(RecordWithFault, IsToldOfBySeasThatTakeALaterRecord) {
    const auto reader = [](const std::string&) {
        std::vector<SpectrumRecord> records = {with_fault("2020-01-01T00:00", "f:3: wrong"),
                                               record_of({0.1, 0.2}, {1, 2})};
        records[1].time = "2020-01-01T03:00";
        return records;
    };
    const std::string waves = "libocean = 1\n[[waves]]\nspectrum = \"measured\"\nfile = \"f\"\n";
    const Sea first = parse_sea(waves, "s.toml", "", reader);
    const Sea chosen = parse_sea(waves + "record = \"2020-01-01T03:00\"\n", "s.toml", "", reader);
    const auto warnings = [](const Sea& sea) {
        return sea.parameters.waves.front().measured->warnings;
    };
    ASSERT_EQ(warnings(first).size(), 1u);
    EXPECT_EQ(warnings(first)[0],
              "is of 2020-01-01T03:00: an earlier record cannot be read "
              "(`ocean records` says why)");
    EXPECT_TRUE(warnings(chosen).empty()) << "it was asked for by its time";
    EXPECT_EQ(parse_sea(write_sea(first), "t.toml", "", reader)
                  .parameters.waves.front()
                  .measured->warnings,
              warnings(first))
        << "a saved sea says so too";
}

TEST(RecordWithFault, IsPassedOverOrSaysWhy) {
    const std::vector<SpectrumRecord> records = {with_fault("2020-01-01T00:00", "f:3: wrong"),
                                                 record_of({0.1, 0.2}, {1, 2})};
    EXPECT_EQ(choose_record(records, {}, "f").density[1], 2.0) << "none was asked for by its time";
    std::vector<SpectrumRecord> timed = records;
    timed[1].time = "2020-01-01T03:00";
    EXPECT_EQ(choose_record(timed, {"2020-01-01T03:00", ""}, "f").density[1], 2.0);
    EXPECT_EQ(message_of([&] {
                  choose_record(timed, {"2020-01-01T00:00", ""}, "f");
              }),
              "f:3: wrong; a record that can be read is that of 2020-01-01T03:00");
}

TEST(RecordWithFault, IsNoneOfTheListAndIsWarnedOf) {
    std::vector<SpectrumRecord> records = {with_fault("2020-01-01T00:00", "f:3: wrong"),
                                           record_of({0.1, 0.2}, {1, 2}),
                                           record_of({0.1, 0.2}, {1, 2})};
    records[1].warnings = {"something was assumed"};
    records[2].warnings = {"something was assumed"};
    const std::string json = records_json(records);
    EXPECT_FALSE(test::says(json, "2020-01-01T00:00"));
    EXPECT_TRUE(test::says(json, "\"warnings\": [\"something was assumed\"]"));
    const std::vector<std::string> warnings = records_warnings(records);
    ASSERT_EQ(warnings.size(), 3u);
    EXPECT_EQ(warnings[0], "record 2020-01-01T00:00: cannot be read: f:3: wrong");
    EXPECT_EQ(warnings[1], "2 of 3 records: something was assumed");
    EXPECT_TRUE(test::says(warnings[2], "2 of 3 records: has no directions"));
}

TEST(RecordWithFault, OfAManyTheFirstFiftyAreNamed) {
    std::vector<SpectrumRecord> records;
    for (int i = 0; i < 60; ++i) records.push_back(with_fault("", "f:" + std::to_string(i)));
    const std::vector<std::string> warnings = records_warnings(records);
    ASSERT_EQ(warnings.size(), 51u);
    EXPECT_EQ(warnings[50], "10 more warnings are left out");
    EXPECT_EQ(message_of([&] { require_readable(records); }), "f:0");
    records.push_back(record_of({0.1, 0.2}, {1, 2}));
    EXPECT_FALSE(refusal_of([&] { require_readable(records); }).refused);
}

TEST(RecordWarnings, ReachTheStateOfTheSeaAndItsFile) {
    const std::string body =
        "[grid]\nresolution = 64\n[[waves]]\nspectrum = \"measured\"\n[waves.measured_record]\n"
        "frequency = [0.1, 0.2, 0.3]\ndensity = [1.0, 2.0, 1.0]\n"
        "warnings = [\n \"the unit was a \\\"guess\\\"\",\n \"more\"]\n";
    const Sea sea = parse(body);
    EXPECT_EQ(sea.parameters.waves[0].measured->warnings,
              (std::vector<std::string>{"the unit was a \"guess\"", "more"}));
    const Sea again = parse_sea(write_sea(sea), "again.toml", "");
    EXPECT_EQ(difference(sea, again), "");
    const auto warnings = state_of(sea.parameters).warnings;
    EXPECT_EQ(std::ranges::count(warnings, "waves.0.file: the unit was a \"guess\""), 1);
    EXPECT_EQ(std::ranges::count(
                  warnings,
                  "waves.0.file has no directions: the waves travel to "
                  "waves.0.wind_direction = 0, to the east, spread as waves.0.spreading says"),
              1);
}

TEST(RecordWarnings, ASpectrumThatReadsNoFileSaysSo) {
    Parameters parameters;
    parameters.grid.resolution = 64;
    parameters.waves[0].file = "buoy.csv";
    parameters.waves[0].place = "north";
    const auto warnings = state_of(parameters).warnings;
    EXPECT_EQ(std::ranges::count(
                  warnings, "waves.0.file has no effect: spectrum = \"measured\" alone reads it"),
              1);
    EXPECT_EQ(std::ranges::count(
                  warnings, "waves.0.place has no effect: spectrum = \"measured\" alone reads it"),
              1);
}

TEST(RecordWarnings, OfASeaFileAreFewAndShort) {
    const std::string head = "[[waves]]\n[waves.measured_record]\nwarnings = ";
    std::string many = "[";
    for (int i = 0; i < 17; ++i) many += "\"a\",";
    const std::string allowed = "an array of at most 16 texts of at most 500 bytes";
    for (const std::string& value : {many + "]", "[\"" + std::string(501, 'x') + "\"]",
                                     std::string("[1]"), std::string("\"a\"")}) {
        EXPECT_TRUE(refusal_of_sea(head + value).says("test.toml:4: ", allowed));
    }
}

TEST(RecordWarnings, ASpreadNarrowerThanASeaHoldsIsToldWithBoth) {
    const auto state = [](const std::string& moments) {
        return state_of(parse("[grid]\nresolution = 64\n[[waves]]\nspectrum = "
                              "\"measured\"\n[waves.measured_record]\n"
                              "frequency = [0.1, 0.2, 0.3]\ndensity = [1.0, 2.0, 1.0]\n" +
                              moments)
                            .parameters);
    };
    // A spread of 0: cos^2s of s = 200 has sqrt(2 (1 - 200/201)) = 5.7 degrees.
    const SeaState narrow = state(
        "a1 = [1.0, 1.0, 1.0]\nb1 = [0.0, 0.0, 0.0]\na2 = [nan, nan, nan]\nb2 = [nan, nan, nan]\n");
    EXPECT_NEAR(narrow.directional_spread.asked, 5.7, 0.1);
    EXPECT_EQ(
        std::ranges::count(narrow.warnings,
                           "waves.0.file has a directional spread of 0.0 degrees, narrower than "
                           "any sea: 5.7 is used"),
        1);
    EXPECT_FALSE(says(state("a1 = [0.9, 0.9, 0.9]\nb1 = [0.0, 0.0, 0.0]\na2 = [nan, nan, nan]\n"
                            "b2 = [nan, nan, nan]\n")
                          .warnings,
                      "narrower than any sea"));
}

}  // namespace
}  // namespace ocean::test
