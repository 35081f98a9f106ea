// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The reader of WAVEWATCH III point output against the text of its files: values, directions,
// several points and times, numbers as Fortran writes them, and broken files.
#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "formats/fortran_number.hpp"
#include "helpers.hpp"
#include "ocean/internal/grid.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

const std::string kStation = kData + "/spectra/ww3_station_44097.spec";

/// Two points, two times, two frequencies, and waves that travel north, east, south and west.
const std::string kWavewatchFile =
    "'WAVEWATCH III SPECTRA'     2     4     2 'a grid'\n"     // 1
    " 0.100E+00 0.200E+00\n"                                   // 2
    "  0.000E+00  0.157E+01  0.314E+01  0.471E+01\n"           // 3
    "20220912 060000\n"                                        // 4
    "'A         '  40.98 -71.12      46.6 1.4 225.6 0.1 94\n"  // 5
    "  0.100E+01  0.200E+01  0.300E+01  0.400E+01  0.500E+01\n"
    "  0.600E+01  0.700E+01  0.800E+01\n"
    "'B b       ' -40.98 188.88      46.6 1.4 225.6 0.1 94\n"  // 8
    "  0.900E+01  0.200E+01  0.300E+01  0.400E+01  0.500E+01\n"
    "  0.600E+01  0.700E+01  0.800E+01\n"
    "20220912 073059\n"                                        // 11
    "'A         '  40.98 -71.12      46.6 1.4 225.6 0.1 94\n"  // 12
    "  1 2 3 4 5 6 7 8\n"
    "'B b       ' -40.98 188.88      46.6 1.4 225.6 0.1 94\n"  // 14
    "  1 2 3 4 5 6 7\n"
    "  8\n";  // 16

std::vector<SpectrumRecord> read_wavewatch(const std::string& content) {
    return read_spectra_from({content, "p.spec", {}});
}

/// kWavewatchFile with its first `from` replaced.
std::string wavewatch_with(const std::string& from, const std::string& to) {
    return replaced(kWavewatchFile, from, to);
}

TEST(Wavewatch, ReadsWhatTheFileSays) {
    const std::vector<SpectrumRecord> records = read_spectra(kStation);
    ASSERT_EQ(records.size(), 4u);
    EXPECT_EQ(records[0].time, "2022-09-12T06:00");
    EXPECT_EQ(records[3].time, "2022-09-12T09:00");
    const SpectrumRecord& first = records[0];
    EXPECT_EQ(first.station, "44097");
    EXPECT_EQ(first.latitude, 40.98);
    EXPECT_EQ(first.longitude, -71.12);
    EXPECT_EQ(first.depth, 46.6);
    ASSERT_EQ(first.frequency.size(), 50u);
    EXPECT_EQ(first.frequency[33], 0.326);
    ASSERT_EQ(first.direction.size(), 36u);
    // The file's first direction is 0.148E+01, 85 degrees from north: 5 degrees from east.
    EXPECT_NEAR(first.direction[0], 5.0, 0.01);
    EXPECT_DOUBLE_EQ(first.directional_density[33 * 36], 0.509e-2 * kDegree);
}

TEST(Wavewatch, DirectionsAreWhereWavesTravelClockwiseFromNorth) {
    const SpectrumRecord record = read_wavewatch(kWavewatchFile).front();
    // East, north, west and south of libocean are the file's second, first, fourth and third.
    const double file_order[] = {3.0, 1.0, 7.0, 5.0};
    for (std::size_t j = 0; j < 4; ++j) {
        EXPECT_NEAR(record.direction[j], 90.0 * static_cast<double>(j), 1e-9);
        EXPECT_DOUBLE_EQ(record.directional_density[j], file_order[j] * kDegree);
        EXPECT_DOUBLE_EQ(record.directional_density[4 + j], (file_order[j] + 1.0) * kDegree);
    }
    EXPECT_DOUBLE_EQ(record.density[0], 16.0 * 90.0 * kDegree);
}

