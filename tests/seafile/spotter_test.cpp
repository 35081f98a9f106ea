// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The readers of Spotter files against the text of such files, CSV and JSON: values, moments and
// directions, missing values, the buoy's own heights and periods, and broken files.
#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "helpers.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/grid.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

const std::string kSpotterCsvFile = kData + "/spectra/spotter_20210929b.csv";
const std::string kSpotterJsonFile = kData + "/spectra/spotter_20180214.json";

/// Two spectra of three bins; between them one of a time without spectrum.
const std::string kCsvFile =
    "Power (W) ,Epoch Time ,Latitude (deg) ,Longitude (deg) ,f_0 ,f_1 ,f_2 ,df_0 ,df_1 ,df_2 ,"
    "a1_0 ,a1_1 ,a1_2 ,b1_0 ,b1_1 ,b1_2 ,a2_0 ,a2_1 ,a2_2 ,b2_0 ,b2_1 ,b2_2 ,"
    "varianceDensity_0 ,varianceDensity_1 ,varianceDensity_2 ,direction_0 ,direction_1 ,"
    "direction_2 ,directionalSpread_0 ,directionalSpread_1 ,directionalSpread_2 ,Wind\n"
    "-0.3 ,1630901521 ,36.7 ,-121.9 ,0.1 ,0.2 ,0.4 ,.1 ,.1 ,.2 ,0.8 ,0 ,-0.8 ,0 ,0.8 ,0 ,0.5 ,"
    "-0.5 ,0.5 ,0.1 ,0.1 ,0.1 ,1.5 ,2.5 ,0.5 ,270 ,180 ,90 ,36 ,36 ,36 ,-\n"
    "-0.3 ,1630890721 ,36.7 ,-121.9 ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,- ,"
    "- ,- ,- ,- ,- ,- ,- ,-\n"
    "-0.3 ,1630879921 ,-36.7 ,238.1 ,0.1 ,0.2 ,0.4 ,.1 ,.1 ,.2 ,0.8 ,0 ,-0.8 ,0 ,0.8 ,0 ,0.5 ,"
    "- ,0.5 ,0.1 ,0.1 ,0.1 ,1.5 ,2.5 ,- ,270 ,180 ,90 ,36 ,36 ,36 ,-\n";

const std::string kJsonSpectrum =
    "{\"timestamp\": \"2018-02-14T00:27:19.000Z\", \"latitude\": -61.0, \"longitude\": 173.4,\n"
    "  \"frequency\": [0.1, 0.2, 0.4],\n"
    "  \"varianceDensity\": [1.5, 2.5, 1],\n"
    "  \"a1\": [0.8, 0, -0.8],\n"
    "  \"b1\": [0, 0.8, 0],\n"
    "  \"a2\": [0.5, -0.5, 0.5],\n"
    "  \"b2\": [0.1, 0.1, 0.1],\n"
    "  \"direction\": [270, 180, 90],\n"
    "  \"directionalSpread\": [36, 36, 36]}";
/// The list is on line 3, the spectrum on lines 4 to 12.
const std::string kJsonFile =
    "{\"status\": {\"deep\": [[{\"frequencyData\": 1}]]},\n"
    "\"data\": {\"waves\": [{\"timestamp\": 0}],\n"
    "\"frequencyData\": [\n" +
    kJsonSpectrum + "\n], \"limit\": null, \"spotterId\": \"SPOT-0070\"}}\n";

std::vector<SpectrumRecord> read_csv(const std::string& content) {
    return read_spectra_from({content, "s.csv", {}});
}
std::vector<SpectrumRecord> read_json(const std::string& content) {
    return read_spectra_from({content, "s.json", {}});
}
/// Without the first `from` up to the next `to`.
std::string without(std::string content, const std::string& from, const std::string& to) {
    const std::size_t begin = content.find(from);
    return content.erase(begin, content.find(to, begin) + to.size() - begin);
}

double height(const SpectrumRecord& record) {
    return 4.0 * std::sqrt(summarize(record).m0);
}

