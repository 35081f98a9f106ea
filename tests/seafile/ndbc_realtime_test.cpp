// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The NDBC real-time reader against the text of its files: values, directions, missing values,
// companions, and broken files.
#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "helpers.hpp"
#include "ocean/internal/grid.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

const std::string kDensityHeader = "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n";

std::vector<SpectrumRecord> read_realtime(const Files& files,
                                          const std::string& name = "b.data_spec") {
    return read_files(files, name);
}

Files one_line_buoy() {
    return {
        {"b.data_spec", kDensityHeader + "2020 06 08 03 50 0.2 1.5 (0.100) 2.5 (0.200)\n"},
        {"b.swdir",
         "#YY  MM DD hh mm alpha1_1 (freq_1) ... >\n2020 06 08 03 50 90.0 (0.100) "
         "99.0 (0.200)\n"},
        {"b.swdir2",
         "#YY  MM DD hh mm alpha2_1 (freq_1) ... >\n2020 06 08 03 50 0.0 (0.100) "
         "45.0 (0.200)\n"},
        {"b.swr1",
         "#YY  MM DD hh mm r1_1 (freq_1) ... >\n2020 06 08 03 50 0.80 (0.100) "
         "0.50 (0.200)\n"},
        {"b.swr2",
         "#YY  MM DD hh mm r2_1 (freq_1) ... >\n2020 06 08 03 50 0.60 (0.100) "
         "0.25 (0.200)\n"},
    };
}

TEST(NdbcRealtime, ReadsWhatTheFileSays) {
    const std::vector<SpectrumRecord> records = read_spectra(kBuoy);
    ASSERT_EQ(records.size(), 48u);
    EXPECT_EQ(records.front().time, "2020-06-08T03:50") << "file order, newest first";
    EXPECT_EQ(records.back().time, "2020-06-05T18:50");
    const SpectrumRecord& first = records.front();
    EXPECT_EQ(first.station, "41010");
    ASSERT_EQ(first.frequency.size(), 46u);
    // "... 0.060 (0.063) ... 1.210 (0.180) ... 0.000 (0.485)"
    EXPECT_EQ(first.frequency[6], 0.063);
    EXPECT_EQ(first.density[6], 0.060);
    EXPECT_EQ(first.frequency[21], 0.180);
    EXPECT_EQ(first.density[21], 1.210);
    EXPECT_EQ(first.frequency.back(), 0.485);
    EXPECT_EQ(first.density.back(), 0.0);
}

TEST(NdbcRealtime, MomentsAreThoseOfTheFourCompanionTables) {
    const SpectrumRecord first = read_spectra(kBuoy).front();
    // At 0.063 Hz: alpha1 36.0, alpha2 32.0, r1 0.37, r2 0.50.
    EXPECT_NEAR(first.a1[6], 0.37 * std::cos((270.0 - 36.0) * kDegree), 1e-12);
    EXPECT_NEAR(first.b1[6], 0.37 * std::sin((270.0 - 36.0) * kDegree), 1e-12);
    EXPECT_NEAR(first.a2[6], 0.50 * std::cos(2.0 * (270.0 - 32.0) * kDegree), 1e-12);
    EXPECT_NEAR(first.b2[6], 0.50 * std::sin(2.0 * (270.0 - 32.0) * kDegree), 1e-12);
    EXPECT_TRUE(std::isnan(first.a1[5])) << "999.0 at 0.058 Hz";
    EXPECT_TRUE(std::isnan(first.b2[5]));
}

TEST(NdbcRealtime, WavesFromTheEastTravelWestAndFromTheNorthSouth) {
    for (const auto& [from, x, y] : {std::tuple{"90.0", -1.0, 0.0},
                                     {"0.0", 0.0, -1.0},
                                     {"270.0", 1.0, 0.0},
                                     {"180.0", 0.0, 1.0}}) {
        Files files = one_line_buoy();
        files["b.swdir"].replace(files["b.swdir"].find("90.0"), 4, from);
        files["b.swr1"].replace(files["b.swr1"].find("0.80"), 4, "1.00");
        const SpectrumRecord record = read_realtime(files).front();
        EXPECT_NEAR(record.a1[0], x, 1e-12) << from;
        EXPECT_NEAR(record.b1[0], y, 1e-12) << from;
    }
}

TEST(NdbcRealtime, ADirectionOf99DegreesIsADirection) {
    const SpectrumRecord record = read_realtime(one_line_buoy()).front();
    EXPECT_NEAR(record.a1[1], 0.5 * std::cos(171.0 * kDegree), 1e-12);
}