TEST(Wavewatch, RoundedDirectionsOfAnEvenCircleWeighTheSame) {
    for (const SpectrumRecord& record : read_spectra(kStation)) {
        for (std::size_t i = 0; i < record.frequency.size(); ++i) {
            double sum = 0.0;
            for (std::size_t j = 0; j < 36; ++j) sum += record.directional_density[i * 36 + j];
            EXPECT_NEAR(record.density[i], 10.0 * sum, 1e-12 + 1e-9 * record.density[i]);
        }
    }
}

TEST(Wavewatch, UnevenDirectionsAreAsPrinted) {
    const SpectrumRecord record = read_wavewatch(wavewatch_with("0.157E+01", "0.153E+01")).front();
    EXPECT_NEAR(record.direction[0], 90.0 - 1.53 / kDegree, 1e-9);
    EXPECT_NEAR(record.direction[3], 450.0 - 3.14 / kDegree, 1e-9);
}

TEST(Wavewatch, PointsOfATimeFollowEachOther) {
    const std::vector<SpectrumRecord> records = read_wavewatch(kWavewatchFile);
    ASSERT_EQ(records.size(), 4u);
    EXPECT_EQ(records[1].station, "B b");
    EXPECT_EQ(records[1].time, "2022-09-12T06:00");
    EXPECT_EQ(records[1].longitude, 188.88) << "as the file has it, 0 .. 360 or -180 .. 180";
    EXPECT_DOUBLE_EQ(records[1].directional_density[1], 9.0 * kDegree);
    EXPECT_EQ(records[2].station, "A");
    EXPECT_EQ(records[3].time, "2022-09-12T07:30") << "to the minute";
    EXPECT_DOUBLE_EQ(records[3].directional_density[1], 1.0 * kDegree);
}

TEST(Wavewatch, NamesAndNumbersMayBeGlued) {
    const SpectrumRecord record =
        read_wavewatch(wavewatch_with("'A         '  40.98 -71.12      46.6",
                                      "'off O'Brien'-40.98-171.12 10000.0"))
            .front();
    EXPECT_EQ(record.station, "off O'Brien");
    EXPECT_EQ(record.latitude, -40.98);
    EXPECT_EQ(record.longitude, -171.12);
}

TEST(Wavewatch, NumbersAreReadAsFortranWritesThem) {
    const std::tuple<std::string, double, std::string> numbers[] = {
        {"0.261E-17", 0.261e-17, ""},
        {"0.123-100 x", 0.123e-100, " x"},
        {"0.123+100", 0.123e100, ""},
        {"0.1D-02 ", 0.1e-2, " "},
        {"-1.5d+1", -15.0, ""},
        {"+.5", 0.5, ""},
        {"5.", 5.0, ""},
        {"40.98-171.12", 40.98, "-171.12"},
        {"40.98-7.12", 40.98, "-7.12"},
        {"0.1E-02-0.2E-02", 0.1e-2, "-0.2E-02"},
        {"12-100", 12.0, "-100"},
        {"40.98-71 ", 40.98, "-71 "},
    };
    for (const auto& [spelled, value, after] : numbers) {
        std::string_view rest = spelled;
        EXPECT_EQ(text::next_fortran_number(rest), value) << spelled;
        EXPECT_EQ(rest, after) << spelled;
    }
    for (const std::string none : {"", ".", "-", "E5", "1E", "1E+", "1.2.3", "****", "nan", "inf",
                                   "1x", "1E999", "--1", "0x10", "1,5"}) {
        std::string_view rest = none;
        EXPECT_EQ(text::next_fortran_number(rest), std::nullopt) << none;
        EXPECT_EQ(rest, none);
    }
}

TEST(Wavewatch, ADepthThatIsNotPositiveIsNotKnown) {
    for (const char* depth : {"0.0", "-999.0"}) {
        EXPECT_TRUE(std::isnan(read_wavewatch(wavewatch_with("46.6", depth)).front().depth))
            << depth;
    }
}

