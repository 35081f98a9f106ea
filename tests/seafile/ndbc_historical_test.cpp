// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the corpus does not show of NDBC's yearly files: whole files against the real-time record,
// and the names of companions.

#include "helpers.hpp"

namespace ocean::test {
namespace {

const std::string kHistorical = kData + "/spectra/ndbc_historical/41010w2020.txt.gz";

std::string table(const std::string& values) {
    return "#YY  MM DD hh mm  .1000  .2000\n2019 01 02 03 40 " + values + "\n";
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
                read_files(files, std::string("sea/41010w") + tail + packed).front();
            EXPECT_EQ(record.station, "41010") << tail;
            EXPECT_TRUE(record.has_moments()) << tail << packed;
        }
    }
}

TEST(NdbcHistorical, TablesOfMeteorologyAreNotTakenForSpectra) {
    EXPECT_FALSE(kNdbcHistorical.recognises("#YY  MM DD hh mm WDIR WSPD GST\n"));
    EXPECT_FALSE(
        kNdbcHistorical.recognises("#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n"));
    EXPECT_TRUE(kNdbcHistorical.recognises("\xEF\xBB\xBF\r\n#YY  MM DD hh mm .02 .03\r\n"));
}

}  // namespace
}  // namespace ocean::test