TEST(NdbcRealtime, ASpreadOf99Or999IsMissing) {
    for (const char* missing : {"99.00", "999.00", "MM"}) {
        Files files = one_line_buoy();
        files["b.swr2"].replace(files["b.swr2"].find("0.60"), 4, missing);
        const SpectrumRecord record = read_realtime(files).front();
        EXPECT_TRUE(std::isnan(record.a1[0]) && std::isnan(record.a2[0])) << missing;
        EXPECT_FALSE(std::isnan(record.a1[1])) << missing;
    }
}

TEST(NdbcRealtime, ABinWithoutDensityIsLeftOut) {
    Files files = one_line_buoy();
    files["b.data_spec"] = kDensityHeader +
                           "2020 06 08 03 50 9.999 999.00 (0.050) 1.5 (0.100) 2.5 (0.200)\n"
                           "2020 06 08 02 50 9.999 999.00 (0.050) 99.00 (0.100) MM (0.200)\n";
    const std::vector<SpectrumRecord> records = read_realtime(files);
    ASSERT_EQ(records.size(), 1u) << "a time without any density is no record";
    EXPECT_EQ(records[0].frequency, (std::vector<double>{0.1, 0.2}));
    EXPECT_EQ(records[0].a1.size(), 2u);
}

TEST(NdbcRealtime, ColumnsAreMatchedByFrequencyAndRowsByTime) {
    Files files = one_line_buoy();
    files["b.swdir"] =
        "#YY  MM DD hh mm alpha1_1 (freq_1) ... >\n"
        "2020 06 08 02 50 10.0 (0.100) 20.0 (0.200)\n"
        "2020 06 08 03 50 30.0 (0.050) 40.0 (0.20)\n";
    const SpectrumRecord record = read_realtime(files).front();
    EXPECT_TRUE(std::isnan(record.a1[0])) << "0.100 Hz is not in that row";
    EXPECT_NEAR(record.a1[1], 0.5 * std::cos(230.0 * kDegree), 1e-12);
}

TEST(NdbcRealtime, MissingCompanionsMeanNoDirections) {
    for (const char* gone : {"b.swdir", "b.swdir2", "b.swr1", "b.swr2"}) {
        Files files = one_line_buoy();
        files.erase(gone);
        EXPECT_FALSE(read_realtime(files).front().has_moments()) << gone;
    }
    Files files = one_line_buoy();
    files["b.swr1"].replace(files["b.swr1"].find(" 03 50 "), 7, " 04 50 ");
    EXPECT_FALSE(read_realtime(files).front().has_moments()) << "no row of that time";
}

TEST(NdbcRealtime, IsRecognisedByContentButFindsCompanionsByName) {
    Files files = one_line_buoy();
    files["buoy.txt"] = files["b.data_spec"];
    const SpectrumRecord record = read_realtime(files, "buoy.txt").front();
    EXPECT_EQ(record.density, (std::vector<double>{1.5, 2.5}));
    EXPECT_FALSE(record.has_moments());
}

TEST(NdbcRealtime, HeadersWithoutMinutesAndTwoDigitYearsAreRead) {
    const std::vector<SpectrumRecord> records =
        read_realtime({{"b.data_spec",
                        "YY MM DD hh Sep_Freq < spec_1 (freq_1) ... >\r\n"
                        "98 12 31 23 0.2 1.5 (0.1) 2.5 (0.2) \r\n"}});
    EXPECT_EQ(records.front().time, "1998-12-31T23:00");
    EXPECT_EQ(records.front().density, (std::vector<double>{1.5, 2.5}));
}

TEST(NdbcRealtime, HeadersWithoutSeparationFrequencyAreRead) {
    const std::vector<SpectrumRecord> records =
        read_realtime({{"b.data_spec",
                        "#YY MM DD hh mm spec_1 (freq_1) ... >\n"
                        "2020 02 29 00 00 1.5 (0.1) 2.5 (0.2)"}});
    EXPECT_EQ(records.front().density, (std::vector<double>{1.5, 2.5}));
    EXPECT_EQ(records.front().time, "2020-02-29T00:00");
}