TEST(Wavewatch, LineEndsAndLatin1NamesDoNoHarm) {
    std::string crlf = wavewatch_with("'B b  ", "'Ile d'Ol\xE9ron");
    for (std::size_t at = crlf.find('\n'); at != std::string::npos; at = crlf.find('\n', at + 2)) {
        crlf.insert(at, "\r");
    }
    const std::vector<SpectrumRecord> records = read_wavewatch("\xEF\xBB\xBF" + crlf);
    EXPECT_TRUE(same_record(records[0], read_wavewatch(kWavewatchFile)[0]));
    EXPECT_EQ(records[1].station, "Ile d'Ol?ron");
}

TEST(Wavewatch, AFileCutAfterAnyLineIsRefusedUnlessATimeIsComplete) {
    std::size_t lines = 0;
    for (std::size_t at = kWavewatchFile.find('\n'); at + 1 < kWavewatchFile.size();
         at = kWavewatchFile.find('\n', at + 1)) {
        const std::string cut = kWavewatchFile.substr(0, at + 1);
        ++lines;
        if (lines == 10) {
            EXPECT_EQ(read_wavewatch(cut).size(), 2u);
            continue;
        }
        const Refusal refusal = first_fault_of([&] { return read_wavewatch(cut); });
        const bool no_time = lines == 3;
        EXPECT_TRUE(refusal.says(no_time ? "holds no spectrum"
                                         : ":" + std::to_string(lines) + ": the file ends where"))
            << lines << refusal.message;
    }
    EXPECT_EQ(lines, 15u);
}