TEST(SpotterCsv, ReadsWhatTheFileSays) {
    const std::vector<SpectrumRecord> records = read_spectra(kSpotterCsvFile);
    ASSERT_EQ(records.size(), 21u);
    const SpectrumRecord& first = records[0];
    EXPECT_EQ(first.time, "2021-09-06T04:12") << "1630901521";
    EXPECT_EQ(first.latitude, 36.73995);
    EXPECT_EQ(first.longitude, -121.88488);
    ASSERT_EQ(first.frequency.size(), 39u);
    EXPECT_EQ(first.frequency[20], 0.22461);
    EXPECT_EQ(first.density[20], 0.27106611199999997);
    EXPECT_EQ(first.a1[20], 0.845552);
    EXPECT_EQ(first.b1[20], -0.335288);
    EXPECT_EQ(first.a2[20], 0.631476);
    EXPECT_EQ(first.b2[20], -0.592375);
    EXPECT_EQ(records.back().time, "2021-09-03T16:12");
}

TEST(SpotterCsv, HeightAndPeriodAreThoseThatTheBuoyReports) {
    const std::vector<SpectrumRecord> records = read_spectra(kSpotterCsvFile);
    // The first, second, fourth and last line. The buoy sums bins, libocean uses the trapezoid
    // rule.
    for (const auto& [line, hs, tp] :
         {std::tuple{0, 0.878, 9.309}, {1, 0.835, 9.309}, {3, 0.653, 5.689}, {20, 0.242, 3.2}}) {
        const SpectrumRecord& record = records[static_cast<std::size_t>(line)];
        EXPECT_NEAR(height(record) / hs, 1.0, 0.005) << line;
        EXPECT_NEAR(summarize(record).peak_period, tp, 0.001) << line;
    }
}

TEST(SpotterCsv, MomentsAreOfTheTravelDirectionAndAgreeWithTheDirectionsInTheFile) {
    // "direction_20 291.6298853604316, directionalSpread_20 24.362198334519082", coming from.
    const SpectrumRecord first = read_spectra(kSpotterCsvFile).front();
    const double travel = std::atan2(first.b1[20], first.a1[20]) / kDegree;
    EXPECT_NEAR(coming_from(travel), 291.6298853604316, 1e-9);
    const double r1 = std::hypot(first.a1[20], first.b1[20]);
    EXPECT_NEAR(std::sqrt(2.0 * (1.0 - r1)) / kDegree, 24.362198334519082, 1e-9);
}

TEST(SpotterCsv, AMinusIsMissingAndATimeWithoutSpectrumIsNoRecord) {
    const std::vector<SpectrumRecord> records = read_csv(kCsvFile);
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0].a1, (std::vector<double>{0.8, 0.0, -0.8}));
    EXPECT_EQ(records[1].time, "2021-09-05T22:12");
    EXPECT_EQ(records[1].longitude, 238.1);
    EXPECT_EQ(records[1].frequency, (std::vector<double>{0.1, 0.2})) << "the third has no density";
    EXPECT_EQ(records[1].b2[0], 0.1);
    EXPECT_TRUE(std::isnan(records[1].a1[1]) && std::isnan(records[1].b2[1])) << "a2 is missing";
}

TEST(SpotterCsv, WithoutAnySpectrumThereIsNoRecord) {
    const std::size_t first = kCsvFile.find('\n') + 1;
    const std::size_t second = kCsvFile.find('\n', first) + 1;
    const std::string missing = kCsvFile.substr(second, kCsvFile.find('\n', second) + 1 - second);
    for (const std::string& rows : {std::string(), missing, missing + missing}) {
        const Refusal refusal = refusal_of([&] { read_csv(kCsvFile.substr(0, first) + rows); });
        EXPECT_TRUE(refusal.says("s.csv: holds no spectrum")) << refusal.message;
    }
}

TEST(SpotterCsv, WithoutMomentsTheMeanAndTheSpreadCount) {
    std::string content = kCsvFile;
    for (const char* name : {"a2_0", "a2_1", "a2_2"}) content = replaced(content, name, "x");
    const SpectrumRecord record = read_csv(content).front();
    const double r1 = 1.0 - 0.5 * std::pow(36.0 * kDegree, 2);
    // From the west, the south and the east: to the east, the north and the west.
    EXPECT_NEAR(record.a1[0], r1, 1e-12);
    EXPECT_NEAR(record.b1[1], r1, 1e-12);
    EXPECT_NEAR(record.a1[2], -r1, 1e-12);
    EXPECT_TRUE(std::isnan(record.a2[0]));
    for (const char* name : {"direction_0", "direction_1", "direction_2"}) {
        content = replaced(content, name, "x");
    }
    EXPECT_FALSE(read_csv(content).front().has_moments());
}