TEST(NdbcRealtime, BrokenLinesAreRefusedWithTheirNumber) {
    const std::string good = "2020 06 08 03 50 0.2 1.5 (0.1) 2.5 (0.2)\n";
    const std::pair<std::string, std::string> broken[] = {
        {"2020 06 08 03 50 0.2 1.5 (0.1) 2.5 (0.", "pairs"},
        {"2020 06 08 03 50 0.2 1.5 (0.1) 2.5\n", "pairs"},
        {"2020 06 08 03 50 0.2 1.5 (0.1)\n", "fewer than 2 frequencies"},
        {"2020 06 08 03 50\n", "separation frequency"},
        {"2020 06 08 03 50 0.2 1.5 (0.1) -2e6 (0.2)\n", "-2e6"},
        {"2020 06 08 03 50 0.2 1.5 (0.1) 1e7 (0.2)\n", "1e7"},
        {"2020 06 08 03 50 0.2 1.5 (0.1) nan (0.2)\n", "'nan' is not a number"},
        {"2020 06 08 03 50 0.2 1.5 (0.1) 1,5 (0.2)\n", "'1,5' is not a number"},
        {"2020 06 08 03 50 0.2 1.5 (0.2) 2.5 (0.1)\n", "do not ascend"},
        {"2020 06 08 03 50 0.2 1.5 (0.1) 2.5 (0.1)\n", "do not ascend"},
        {"2020 06 08 03 50 0.2 1.5 (-.1) 2.5 (0.1)\n", "allowed: 1e-5 .. 100 Hz"},
        {"2020 06 08 03 50 0.2 1.5 (0.1) 2.5 (inf)\n", "'inf' is not a frequency"},
        {"2020 06 31 03 50 0.2 1.5 (0.1) 2.5 (0.2)\n", "date"},
        {"2020 06 08 24 50 0.2 1.5 (0.1) 2.5 (0.2)\n", "date"},
        {"2020 6.5 08 03 50 0.2 1.5 (0.1) 2.5 (0.2)\n", "date"},
        {"once upon a time\n", "'once'"},
        {std::string("2020 06 08 03 50 0.2 1.5 (0.1) 2.5 (0.2\0)\n", 43), "frequency"},
    };
    for (const auto& [line, words] : broken) {
        const Files files = {{"b.data_spec", kDensityHeader + good + line}};
        const Refusal refusal = first_fault_of([&] { return read_realtime(files); });
        ASSERT_TRUE(refusal.refused) << line;
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        EXPECT_TRUE(refusal.says("b.data_spec:3: ") && refusal.says(words)) << refusal.message;
    }
}

TEST(NdbcRealtime, AFileCutBetweenPairsIsRefused) {
    const Refusal refusal = first_fault_of([] {
        return read_realtime(
            {{"b.data_spec", kDensityHeader + "2020 06 08 03 50 0.2 1.5 (0.1) 2.5 (0.2) 3 (0.3)\n"
                                              "2020 06 08 02 50 0.2 1.5 (0.1) 2.5 (0.2)"}});
    });
    EXPECT_TRUE(refusal.says("b.data_spec:3: the file ends within this line")) << refusal.message;
}

TEST(NdbcRealtime, ABrokenLineOfACompanionCostsItsDirectionsAndIsNamed) {
    const auto warning_of = [](const Files& files) {
        const SpectrumRecord record = read_realtime(files).front();
        EXPECT_FALSE(record.has_moments());
        return record.warnings.empty() ? std::string() : record.warnings.front();
    };
    const std::pair<std::string, std::string> broken[] = {
        {"361.0 (0.100) 99.0 (0.200)", "0 .. 360 degrees"},
        {"-1.0 (0.100) 99.0 (0.200)", "0 .. 360 degrees"},
        {"east (0.100) 99.0 (0.200)", "'east' is not a number"},
    };
    for (const auto& [values, words] : broken) {
        Files files = one_line_buoy();
        files["b.swdir"].replace(files["b.swdir"].find("90.0"), 26, values);
        const std::string warning = warning_of(files);
        EXPECT_NE(warning.find("left out: b.swdir:2: "), std::string::npos) << warning;
        EXPECT_NE(warning.find(words), std::string::npos) << warning;
    }
    Files files = one_line_buoy();
    files["b.swr1"].replace(files["b.swr1"].find("0.80"), 4, "1.20");
    EXPECT_EQ(warning_of(files),
              "its directions are left out: b.swr1:2: r1 and r2 are 0 .. 1, not 1.20");
    files["b.swr1"] = files["b.swr2"];
    EXPECT_TRUE(refusal_of([&] { read_realtime(files); }).says("b.swr1:1: this is a .swr2 table"));
}

