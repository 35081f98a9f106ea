// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The NDBC historical reader: against the real-time record in the layout of the yearly files, and
// against the text of small tables: companions, hundredths, missing values, broken files.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <tuple>

#include "helpers.hpp"
#include "ocean/internal/grid.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

const std::string kHistorical = kData + "/spectra/ndbc_historical/41010w2020.txt.gz";
const std::string kTableHeader = "#YY  MM DD hh mm  .1000  .2000\n";
const std::string kName = "sea/41010w2019.txt";

std::vector<SpectrumRecord> read_historical(const Files& files, const std::string& name = kName) {
    return read_files(files, name);
}

std::string table(const std::string& values) {
    return kTableHeader + "2019 01 02 03 40 " + values + "\n";
}

Files one_line_tables() {
    return {{"sea/41010w2019.txt", table("1.5 2.5")},
            {"sea/41010d2019.txt", table("90.0 99.0")},
            {"sea/41010i2019.txt", table("0.0 45.0")},
            {"sea/41010j2019.txt", table("80.00 50.00")},
            {"sea/41010k2019.txt", table("60.00 25.00")}};
}

void expect_close(const std::vector<double>& a, const std::vector<double>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::isnan(b[i])) {
            EXPECT_TRUE(std::isnan(a[i])) << i;
        } else {
            EXPECT_NEAR(a[i], b[i], 1e-12) << i;
        }
    }
}

TEST(NdbcHistorical, PackedYearlyFilesHoldTheRecordsOfTheRealTimeFiles) {
    std::vector<SpectrumRecord> expected = read_spectra(kBuoy);
    std::reverse(expected.begin(), expected.end());
    const std::vector<SpectrumRecord> records = read_spectra(kHistorical);
    ASSERT_EQ(records.size(), expected.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        EXPECT_EQ(records[i].station, "41010");
        EXPECT_EQ(records[i].time, expected[i].time);
        EXPECT_EQ(records[i].frequency, expected[i].frequency);
        EXPECT_EQ(records[i].density, expected[i].density);
        EXPECT_EQ(records[i].has_moments(), expected[i].has_moments());
        expect_close(records[i].a1, expected[i].a1);
        expect_close(records[i].b1, expected[i].b1);
        expect_close(records[i].a2, expected[i].a2);
        expect_close(records[i].b2, expected[i].b2);
    }
}

TEST(NdbcHistorical, HundredthsAreToldFromFractionsByAnyValueAboveOne) {
    const SpectrumRecord hundredths = read_historical(one_line_tables()).front();
    EXPECT_NEAR(hundredths.a1[0], -0.80, 1e-12) << "from the east, to the west";
    EXPECT_NEAR(hundredths.a1[1], 0.50 * std::cos(171.0 * kDegree), 1e-12);
    EXPECT_NEAR(hundredths.b2[0], 0.60 * std::sin(540.0 * kDegree), 1e-12);
    Files files = one_line_tables();
    files["sea/41010j2019.txt"] = table("0.80 0.50");
    EXPECT_TRUE(same_record(read_historical(files).front(), hundredths)) << "each table for itself";
}

TEST(NdbcHistorical, Of99HundredthsIsAValueAndOfFractionsMissing) {
    Files files = one_line_tables();
    files["sea/41010j2019.txt"] = table("99.00 50.00");
    EXPECT_NEAR(read_historical(files).front().a1[0], -0.99, 1e-12);
    files["sea/41010j2019.txt"] = table("99.00 0.50");
    EXPECT_TRUE(std::isnan(read_historical(files).front().a1[0]));
    EXPECT_FALSE(std::isnan(read_historical(files).front().a1[1]));
    files["sea/41010j2019.txt"] = table("999.00 50.00");
    EXPECT_TRUE(std::isnan(read_historical(files).front().a1[0]));
}

TEST(NdbcHistorical, ABinWithoutDensityIsLeftOutAndATimeWithoutAnyToo) {
    Files files = one_line_tables();
    files[kName] =
        "#YY  MM DD hh mm  .0500  .1000  .2000\n#yr mo dy hr mn m2/Hz\n"
        "2019 01 02 02 40 999.00 99.00 1.00\n2019 01 02 03 40 99.00 1.5 2.5\n";
    const std::vector<SpectrumRecord> records = read_historical(files);
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].frequency, (std::vector<double>{0.1, 0.2}));
    EXPECT_NEAR(records[0].a1[0], -0.80, 1e-12) << "companions are matched by frequency";
}

TEST(NdbcHistorical, OldHeadersAreRead) {
    const std::string row = " 12 31 23 1.5 2.5\r\n";
    for (const auto& [text, time] : {std::pair{"YY MM DD hh  .1 .2\r\n98" + row, "1998"},
                                     {"YYYY MM DD hh .1 .2\r\n2001" + row, "2001"},
                                     {"# YY MM DD hh .1 .2\n2001" + row, "2001"}}) {
        const SpectrumRecord record = read_historical({{"w.txt", text}}, "w.txt").front();
        EXPECT_EQ(record.time, time + std::string("-12-31T23:00"));
        EXPECT_EQ(record.density, (std::vector<double>{1.5, 2.5}));
        EXPECT_EQ(record.station, "");
    }
}

