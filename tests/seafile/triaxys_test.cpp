// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The reader of TRIAXYS spectra against the text of such files: the table and its unit, directions,
// the origin in the title, spectra over frequency alone, and broken files.
#include <gtest/gtest.h>

#include <tuple>

#include "helpers.hpp"
#include "ocean/internal/directional_record.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

const std::string kBuoyFile = kData + "/spectra/triaxys.DIRSPEC";

/// Three frequencies, waves from the north, east, south and west; north is listed twice.
const std::string kTriaxysFile =
    "TRIAXYS BUOY DATA REPORT - TAS01970 - TAB01401 - 4857.6668S16631.6837W\r\n"  // 1
    "VERSION = WV (NDS)\r\n"
    "TYPE\t= DIRECTIONAL SPECTRUM\r\n"                     // 3
    "DATE    = 2018-01-31 21:00(UTC)\r\n"                  // 4
    "NUMBER OF FREQUENCIES              =       3\r\n"     // 5
    "NUMBER OF RESOLVABLE FREQUENCIES   =       2\r\n"     // 6
    "INITIAL FREQUENCY (Hz)             =   0.000\r\n"     // 7
    "FREQUENCY SPACING (Hz)             =   0.100\r\n"     // 8
    "RESOLVABLE FREQUENCY RANGE (Hz)    = 0.1 TO 0.2\r\n"  // 9
    "NUMBER OF DIRECTIONS               =       5\r\n"     // 10
    "DIRECTION SPACING (DEG)            =    90.0\r\n"     // 11
    "COLUMNS = 0.00 TO 360.00 DEG\r\n"                     // 12
    "ROWS\t= 0.00 TO   0.64 Hz\r\n"                        // 13
    " 9 9 9 9 9\r\n"                                       // 14
    " 1.0E-02 2.0E-02 3.0E-02 4.0E-02 1.0E-02\r\n"         // 15
    " 5.0E-02 6.0E-02 7.0E-02 8.0E-02 5.0E-02\r\n";        // 16

const std::string kTriaxysOverFrequency =
    "TRIAXYS BUOY DATA REPORT - TAS04811\n"       // 1
    "VERSION = 5b.02.08\n"                        // 2
    "TYPE    = NON-DIRECTIONAL SPECTRUM\n"        // 3
    "DATE    = 2019 Jan 01 00:30(UTC)\n"          // 4
    "NUMBER OF FREQUENCIES              =  4\n"   // 5
    "INITIAL FREQUENCY (Hz)             = 0.0\n"  // 6
    "FREQUENCY SPACING (Hz)             = 0.1\n"  // 7
    "COLUMN 1 = FREQUENCY (Hz)\n"                 // 8
    "COLUMN 2 = SPECTRAL DENSITY (M^2/Hz)\n"      // 9
    "0.000  0.0000000E+00\n"                      // 10
    "0.100  1.5000000E+00\n"                      // 11
    "0.200  2.5000000E+00\n"                      // 12
    "0.300  0.5000000E+00\n";                     // 13

std::vector<SpectrumRecord> read_triaxys(const std::string& content) {
    return read_spectra_from({content, "b.DIRSPEC", {}});
}
TEST(Triaxys, ReadsWhatTheFileSays) {
    const std::vector<SpectrumRecord> records = read_spectra(kBuoyFile);
    ASSERT_EQ(records.size(), 1u);
    const SpectrumRecord& record = records[0];
    EXPECT_EQ(record.station, "TAS01970");
    EXPECT_EQ(record.time, "2018-01-31T21:00");
    EXPECT_NEAR(record.latitude, -(48.0 + 57.6668 / 60.0), 1e-12);
    EXPECT_NEAR(record.longitude, -(166.0 + 31.6837 / 60.0), 1e-12);
    ASSERT_EQ(record.frequency.size(), 62u) << "63 with 0 Hz";
    EXPECT_DOUBLE_EQ(record.frequency[5], 0.06);
    ASSERT_EQ(record.direction.size(), 120u) << "0 and 360 are one";
    // The row of 0.06 Hz begins 8.47017E-04 8.47236E-04: from 0 and from 3 degrees.
    EXPECT_EQ(record.direction[90], 270.0);
    EXPECT_EQ(record.directional_density[5 * 120 + 90], 8.47017e-4);
    EXPECT_EQ(record.directional_density[5 * 120 + 89], 8.47236e-4);
}

TEST(Triaxys, TheTableIsPerDegree) {
    // The same buoy at the same time, in its file over frequency alone, .NONDIRSPEC.
    const SpectrumRecord record = read_spectra(kBuoyFile).front();
    EXPECT_NEAR(record.density[5] / 2.7462840, 1.0, 0.003) << "0.06 Hz";
    EXPECT_NEAR(record.density[12] / 6.9292030, 1.0, 0.003) << "0.13 Hz";
    EXPECT_NEAR(record.density[19] / 1.1901990, 1.0, 0.003) << "0.20 Hz";
}

TEST(Triaxys, DirectionsAreWhereWavesComeFromAndTheDoubleOneCountsOnce) {
    const SpectrumRecord record = read_triaxys(kTriaxysFile).front();
    EXPECT_EQ(record.frequency, (std::vector<double>{0.1, 0.2})) << "0 Hz is no wave";
    EXPECT_EQ(record.direction, (std::vector<double>{0.0, 90.0, 180.0, 270.0}));
    // Travelling east, north, west, south: from the west, south, east and north.
    EXPECT_EQ(record.directional_density,
              (std::vector<double>{0.04, 0.03, 0.02, 0.01, 0.08, 0.07, 0.06, 0.05}));
    EXPECT_DOUBLE_EQ(record.density[0], 90.0 * 0.1);
}