TEST(NdbcRealtime, ACompanionGivenAsSpectrumIsNamed) {
    const Refusal refusal = refusal_of([] { read_spectra(kData + "/spectra/ndbc_41010.swdir"); });
    EXPECT_TRUE(refusal.says("this is a .swdir table where .data_spec is needed"))
        << refusal.message;
}

TEST(NdbcRealtime, ALineThatEndsBetweenPairsIsWarnedOf) {
    const std::vector<SpectrumRecord> records = read_realtime(
        {{"b.data_spec", kDensityHeader + "2020 06 08 03 50 0.2 1.5 (0.1) 2.5 (0.2) 3 (0.3)\n"
                                          "2020 06 08 02 50 0.2 1.5 (0.1) 2.5 (0.2)\n"}});
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[1].warnings,
              (std::vector<std::string>{"line 3 has 2 frequencies where the line before has 3"}));
}

TEST(NdbcRealtime, AnHourlyTableHasItsStationsAndTheirDirections) {
    const std::string two = "41997 2024 03 01 12 00 ";
    Files files = {{"h.data_spec", "#STN YYYY MM DD hh mm Sep_Freq < spec_1 (freq_1) ... >\n" +
                                       two +
                                       "0.2 1 (0.1) 2 (0.2)\n41998 2024 03 01 12 00 0.2 3 (0.1) 4 "
                                       "(0.2)\n"}};
    for (const auto& [suffix, column, value] : {std::tuple{".swdir", "alpha1_1", "90"},
                                                {".swdir2", "alpha2_1", "90"},
                                                {".swr1", "r1_1", "0.8"},
                                                {".swr2", "r2_1", "0.5"}}) {
        files["h" + std::string(suffix)] = "#STN YYYY MM DD hh mm " + std::string(column) +
                                           " (freq_1) ... >\n" + two + value + " (0.1) " + value +
                                           " (0.2)\n";
    }
    const std::vector<SpectrumRecord> records = read_realtime(files, "h.data_spec");
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0].station, "41997");
    ASSERT_TRUE(records[0].has_moments());
    EXPECT_NEAR(records[0].a1[0], -0.8, 1e-12) << "from the east";
    EXPECT_EQ(records[1].station, "41998");
    EXPECT_FALSE(records[1].has_moments()) << "another station's are not its own";
}

TEST(NdbcFiveDay, ABandThatIsLostCostsItsRecord) {
    const std::string head = "YYYY MM DD hh mm bands\nfreq bandwidth energy r1 r2 alpha1 alpha2\n";
    const auto record = [](const std::string& hour, const std::string& last) {
        return "2024 03 01 " + hour +
               " 00 3\n0.04 0.01 -0.01 0.9 0.6 90 90\n"
               "0.05 0.01 2.0 0.9 0.6 90 90\n" +
               last;
    };
    const std::string good = "0.06 0.01 1.0 0.9 MM 999 90\n";
    const auto read_five = [](const std::string& content) {
        return read_spectra_from({content, "x/41010_5day.spectral", {}});
    };
    const std::vector<SpectrumRecord> whole = read_five("# x\n" + head + record("11", good));
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0].station, "41010");
    EXPECT_EQ(whole[0].time, "2024-03-01T11:00");
    EXPECT_EQ(whole[0].density[0], 0.0);
    EXPECT_NEAR(whole[0].a1[1], -0.9, 1e-12);
    EXPECT_TRUE(std::isnan(whole[0].a1[2]));
    EXPECT_EQ(whole[0].warnings.size(), 1u) << "the density below 0";
    for (const std::string& last :
         {std::string(), std::string("0.06 0.01 1.0\n"),
          std::string("0.05 0.01 1.0 0.9 0.6 90 90\n"), "garbage\n" + good}) {
        const std::vector<SpectrumRecord> records =
            read_five(head + record("11", last) + record("12", good));
        ASSERT_EQ(records.size(), 2u) << last;
        EXPECT_NE(records[0].fault.find("41010_5day.spectral:6: "), std::string::npos)
            << records[0].fault;
        EXPECT_EQ(records[0].time, "2024-03-01T11:00");
        EXPECT_EQ(records[1].time, "2024-03-01T12:00");
        EXPECT_EQ(records[1].fault, "");
    }
    const std::vector<SpectrumRecord> cut =
        read_five(head + record("11", good) + record("12", "0.06 0.0"));
    ASSERT_EQ(cut.size(), 2u);
    EXPECT_NE(cut[1].fault.find("the file ends within this line"), std::string::npos);
}

}  // namespace
}  // namespace ocean::test