TEST(SpotterCsv, BrokenFilesAreRefusedWithTheirLine) {
    const std::tuple<std::string, std::string, int, std::string> broken[] = {
        {"Epoch Time", "Local Time", 1, "the column Epoch Time is missing"},
        {"Latitude (deg)", "Lat", 1, "need each other"},
        {"f_1 ", "f_0 ", 1, "the column f_0 appears twice"},
        {"b1_1", "b1_3", 1, "the column b1_1 is missing"},
        {"a2_2", "a2", 2, "2 values of a2 for 3 frequencies"},
        {",1630901521", ",yesterday", 2, "'yesterday' is not a number"},
        {",1630901521", ",1e12", 2, "an Epoch Time of '1e12'; allowed"},
        {",1630901521", ",-", 2, "an Epoch Time of '-'"},
        {",36.7", ",96.7", 2, "a latitude of 96.7; allowed: -90 .. 90"},
        {",-121.9", ",-221.9", 2, "a longitude of -221.9"},
        {",0.2 ", ",0.05 ", 2, "the frequencies do not ascend at bin 2"},
        {",0.2 ", ",200 ", 2, "a frequency of 200; allowed: 1e-5 .. 100 Hz"},
        {",2.5 ", ",-2e6 ", 2, "a density of -2e6; allowed: 0 .. 1e6 m^2/Hz"},
        {",2.5 ", ",inf ", 2, "'inf' is not a number"},
        {",0.8 ", ",1.8 ", 2, "a moment of 1.8; allowed: -1 .. 1"},
        {",180 ", ",1800 ", 2, "a direction of 1800"},
        {",36 ", ",-36 ", 2, "a spread of -36; allowed: 0 .. 180 degrees"},
        {",36 ", ",36,36 ", 2, "more fields than the header line has columns"},
        {",36 ", "", 2, "fewer fields"},
        {",2.5 ", ",\"2.5 ", 2, "a quote is not closed"},
    };
    for (const auto& [from, to, line, words] : broken) {
        const Refusal refusal =
            first_fault_of([text = replaced(kCsvFile, from, to)] { return read_csv(text); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file) << to;
        const std::string where = "s.csv:" + std::to_string(line) + ": ";
        EXPECT_TRUE(refusal.says(where) && refusal.says(words)) << to << ": " << refusal.message;
    }
    const Refusal cut =
        first_fault_of([] { return read_csv(kCsvFile.substr(0, kCsvFile.size() - 20)); });
    EXPECT_TRUE(cut.says("s.csv:4: the file ends within this line")) << cut.message;
}

TEST(SpotterJson, ReadsWhatTheFileSays) {
    const std::vector<SpectrumRecord> records = read_spectra(kSpotterJsonFile);
    ASSERT_EQ(records.size(), 8u);
    const SpectrumRecord& first = records[0];
    EXPECT_EQ(first.station, "SPOT-0070");
    EXPECT_EQ(first.time, "2018-02-14T00:27") << "of the spectrum, not of the heights beside it";
    EXPECT_EQ(records[7].time, "2018-02-14T21:27");
    EXPECT_EQ(first.latitude, -61.09224);
    EXPECT_EQ(first.longitude, 173.41791);
    ASSERT_EQ(first.frequency.size(), 39u);
    EXPECT_EQ(first.frequency[7], 0.09766);
    EXPECT_EQ(first.density[7], 2.3435735039999996);
    EXPECT_EQ(first.a1[7], 0.337243);
    EXPECT_EQ(first.b1[7], -0.194526);
    EXPECT_EQ(first.a2[7], 0.366569);
    EXPECT_EQ(first.b2[7], -0.325513);
}

TEST(SpotterJson, HeightPeriodAndDirectionAreThoseThatTheBuoyReports) {
    const std::vector<SpectrumRecord> records = read_spectra(kSpotterJsonFile);
    const double heights[] = {1.62, 1.67, 1.6, 2.43, 2.39, 2.2, 2.28, 2.32};
    const double directions[] = {349.21, 355.16, 6.85, 295.79, 285.6, 287.57, 285.67, 287.82};
    for (std::size_t i = 0; i < records.size(); ++i) {
        EXPECT_NEAR(height(records[i]), heights[i], 0.01) << i;
        const double from = coming_from(summarize(records[i]).mean_direction / kDegree);
        EXPECT_NEAR(std::remainder(from - directions[i], 360.0), 0.0, 0.5) << i;
    }
    EXPECT_NEAR(summarize(records[0]).peak_period, 10.24, 0.005);
}

TEST(SpotterJson, CsvAndJsonOfTheSameSpectrumAreTheSame) {
    const SpectrumRecord csv = read_csv(kCsvFile).front();
    const SpectrumRecord json = read_json(kJsonFile).front();
    EXPECT_EQ(json.a1, csv.a1);
    EXPECT_EQ(json.b2, csv.b2);
    EXPECT_EQ(json.frequency, csv.frequency);
    EXPECT_EQ(json.density, (std::vector<double>{1.5, 2.5, 1.0}));
}

TEST(SpotterJson, KeysInAnyOrderAtEitherLevelAndOthersDoNotMatter) {
    const SpectrumRecord wanted = read_json(kJsonFile).front();
    EXPECT_EQ(wanted.station, "SPOT-0070") << "the key after the spectra";
    for (const std::string& content :
         {"{\"frequencyData\": [" + kJsonSpectrum + "], \"spotterId\": \"SPOT-0070\"}",
          "\xEF\xBB\xBF\n {\"spotterId\": \"SPOT-0070\", \"x\": {\"spotterId\": 1, \"y\": []},"
          "\"data\": {\"frequencyData\": [" +
              replaced(kJsonSpectrum, "{", "{\"df\": [1, null, {\"a1\": [3]}], \"n\": true,") +
              "]}}"}) {
        const std::vector<SpectrumRecord> records = read_json(content);
        ASSERT_EQ(records.size(), 1u);
        EXPECT_TRUE(same_record(records[0], wanted)) << content;
    }
}

TEST(SpotterJson, NullIsMissing) {
    const std::string content = replaced(kJsonFile, "[1.5, 2.5, 1]", "[1.5, 2.5, null]");
    const SpectrumRecord record =
        read_json(replaced(replaced(content, "[0.5, -0.5", "[0.5, null"), "-61.0", "null")).front();
    EXPECT_EQ(record.frequency, (std::vector<double>{0.1, 0.2}));
    EXPECT_TRUE(std::isnan(record.a1[1]) && std::isnan(record.latitude));
    EXPECT_EQ(record.a1[0], 0.8);
    EXPECT_TRUE(refusal_of([] {
                    read_json(replaced(kJsonFile, "[1.5, 2.5, 1]", "[null, 2.5, null]"));
                }).says("s.json: holds no spectrum"));
}

TEST(SpotterJson, WithoutAnySpectrumThereIsNoRecord) {
    for (const char* content :
         {"{\"data\": {\"spotterId\": \"SPOT-0070\", \"waves\": []}}",
          "{\"data\": {\"frequencyData\": []}}", "{\"frequencyData\": [1, null, [2], \"x\"]}"}) {
        const Refusal refusal = refusal_of([&] { read_json(content); });
        EXPECT_TRUE(refusal.says("s.json: holds no spectrum")) << refusal.message;
    }
}

TEST(SpotterJson, WithoutMomentsTheMeanAndTheSpreadCount) {
    const std::string content = without(kJsonFile, "\"a1\"", "],");
    const SpectrumRecord record = read_json(content).front();
    EXPECT_NEAR(record.a1[0], 1.0 - 0.5 * std::pow(36.0 * kDegree, 2), 1e-12);
    EXPECT_FALSE(read_json(without(content, "\"direction\"", "],")).front().has_moments());
}

TEST(SpotterJson, BrokenFilesAreRefusedWithTheirLine) {
    const std::tuple<std::string, std::string, int, std::string> broken[] = {
        {"\"frequency\": [", "\"frequencies\": [", 12, "a spectrum without frequency"},
        {"[1.5, 2.5, 1]", "[]", 12, "a spectrum without varianceDensity"},
        {"[1.5, 2.5, 1]", "[1.5, 2.5]", 12, "2 values of varianceDensity for 3 frequencies"},
        {"[1.5, 2.5, 1]", "[1.5, 2.5, 1", 7, "':' is not what JSON has here"},
        {"[1.5, 2.5, 1]", "1.5", 6, "'varianceDensity' has a single number"},
        {"[1.5, 2.5, 1]", "\"1.5\"", 6, "'varianceDensity' has a text"},
        {"[1.5, 2.5, 1]", "{}", 6, "'varianceDensity' has an object"},
        {"[1.5, 2.5, 1]", "[1.5, [2.5], 1]", 6, "'varianceDensity' has a list"},
        {"[1.5, 2.5, 1]", "[1.5, true, 1]", 6, "'varianceDensity' has true or false"},
        {"[1.5, 2.5, 1]", "[1.5, \"2.5\", 1]", 6, "'varianceDensity' has a text"},
        {"[1.5, 2.5, 1]", "[1.5, -2e6, 1]", 6, "a density of -2e6; allowed: 0 .. 1e6 m^2/Hz"},
        {"[1.5, 2.5, 1]", "[1.5, 10000001, 1]", 6, "a density of 10000001"},
        {"[1.5, 2.5, 1]", "[1.5, 1e999, 1]", 6, "the number '1e999' is out of range"},
        {"[1.5, 2.5, 1]", "[1.5, None, 1]", 6, "'N' is not what JSON has here"},
        {"[1.5, 2.5, 1]", "[1.5, 2,5,, 1]", 6, "',' is not what JSON has here"},
        {"0.2, 0.4]", "0.05, 0.4]", 12, "the frequencies do not ascend at bin 2"},
        {"0.2, 0.4]", "-1, 0.4]", 5, "a frequency of -1; allowed: 1e-5 .. 100 Hz"},
        {"\"b1\":", "\"a1\":", 8, "'a1' appears twice in one spectrum"},
        {"[0.8, 0, -0.8]", "[0.8, 0, -1.8]", 7, "a moment of -1.8; allowed: -1 .. 1"},
        {"00:27:19.000Z", "00:27:19.000+25:00", 4, "is not UTC like"},
        {"00:27:19.000Z", "00:27:19.Z", 4, "is not UTC like"},
        {"\"2018-02-14T00:27:19.000Z\"", "1518568039", 4, "'timestamp' has a single number"},
        {"-61.0", "-161.0", 4, "a latitude of -161.0; allowed: -90 .. 90"},
        {"173.4", "\"173.4\"", 4, "'longitude' has a text"},
        {"\"limit\": null", "\"frequencyData\": []", 13, "'frequencyData' appears twice"},
        {"]]},", "]]},\n}", 2, "'}' is not what JSON has here"},
    };
    for (const auto& [from, to, line, words] : broken) {
        const Refusal refusal =
            first_fault_of([text = replaced(kJsonFile, from, to)] { return read_json(text); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file) << to;
        const std::string where = "s.json:" + std::to_string(line) + ": ";
        EXPECT_TRUE(refusal.says(where) && refusal.says(words)) << to << ": " << refusal.message;
    }
}

TEST(SpotterJson, EveryCutIsNamed) {
    for (std::size_t size = kJsonFile.find("frequencyData\": [") + 14; size <= kJsonFile.size() - 2;
         ++size) {
        const Refusal refusal =
            first_fault_of([&] { return read_json(kJsonFile.substr(0, size)); });
        ASSERT_TRUE(refusal.refused) << size;
        ASSERT_TRUE(refusal.says("s.json:")) << refusal.message;
    }
}

TEST(SpotterJson, HostileNestingAndListsAreRefusedAtOnce) {
    const auto repeated = [](const std::string& text, int times) {
        std::string out;
        for (int i = 0; i < times; ++i) out += text;
        return out;
    };
    const auto refused = [](const std::string& content) {
        return refusal_of([&] { read_json(content); });
    };
    const std::string key = "{\"spotterId\": ";
    EXPECT_TRUE(refused(key + repeated("[", 1000000)).says("s.json:1: is nested more than 64"));
    EXPECT_TRUE(refused(repeated("{\"spotterId\":", 1000000)).says("more than 64 deep"));
    const std::string many =
        "{\"frequencyData\": [{\"frequency\": [" + repeated("1,", 5000) + "1]}]}";
    EXPECT_TRUE(refused(many).says("s.json:1: more than 4096 frequencies"));
    const Refusal garbage = refused("{\"spotterId\": \x1B[31m\xFF" + std::string(9000, 'x'));
    EXPECT_LT(garbage.message.size(), 200u);
    for (const char c : garbage.message) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
}

TEST(SpotterCsv, ARowThatCannotBeReadCostsNoOther) {
    const std::vector<SpectrumRecord> records = read_csv(replaced(kCsvFile, ",2.5 ", ",inf "));
    ASSERT_EQ(records.size(), 2u);
    EXPECT_NE(records[0].fault.find("s.csv:2: 'inf' is not a number"), std::string::npos);
    EXPECT_EQ(records[0].time, "2021-09-06T04:12");
    EXPECT_TRUE(same_record(records[1], read_csv(kCsvFile)[1]));
}

TEST(SpotterJson, ListsOfBuoysAndOfSpectraAreRead) {
    const SpectrumRecord alone = read_json(kJsonFile).front();
    std::string other = kJsonFile;
    other.replace(other.find("SPOT-0070"), 9, "SPOT-0071");
    for (const std::string& content :
         {"[" + kJsonFile + "," + other + "]", "{\"data\": [" + kJsonFile + "," + other + "]}"}) {
        const std::vector<SpectrumRecord> records = read_json(content);
        ASSERT_EQ(records.size(), 2u);
        EXPECT_EQ(records[0].station, "SPOT-0070");
        EXPECT_EQ(records[1].station, "SPOT-0071");
        EXPECT_EQ(records[1].a1, alone.a1);
    }
    for (const std::string& content :
         {"{\"spotters\": {\"first\": " + kJsonFile + ", \"second\": " + other + "}}",
          "{\"data\": {\"frequencyData\": " + kJsonSpectrum + "}}",
          replaced(kJsonSpectrum, "\"frequency\"", "\"at\": {\"latitude\": 1}, \"frequency\"")}) {
        const std::vector<SpectrumRecord> records = read_json(content);
        EXPECT_EQ(records.front().a1, alone.a1);
        EXPECT_EQ(records.front().time, alone.time);
        EXPECT_EQ(records.front().latitude, -61.0);
        EXPECT_EQ(records.back().station.empty(), records.size() == 1);
    }
    const std::vector<SpectrumRecord> bare =
        read_json("[" + kJsonSpectrum + "," +
                  replaced(kJsonSpectrum, "{", "{\"spotterId\": \"SPOT-0072\",") + "]");
    ASSERT_EQ(bare.size(), 2u);
    EXPECT_EQ(bare[0].station, "");
    EXPECT_EQ(bare[0].density, alone.density);
    EXPECT_EQ(bare[0].latitude, -61.0);
    EXPECT_EQ(bare[1].station, "SPOT-0072");
}

TEST(SpotterJson, NanIsMissingAndOffsetsAreConverted) {
    const SpectrumRecord record =
        read_json(replaced(kJsonFile, "[1.5, 2.5, 1]", "[1.5, NaN, 1]"))[0];
    EXPECT_EQ(record.density, (std::vector<double>{1.5, 1.0}));
    EXPECT_EQ(record.frequency, (std::vector<double>{0.1, 0.4}));
    std::string named = replaced(kJsonFile, "SPOT-0070", "NaN \\\"NaN");
    named = replaced(named, "[1.5, 2.5, 1]", "[1.5, NaN, 1]");
    EXPECT_EQ(read_json(named)[0].station, "NaN \"NaN") << "within a text it is none";
    EXPECT_EQ(read_json(replaced(kJsonFile, "00:27:19.000Z", "00:27:19+00:00"))[0].time,
              "2018-02-14T00:27");
    EXPECT_EQ(read_json(replaced(kJsonFile, "00:27:19.000Z", "00:27:19+13:00"))[0].time,
              "2018-02-13T11:27");
}

TEST(SpotterJson, ASpectrumThatCannotBeReadCostsNoOther) {
    const std::string two =
        replaced(kJsonFile, kJsonSpectrum,
                 replaced(kJsonSpectrum, "[1.5, 2.5, 1]", "[1.5, \"x\", 1]") + "," + kJsonSpectrum);
    const std::vector<SpectrumRecord> records = read_json(two);
    ASSERT_EQ(records.size(), 2u);
    EXPECT_NE(records[0].fault.find("s.json:6: 'varianceDensity' has a text"), std::string::npos);
    EXPECT_EQ(records[0].time, "2018-02-14T00:27");
    EXPECT_EQ(records[1].station, "SPOT-0070");
    EXPECT_EQ(records[1].fault, "");
    const std::string cut = "{\"spotterId\": \"A\", \"frequencyData\": [" + kJsonSpectrum + "," +
                            kJsonSpectrum.substr(0, 150);
    const std::vector<SpectrumRecord> growing = read_json(cut);
    ASSERT_EQ(growing.size(), 2u);
    EXPECT_EQ(growing[0].station, "A");
    EXPECT_EQ(growing[0].fault, "");
    EXPECT_NE(growing[1].fault.find("the file ends where its JSON does not"), std::string::npos);
    EXPECT_EQ(growing[1].time, "2018-02-14T00:27");
}

}  // namespace
}  // namespace ocean::test
