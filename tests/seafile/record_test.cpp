// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Records once they are read: their sums, the choice of one, their list as JSON.

#include "helpers.hpp"

namespace ocean::test {
namespace {

const std::vector<SpectrumRecord>& buoy() {
    static const std::vector<SpectrumRecord> kRecords = read_spectra(kBuoy);
    return kRecords;
}

SpectrumRecord record_at(const std::string& time) {
    SpectrumRecord record;
    record.time = time;
    record.frequency = {0.1, 0.2, 0.4};
    record.density = {1.0, 3.0, 2.0};
    return record;
}

TEST(RecordSummary, EnergyIsTheTrapezoidOverTheListedFrequencies) {
    // (1 + 3)/2 * 0.1 + (3 + 2)/2 * 0.2
    EXPECT_NEAR(summarize(record_at("")).m0, 0.7, 1e-15);
    EXPECT_NEAR(summarize(record_at("")).peak_period, 5.0, 1e-15);
    EXPECT_TRUE(std::isnan(summarize(record_at("")).mean_direction));
}

TEST(RecordSummary, FirstBuoyRecordHasTheHeightOfItsOwnNumbers) {
    const RecordSummary summary = summarize(buoy().front());
    EXPECT_NEAR(4.0 * std::sqrt(summary.m0), 1.11885, 1e-4);
    EXPECT_EQ(summary.peak_period, 1.0 / 0.180);
}

TEST(RecordSummary, MeanDirectionIsWeightedByEnergy) {
    SpectrumRecord record = record_at("");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    record.a1 = {0.0, 0.5, nan};
    record.b1 = {0.5, 0.0, nan};
    record.a2 = record.b2 = {0.0, 0.0, nan};
    // Trapezoid weights 0.05 and 0.15: energies 0.05 to the north, 0.45 to the east.
    EXPECT_NEAR(summarize(record).mean_direction, std::atan2(0.05, 0.45), 1e-12);
}

TEST(RecordSummary, FullSpectrumHasTheDirectionAndSpreadOfItsDensity) {
    SpectrumRecord record = record_at("");
    // Half the energy of each frequency to 80 degrees, half to 100; uneven bins weigh by width.
    record.direction = {0.0, 70.0, 80.0, 90.0, 100.0, 110.0, 180.0, 270.0};
    for (const double s : record.density) {
        const double half = 0.5 * s / 10.0;
        record.directional_density.insert(record.directional_density.end(),
                                          {0.0, 0.0, half, 0.0, half, 0.0, 0.0, 0.0});
    }
    const double pi = std::numbers::pi;
    const RecordSummary summary = summarize(record);
    EXPECT_NEAR(summary.mean_direction, 0.5 * pi, 1e-12);
    EXPECT_NEAR(summary.directional_spread, std::sqrt(2.0 * (1.0 - std::cos(pi / 18.0))), 1e-12);
    EXPECT_TRUE(test::says(records_json({&record, 1}), "\"directions\": \"full\""));
}

TEST(RecordSummary, OfTheLeastEnergyIsFinite) {
    SpectrumRecord record;
    record.frequency = {0.04, 0.05, 0.06};
    record.density = {0.0, 5.9e-322, 0.0};  // m0 is the least number above 0, m1 is 0
    const RecordSummary summary = summarize(record);
    EXPECT_GT(summary.m0, 0.0);
    EXPECT_EQ(summary.mean_period, 0.0);
    EXPECT_EQ(summary.energy_period, 0.0);
}

TEST(RecordSummary, FlatSeaHasNoDirection) {
    SpectrumRecord record = record_at("");
    record.density = {0.0, 0.0, 0.0};
    record.direction = {0.0, 120.0, 240.0};
    record.directional_density.assign(9, 0.0);
    EXPECT_TRUE(std::isnan(summarize(record).mean_direction));
    EXPECT_TRUE(std::isnan(summarize(record).directional_spread));
}

/// Two stations at two times, 5 degrees apart across the date line, and one without a position.
std::vector<SpectrumRecord> several_places() {
    std::vector<SpectrumRecord> records;
    for (const char* time : {"2020-01-01T00:00", "2020-01-01T06:00"}) {
        for (const auto& [station, longitude] :
             {std::pair("west", 178.0), {"east", -177.0}, {"drifter", std::nan("")}}) {
            records.push_back(record_at(time));
            records.back().station = station;
            records.back().latitude = std::isnan(longitude) ? longitude : -40.0;
            records.back().longitude = longitude;
        }
    }
    return records;
}

TEST(RecordChoice, PlaceIsAStationOrTheNearestPosition) {
    const std::vector<SpectrumRecord> records = several_places();
    EXPECT_EQ(choose_record(records, {"", "east"}, "f").station, "east");
    EXPECT_EQ(choose_record(records, {"", "drifter"}, "f").time, "2020-01-01T00:00");
    const SpectrumRecord& late = choose_record(records, {"2020-01-01T06:10", "east"}, "f");
    EXPECT_EQ(late.station + late.time, "east2020-01-01T06:00");
    EXPECT_EQ(choose_record(records, {"", "-40.2,-177.1"}, "f").station, "east");
    EXPECT_EQ(choose_record(records, {"", " -40 , 183 "}, "f").station, "east") << "183 is -177";
    EXPECT_EQ(choose_record(records, {"", "-39.9,178.2"}, "f").station, "west");
}

TEST(RecordChoice, PlaceThatIsNotThereIsRefusedWithTheNearest) {
    const std::vector<SpectrumRecord> records = several_places();
    const auto refused = [&](const std::string& place) {
        return refusal_of([&] { choose_record(records, {"", place}, "b.txt"); });
    };
    EXPECT_TRUE(refused("wset").says("did you mean west"));
    EXPECT_TRUE(refused("zanzibar").says("the first is west"));
    EXPECT_TRUE(refused("-40,180").says("the nearest is at -40.0000,178.0000, 170 km away"));
    EXPECT_TRUE(refused("91,0").says("no station"));
    for (const char* place : {"wset", "-40,180", "91,0"}) {
        EXPECT_EQ(refused(place).kind, ErrorKind::not_found) << place;
    }
    std::vector<SpectrumRecord> nowhere = {record_at("")};
    const auto message = [&](const char* place) {
        return refusal_of([&] { choose_record(nowhere, {"", place}, "b.txt"); }).message;
    };
    EXPECT_TRUE(test::says(message("1,2"), "its records have no position"));
    EXPECT_TRUE(test::says(message("41010"), "its records have no station"));
}

TEST(RecordChoice, IsTheNearestWithinThirtyMinutes) {
    for (const auto& [asked, chosen] : {
             std::pair("", "2020-06-08T03:50"),  // the first
             {"2020-06-07T09:50", "2020-06-07T09:50"},
             {"2020-06-07T09:40:30Z", "2020-06-07T09:50"},
             {"2020-06-08 04:20", "2020-06-08T03:50"},
             {"2020-06-08T00:19", "2020-06-07T23:50"},
             {"2020-06-08T00:21", "2020-06-08T00:50"},
             {"2020-06-08T00:20", "2020-06-08T00:50"},  // between two, the first of the file
         }) {
        EXPECT_EQ(choose_record(buoy(), {asked, ""}, "f").time, chosen) << asked;
    }
}

TEST(RecordChoice, BeyondThirtyMinutesNamesTheNearest) {
    const Refusal refusal = refusal_of([] {
        choose_record(buoy(), {"2020-06-08T04:21", ""}, "b.txt");
    });
    EXPECT_EQ(refusal.kind, ErrorKind::not_found);
    EXPECT_TRUE(refusal.says("b.txt: ", "2020-06-08T04:21", "nearest is 2020-06-08T03:50"));
}

TEST(RecordChoice, CountsDaysAcrossMonthsAndLeapYears) {
    const std::vector<SpectrumRecord> records = {record_at("2020-02-28T23:50"),
                                                 record_at("2020-02-29T23:50")};
    EXPECT_EQ(choose_record(records, {"2020-03-01T00:10", ""}, "f").time, "2020-02-29T23:50");
}

TEST(RecordChoice, TextThatIsNoTimeIsRefused) {
    for (const char* text : {"2020", "2020-06-08", "2020-13-08T03:50", "2020-06-31T03:50",
                             "2020-06-08T03:50+25:00", "2020-06-08T3:50", "tomorrow"}) {
        const Refusal refusal = refusal_of([&] { choose_record(buoy(), {text, ""}, "f"); });
        EXPECT_EQ(refusal.kind, ErrorKind::invalid_value) << text;
        EXPECT_TRUE(refusal.says(text, "2020-06-08T03:50"));
    }
}

TEST(RecordChoice, IsMadeAnewForASystemWhoseRecordWasReset) {
    Sea sea =
        parse("[[waves]]\n[[waves]]\nspectrum = \"measured\"\nfile = \"ndbc_41010.data_spec\"\n");
    Parameters& parameters = sea.parameters;
    EXPECT_EQ(parameters.waves[1].measured->time, "2020-06-08T03:50");
    parameters.waves[1].record = "2020-06-05T18:50";
    resolve_files(sea, kData + "/spectra");
    EXPECT_EQ(parameters.waves[1].measured->time, "2020-06-08T03:50") << "one that is there stays";
    parameters.waves[1].measured.reset();
    resolve_files(sea, kData + "/spectra");
    EXPECT_EQ(parameters.waves[1].measured->time, "2020-06-05T18:50");
    EXPECT_EQ(parameters.waves[0].measured, nullptr);
    set_parameter(parameters, "waves.1.place", "41010");
    EXPECT_EQ(parameters.waves[1].measured, nullptr) << "another place is another record";
}

TEST(RecordChoice, ErrorsOfAFileAreOfTheParameterThatNamesIt) {
    Sea sea =
        parse("[[waves]]\n[[waves]]\nspectrum = \"measured\"\nfile = \"ndbc_41010.data_spec\"\n");
    WaveSystem& system = sea.parameters.waves[1];
    system.measured.reset();
    system.file = "waves.0.fetch = 5";
    const ErrorFields fields = refusal_of([&] { resolve_files(sea, "/nowhere"); }).fields;
    EXPECT_EQ(fields.parameter, "waves.1.file");
    EXPECT_EQ(fields.value, "\"waves.0.fetch = 5\"");
    EXPECT_EQ(fields.what, "/nowhere/waves.0.fetch = 5: no such file");
}

TEST(RecordChoice, ErrorsOfAnInlinedRecordAreOfWhatAsksForAnother) {
    const auto fields = [](const std::string& asked) {
        return refusal_of_sea(
                   "[[waves]]\nspectrum = \"measured\"\n" + asked +
                   "\n[waves.measured_record]\nfrequency = [0.1, 0.2]\ndensity = [1.0, 1.0]\n")
            .fields;
    };
    const ErrorFields time = fields("record = \"tomorrow\"");
    EXPECT_EQ(time.parameter, "waves.0.record");
    EXPECT_EQ(time.what, "is not a time");
    EXPECT_EQ(time.value, "\"tomorrow\"");
    const ErrorFields place = fields("place = \"41010\"");
    EXPECT_EQ(place.parameter, "waves.0.place");
    EXPECT_EQ(place.value, "\"41010\"");
}

TEST(RecordList, IsJsonWithEscapesAndNullForTheUnknown) {
    SpectrumRecord record = record_at("2020-06-08T03:50");
    record.station = "a\"b\\c\n\xFF";
    EXPECT_EQ(records_json({&record, 1}),
              "[\n {\"time\": \"2020-06-08T03:50\", \"station\": \"a\\\"b\\\\c\\u000A?\", "
              "\"latitude\": null, \"longitude\": null, \"depth\": null, "
              "\"significant_wave_height\": 3.3466401061363027, \"peak_period\": 5, "
              "\"energy_period\": 4.6428571428571415, \"mean_period\": 4, "
              "\"mean_direction\": null, \"coming_from\": null, \"directional_spread\": null, "
              "\"directions\": \"none\", \"frequencies\": 3, \"warnings\": []}\n]\n");
}

TEST(RecordList, GivesDirectionsInBothConventions) {
    SpectrumRecord record = record_at("");
    record.a1 = {0.0, 0.0, 0.0};
    record.b1 = {-0.5, -0.5, -0.5};  // to the south
    record.a2 = record.b2 = {0.0, 0.0, 0.0};
    const std::string json = records_json({&record, 1});
    EXPECT_TRUE(test::says(
        json, "\"mean_direction\": -90, \"coming_from\": 0, \"directional_spread\": 57.29"));
    EXPECT_TRUE(test::says(json, "\"directions\": \"moments\""));
}

}  // namespace
}  // namespace ocean::test