TEST(Wavewatch, BrokenFilesAreRefusedWithTheLine) {
    const std::tuple<std::string, std::string, std::string> broken[] = {
        {"     2     4     2", " 1000000000     4     2", ":1: 1000000000 frequencies; allowed"},
        {"     2     4     2", "     2   721     2", ":1: 721 directions; allowed: 3 .. 720"},
        {"     2     4     2", "  4000   720     2", ":1: a spectrum has at most 131072 values"},
        {"     2     4     2", "     2     4 -1", ":1: -1 points; allowed"},
        {"     2     4     2", "   2.5     4     2", ":1: 2.5 frequencies"},
        {"     2     4     2 'a", "'a", ":1: ''a' is not the number of frequencies"},
        {"     2     4     2", "     1     4     2", ":1: 1 frequencies; allowed: 2 .. 4096"},
        {"     2     4     2", "     3     4     2", ":3: the frequencies do not ascend at bin 3"},
        {"0.200E+00", "0.200E+00 0.300E+00", ":2: '0.300E+00' after the frequencies"},
        {" 0.100E+00", " 0.200E+00", ":2: the frequencies do not ascend at bin 2"},
        {" 0.100E+00", " -0.10E+00", ":2: a frequency of -0.10E+00; allowed: 1e-5 .. 100 Hz"},
        {" 0.200E+00", " 200.0", ":2: a frequency of 200.0; allowed"},
        {"0.157E+01", "90.0", ":3: a direction of 90.0; allowed: 0 .. 2 pi"},
        {"0.157E+01", "0.314E+01", ":3: a direction appears twice"},
        {"0.471E+01\n", "\n", ":4: a direction of 20220912"},
        {"20220912 06", "20221312 06", ":4: '20221312' where a time"},
        {"20220912 060000", "2022-09-12 06:00", ":4: '2022-09-12' where a time"},
        {"20220912 060000", "20220912 060000 UTC", ":4: 'UTC' after the time"},
        {"'A         '", "", ":5: '40.98' where the name of a point"},
        {"'A         '", "'A", ":5: ''A' where the name of a point"},
        {"40.98", "90.01", ":5: a latitude of 90.01; allowed: -90 .. 90"},
        {"-71.12", "361.0", ":5: a longitude of 361.0; allowed: -180 .. 360"},
        {"46.6", "20001", ":5: a depth of 20001; allowed"},
        {"46.6", "******", ":5: '******' is not a depth: the number was too wide"},
        {" 0.1 94\n", " 0.1\n", ":5: the line ends where a current direction"},
        {" 0.1 94\n", " 0.1 94 7\n", ":5: '7' after the current"},
        {"  0.300E+01", " -0.300E+07", ":6: a density of -0.300E+07; allowed: 0 .. 1e5"},
        {"0.300E+01", "nan", ":6: 'nan' is not a density"},
        {"0.300E+01", "0.3E+301", ":6: a density of 0.3E+301"},
        {"0.300E+01", "*********", ":6: '*********' is not a density: the number was too wide"},
        {"  0.800E+01\n", "  0.800E+01  0.900E+01\n", ":7: '0.900E+01' after the densities"},
        {"  0.800E+01\n", "\n", ":8: ''B' is not a density"},
        {"20220912 073059\n", "", ":11: ''A' where a time"},
    };
    for (const auto& [from, to, words] : broken) {
        const Refusal refusal =
            first_fault_of([text = wavewatch_with(from, to)] { return read_wavewatch(text); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        EXPECT_TRUE(refusal.says("p.spec" + words)) << words << "\n" << refusal.message;
    }
}

TEST(Wavewatch, TextsMayHaveDoubleQuotesOrNone) {
    const std::vector<SpectrumRecord> quoted = read_wavewatch(kWavewatchFile);
    for (const char* mark : {"\"", ""}) {
        std::string content = kWavewatchFile;
        for (std::size_t at = 0; (at = content.find('\'', at)) != std::string::npos;) {
            content.replace(at, 1, mark);
        }
        const std::vector<SpectrumRecord> records = read_wavewatch(content);
        ASSERT_EQ(records.size(), quoted.size()) << mark;
        for (std::size_t i = 0; i < records.size(); ++i) {
            EXPECT_TRUE(same_record(records[i], quoted[i])) << mark << i;
            EXPECT_EQ(records[i].directional_density, quoted[i].directional_density);
        }
    }
    EXPECT_FALSE(kWavewatch.recognises("'WAVEWATCH III SPECTRA 2 4 2\n"));
}

TEST(Wavewatch, APointThatCannotBeReadCostsNoOther) {
    const std::vector<SpectrumRecord> records =
        read_wavewatch(wavewatch_with("  0.300E+01", "  *********"));
    ASSERT_EQ(records.size(), 4u);
    EXPECT_NE(records[0].fault.find("p.spec:6: '*********' is not a density"), std::string::npos);
    EXPECT_EQ(records[0].station, "A");
    for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_TRUE(same_record(records[i], read_wavewatch(kWavewatchFile)[i])) << i;
    }
    const std::vector<SpectrumRecord> cut =
        read_wavewatch(kWavewatchFile.substr(0, kWavewatchFile.size() - 4));
    ASSERT_EQ(cut.size(), 4u) << "the file is growing";
    EXPECT_NE(cut[3].fault.find("the file ends where a density should be"), std::string::npos);
    EXPECT_EQ(cut[2].fault, "");
    const std::vector<SpectrumRecord> time =
        read_wavewatch(wavewatch_with("20220912 060000", "2022091x 060000"));
    ASSERT_EQ(time.size(), 3u);
    EXPECT_NE(time[0].fault.find("p.spec:4: '2022091x' where a time"), std::string::npos);
    EXPECT_EQ(time[1].time, "2022-09-12T07:30");
}

TEST(Wavewatch, NoiseBelowZeroIsTakenAsZero) {
    const SpectrumRecord record =
        read_wavewatch(wavewatch_with("  0.300E+01", " -0.100E-02")).front();
    EXPECT_EQ(record.fault, "");
    ASSERT_EQ(record.warnings.size(), 1u);
    EXPECT_NE(record.warnings[0].find("1 of 8 densities are below 0"), std::string::npos);
}

}  // namespace
}  // namespace ocean::test