TEST(Triaxys, OverFrequencyAloneThereAreNoDirections) {
    const SpectrumRecord record = read_triaxys(kTriaxysOverFrequency).front();
    EXPECT_EQ(record.station, "TAS04811");
    EXPECT_EQ(record.time, "2019-01-01T00:30");
    EXPECT_TRUE(std::isnan(record.latitude));
    EXPECT_EQ(record.frequency, (std::vector<double>{0.1, 0.2, 0.3}));
    EXPECT_EQ(record.density, (std::vector<double>{1.5, 2.5, 0.5}));
    EXPECT_FALSE(record.has_moments() || record.is_directional());
}

TEST(Triaxys, SeveralReportsInOneFileAreSeveralRecords) {
    const std::vector<SpectrumRecord> records =
        read_triaxys(kTriaxysFile + kTriaxysOverFrequency + "\r\n" + kTriaxysFile);
    ASSERT_EQ(records.size(), 3u);
    EXPECT_EQ(records[1].station, "TAS04811");
    EXPECT_TRUE(same_record(records[0], records[2]));
}

TEST(Triaxys, APositionIsReadOrLeftOut) {
    const auto position = [](const std::string& text) {
        const SpectrumRecord record =
            read_triaxys(replaced(kTriaxysFile, "4857.6668S16631.6837W", text)).front();
        return std::pair{record.latitude, record.longitude};
    };
    EXPECT_EQ(position("0630.0N01015.0E"), (std::pair{6.5, 10.25}));
    for (const char* none :
         {"", "4857.6668", "4867.0S16631.0W", "9100.0S16631.0W", "4857.0S18100.0E", "nanS16631.0W",
          "4857.0S16631.0Wx", "-4857.0S16631.0W"}) {
        const auto [latitude, longitude] = position(none);
        EXPECT_TRUE(std::isnan(latitude) && std::isnan(longitude)) << none;
    }
}

TEST(Triaxys, BrokenFilesAreRefusedWithTheirLine) {
    const std::tuple<std::string, std::string, int, std::string> broken[] = {
        {"= DIRECTIONAL SPECTRUM", "= MEAN DIRECTION", 3, "TYPE 'MEAN DIRECTION'; known"},
        {"TYPE\t=", "KIND\t=", 13, "the header before has no TYPE"},
        {"TYPE\t=", "TYPE\t", 3, "'TYPE' where a line of the header, KEY = value, should be"},
        {"DATE ", "TIME ", 13, "the header before has no DATE"},
        {"2018-01-31 21", "2018-02-31 21", 4, "the DATE '2018-02-31 21:00(UTC)' is not like"},
        {"(UTC)", "(NZST)", 4, "is not like 2018-01-31 21:00(UTC)"},
        {"=       3", "=       1", 5, "'1' frequencies; allowed: 2 .. 4096"},
        {"=       3", "=     1e9", 5, "'1e9' frequencies"},
        {"=       3", "=     3.5", 5, "'3.5' frequencies"},
        {"=       3", "=       4", 16, "the file ends where row 4 of 4 should be"},
        {"=   0.000", "=  -0.100", 7, "an initial frequency of '-0.100'; allowed: 0 .. 100"},
        {"=   0.000", "=     nan", 7, "an initial frequency of 'nan'"},
        {"=   0.100", "=   0.000", 8, "a spacing of '0.000'"},
        {"=   0.100", "=      90", 13, "the last frequency is beyond 100 Hz"},
        {"=       5", "=     721", 10, "'721' directions; allowed: 3 .. 720"},
        {"=       5", "=       4", 14, "'9' after the densities of all directions"},
        {"=       5", "=       6", 13,
         "of the directions of the header: a direction appears twice"},
        {"=    90.0", "=   -90.0", 11, "a spacing of '-90.0'"},
        {"4.0E-02", "-4.0E+05", 15, "a density of -4.0E+05; allowed: 0 .. 2500 m^2/Hz/deg"},
        {"4.0E-02", "nan", 15, "'nan' is not a density"},
        {"4.0E-02", "4.0E+07", 15, "a density of 4.0E+07"},
        {" 4.0E-02", "", 15, "the line ends where a density should be"},
        {"ROWS", "LINES", 14, "'9' where a line of the header, KEY = value, should be"},
    };
    for (const auto& [from, to, line, words] : broken) {
        const Refusal refusal = first_fault_of(
            [text = replaced(kTriaxysFile, from, to)] { return read_triaxys(text); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file) << to;
        const std::string where = "b.DIRSPEC:" + std::to_string(line) + ": ";
        EXPECT_TRUE(refusal.says(where) && refusal.says(words)) << to << ": " << refusal.message;
    }
    for (const auto& [from, to, words] :
         {std::tuple{"0.200  2.5", "0.100  2.5", "b.DIRSPEC:12: the frequencies do not ascend"},
          {"2.5000000E+00", "-1e7", "b.DIRSPEC:12: a density of -1e7; allowed: 0 .. 1e6 m^2/Hz"},
          {"2.5000000E+00", "", "b.DIRSPEC:12: the line ends where a density should be"},
          {"2.5000000E+00", "1 2", "b.DIRSPEC:12: '2' after the density"}}) {
        const Refusal refusal = first_fault_of(
            [text = replaced(kTriaxysOverFrequency, from, to)] { return read_triaxys(text); });
        EXPECT_TRUE(refusal.says(words)) << refusal.message;
    }
}

}  // namespace
}  // namespace ocean::test