TEST(NdbcHistorical, OfTwoRowsWithOneTimeTheFirstIsKept) {
    Files files = one_line_tables();
    files[kName] += "2019 01 02 03 40 7 8\n2019 01 02 04 40 3 4\n";
    files["sea/41010d2019.txt"] += "2019 01 02 03 40 10 10\n";
    const std::vector<SpectrumRecord> records = read_historical(files);
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0].density, (std::vector<double>{1.5, 2.5}));
    EXPECT_NEAR(records[0].a1[0], -0.80, 1e-12);
    EXPECT_EQ(records[1].time, "2019-01-02T04:40");
}

TEST(NdbcHistorical, CompanionsAreFoundPackedOrNotAndByMonth) {
    for (const char* tail : {"2019.txt", "62019.txt", "b2019.txt"}) {
        for (const char* packed : {"", ".gz"}) {
            Files files;
            for (const auto& [path, text] : one_line_tables()) {
                const char letter = path[9];
                const bool gz = letter == 'w' || letter == 'j';
                files[path.substr(0, 10) + tail + (gz ? packed : "")] = text;
            }
            const SpectrumRecord record =
                read_historical(files, std::string("sea/41010w") + tail + packed).front();
            EXPECT_EQ(record.station, "41010") << tail;
            EXPECT_TRUE(record.has_moments()) << tail << packed;
        }
    }
}

TEST(NdbcHistorical, AMissingCompanionMeansNoDirections) {
    for (const char letter : {'d', 'i', 'j', 'k'}) {
        Files files = one_line_tables();
        files.erase(std::string("sea/41010") + letter + "2019.txt");
        const SpectrumRecord record = read_historical(files).front();
        EXPECT_FALSE(record.has_moments()) << letter;
        EXPECT_EQ(record.density, (std::vector<double>{1.5, 2.5}));
    }
}

TEST(NdbcHistorical, ATableOfDirectionsGivenAsSpectrumIsRefused) {
    const Refusal refusal =
        refusal_of([] { read_historical(one_line_tables(), "sea/41010d2019.txt"); });
    EXPECT_TRUE(refusal.says("sea/41010d2019.txt:1: ") && refusal.says("table with 'w'"))
        << refusal.message;
}

TEST(NdbcHistorical, TablesOfMeteorologyAreNotTakenForSpectra) {
    EXPECT_FALSE(kNdbcHistorical.recognises("#YY  MM DD hh mm WDIR WSPD GST\n"));
    EXPECT_FALSE(
        kNdbcHistorical.recognises("#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n"));
    EXPECT_TRUE(kNdbcHistorical.recognises("\xEF\xBB\xBF\r\n#YY  MM DD hh mm .02 .03\r\n"));
}

TEST(NdbcHistorical, BrokenLinesAreRefusedWithTheirNumber) {
    const std::pair<std::string, std::string> broken[] = {
        {"2019 01 02 04 40 1.5", "ends within this line"},
        {"2019 01 02 04 40 1.5\n", "1 values for the 2 frequencies"},
        {"2019 01 02 04 40 1.5 2.5 3.5\n", "more values than the 2 frequencies"},
        {"2019 01 02 04 40 1.5 -2e6\n", "0 .. 1e6 m^2/Hz, not -2e6"},
        {"2019 01 02 04 40 1.5 1e300\n", "not 1e300"},
        {"2019 01 02 04 40 1.5 nan\n", "'nan' is not a number"},
        {"2019 02 29 04 40 1.5 2.5\n", "date"},
        {"20191345 04 40 1.5 2.5\n", "date"},
        {"#YY MM DD hh mm .2 .1\n", "do not ascend"},
        {"#YY MM DD hh mm .2 .2\n", "do not ascend"},
        {"#YY MM DD hh mm .2\n", "fewer than 2"},
        {"#YY MM DD hh mm -.1 .1\n", "allowed: 1e-5 .. 100 Hz"},
        {"#YY MM DD hh mm .1 spec\n", "'spec' is not a frequency"},
        {"#YY DD MM hh mm .1 .2\n", "YY MM DD hh [mm]"},
    };
    for (const auto& [line, words] : broken) {
        const Refusal refusal = first_fault_of([&, text = line] {
            return read_historical({{kName, table("1 2") + text}});
        });
        ASSERT_TRUE(refusal.refused) << line;
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        EXPECT_TRUE(refusal.says(kName + ":3: ") && refusal.says(words)) << refusal.message;
    }
}

TEST(NdbcHistorical, ABrokenLineOfACompanionCostsItsDirectionsAndIsNamed) {
    for (const auto& [letter, values, words] :
         {std::tuple{"d", "361.0 1.0", "0 .. 360 degrees, not 361.0"},
          {"i", "-1.0 1.0", "0 .. 360 degrees"},
          {"j", "80 106", "0 .. 100 hundredths, not 106"},
          {"k", "80", "1 values for the 2"}}) {
        Files files = one_line_tables();
        const std::string path = std::string("sea/41010") + letter + "2019.txt";
        files[path] = table(values);
        const SpectrumRecord record = read_historical(files).front();
        EXPECT_FALSE(record.has_moments());
        ASSERT_EQ(record.warnings.size(), 1u);
        const std::string& warning = record.warnings[0];
        EXPECT_NE(warning.find("its directions are left out: " + path + ":2: "), std::string::npos);
        EXPECT_NE(warning.find(words), std::string::npos) << warning;
    }
}

}  // namespace
}  // namespace ocean::test
