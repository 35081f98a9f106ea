// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The reader of SWAN's spectral files against the text of such files: values, directions, units,
// several locations and times, missing ones, and broken files.
#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "helpers.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/grid.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

const std::string kCoast = kData + "/spectra/swan_nz_west_coast.spec";
const std::string kOverFrequency = kData + "/spectra/swan_1d.spec";

/// Three locations, two times, two frequencies, and waves from the north, east, south and west.
const std::string kSwanFile =
    "SWAN   1                Swan standard spectral file\n"    // 1
    "$ a comment\n"                                            // 2
    "TIME                    time-dependent data\n"            // 3
    "     1                  time coding option\n"             // 4
    "LONLAT                  locations\n"                      // 5
    "     3                  number of locations\n"            // 6
    "  174.67  -38.17\n"                                       // 7
    "  174.77  -38.17\n"                                       // 8
    "  184.87  -38.27  'pier head'\n"                          // 9
    "AFREQ                   absolute frequencies in Hz\n"     // 10
    "     2                  number of frequencies\n"          // 11
    "    0.1000              first\n"                          // 12
    "    0.2000\n"                                             // 13
    "NDIR                    nautical directions in degr\n"    // 14
    "     4                  number of directions\n"           // 15
    "  0. 90. 180. 270.\n"                                     // 16
    "QUANT\n"                                                  // 17
    "     1                  number of quantities in table\n"  // 18
    "VaDens                  variance densities\n"             // 19
    "m2/Hz/degr              unit\n"                           // 20
    "   -99                  exception value\n"                // 21
    "20161011.030059         date and time\n"                  // 22
    "FACTOR\n"                                                 // 23
    "    0.5D-02\n"                                            // 24
    "   1   2   3   4\n"                                       // 25
    "   5   6\n"                                               // 26
    "   7   8\n"                                               // 27
    "ZERO\n"                                                   // 28
    "NODATA\n"                                                 // 29
    "20161011.060000         date and time\n"                  // 30
    "NODATA\n"                                                 // 31
    "NODATA\n"                                                 // 32
    "FACTOR 1.0\n"                                             // 33
    "   1   2   3   4\n"                                       // 34
    "$ another comment\n"                                      // 35
    "   5   6   7 -99\n";                                      // 36

std::vector<SpectrumRecord> read_swan(const std::string& content) {
    return read_spectra_from({content, "s.spec", {}});
}

std::string swan_with(const std::string& from, const std::string& to) {
    return replaced(kSwanFile, from, to);
}

/// One location, one direction quantity, two frequencies.
std::string over_frequency(const std::string& quantities, const std::string& rows) {
    return "SWAN 1\nLOCATIONS\n1\n0.5 -2\nRFREQ\n2\n0.1\n0.2\nQUANT\n" + quantities +
           "LOCATION 1\n" + rows;
}

/// One spectrum over frequency, of a time in a coding of times.
std::string at_time(const std::string& coding_option, const std::string& time) {
    return "SWAN 1\nTIME\n" + coding_option +
           "\nLONLAT\n1\n0 0\nAFREQ\n2\n.1 .2\nQUANT\n1\nVaDens\nm2/Hz\n-99\n" + time +
           "\nLOCATION 1\n1\n2\n";
}

TEST(Swan, ReadsWhatTheFileSays) {
    const std::vector<SpectrumRecord> records = read_spectra(kCoast);
    ASSERT_EQ(records.size(), 5u);
    EXPECT_EQ(records[0].time, "2016-10-11T00:00");
    EXPECT_EQ(records[4].time, "2016-10-15T00:00");
    const SpectrumRecord& first = records[0];
    EXPECT_EQ(first.station, "");
    EXPECT_EQ(first.latitude, -38.173599);
    EXPECT_EQ(first.longitude, 174.672501);
    EXPECT_TRUE(std::isnan(first.depth));
    ASSERT_EQ(first.frequency.size(), 24u);
    EXPECT_EQ(first.frequency[5], 0.0737);
    ASSERT_EQ(first.direction.size(), 36u);
    // The sixth row: 9998 from 245 degrees, travelling to 65 degrees from north, 25 from east.
    EXPECT_EQ(first.direction[2], 25.0);
    EXPECT_DOUBLE_EQ(first.directional_density[5 * 36 + 2], 9998 * 1.68566278e-5);
}

TEST(Swan, NauticalDirectionsAreWhereWavesComeFrom) {
    const SpectrumRecord record = read_swan(kSwanFile).front();
    // From the west: to the east. Then from the south, east and north.
    const double file_order[] = {4.0, 3.0, 2.0, 1.0};
    for (std::size_t j = 0; j < 4; ++j) {
        EXPECT_EQ(record.direction[j], 90.0 * static_cast<double>(j));
        EXPECT_DOUBLE_EQ(record.directional_density[j], file_order[j] * 0.005);
        EXPECT_DOUBLE_EQ(record.directional_density[4 + j], (file_order[j] + 4.0) * 0.005);
    }
    EXPECT_DOUBLE_EQ(record.density[0], 10.0 * 90.0 * 0.005);
}

TEST(Swan, CartesianDirectionsAreWhereWavesTravel) {
    const SpectrumRecord record = read_swan(swan_with("NDIR", "CDIR")).front();
    for (std::size_t j = 0; j < 4; ++j) {
        EXPECT_DOUBLE_EQ(record.directional_density[j], (static_cast<double>(j) + 1.0) * 0.005);
    }
}

TEST(Swan, ZeroIsACalmAndNoDataIsNoRecord) {
    const std::vector<SpectrumRecord> records = read_swan(kSwanFile);
    ASSERT_EQ(records.size(), 3u);
    EXPECT_EQ(records[1].longitude, 174.77);
    EXPECT_EQ(records[1].time, "2016-10-11T03:00");
    EXPECT_EQ(records[1].directional_density, std::vector<double>(8, 0.0));
    EXPECT_EQ(records[2].station, "pier head");
    EXPECT_EQ(records[2].latitude, -38.27);
    EXPECT_EQ(records[2].time, "2016-10-11T06:00");
    EXPECT_EQ(records[2].directional_density[0], 4.0);
    EXPECT_EQ(records[2].directional_density[4], 0.0) << "the exception value is missing energy";
    EXPECT_EQ(records[2].directional_density[5], 7.0);
}

TEST(Swan, EnergyIsMadeVariance) {
    const std::string energy = replaced(swan_with("m2/Hz", "J/m2/Hz"), "VaDens", "EnDens");
    EXPECT_DOUBLE_EQ(read_swan(energy).front().density[0], 10.0 * 90.0 * 0.005 / (1025.0 * 9.81));
}

TEST(Swan, AStationaryFileHasNoTimeAndMetresAreNoDegrees) {
    const std::string stationary =
        "SWAN 1\nLOCATIONS\n2\n1000.0 -2500.5\n95 0 mole\nRFREQ\n2\n0.1 0.2\nCDIR\n3\n"
        "0\n120\n240\nQUANT\n1\nVaDens\nm2/Hz/degr\n-99\nZERO\nFACTOR\n1\n1 2 3\n4 5 6\n";
    const std::vector<SpectrumRecord> records = read_swan(stationary);
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0].time, "");
    EXPECT_EQ(records[0].station, "1000.0 -2500.5");
    EXPECT_TRUE(std::isnan(records[0].latitude) && std::isnan(records[0].longitude));
    EXPECT_EQ(records[1].station, "mole");
    EXPECT_EQ(records[1].directional_density, (std::vector<double>{1, 2, 3, 4, 5, 6}));
    const Refusal refusal = first_fault_of([&] { return read_swan(stationary + "ZERO\n"); });
    EXPECT_TRUE(refusal.says("s.spec:24: 'ZERO' after the last location")) << refusal.message;
}

TEST(Swan, OverFrequencyMeanAndSpreadBecomeMoments) {
    const std::vector<SpectrumRecord> records = read_spectra(kOverFrequency);
    ASSERT_EQ(records.size(), 3u) << "three of six are NODATA";
    const SpectrumRecord& first = records[0];
    EXPECT_EQ(first.time, "1987-05-30T15:30");
    EXPECT_EQ(first.station, "1000.00 2500.00");
    EXPECT_EQ(first.density, (std::vector<double>{0.0, 2.5, 4.0, 0.5}));
    EXPECT_FALSE(first.is_directional());
    EXPECT_TRUE(std::isnan(first.a1[0])) << "exception values";
    EXPECT_NEAR(std::atan2(first.b1[1], first.a1[1]), 30.0 * kDegree, 1e-12);
    EXPECT_NEAR(std::hypot(first.a1[1], first.b1[1]), 1.0 - 0.5 * std::pow(20.0 * kDegree, 2.0),
                1e-12);
    EXPECT_EQ(records[1].station, "pier head");
    EXPECT_EQ(records[1].density[0], 0.0) << "a missing density";
    EXPECT_EQ(records[2].time, "1987-05-30T18:00");
    EXPECT_NEAR(records[2].b1[0], 1.0 - 0.5 * std::pow(15.0 * kDegree, 2.0), 1e-12);
}

TEST(Swan, QuantitiesOverFrequencyComeInAnyOrderAndUnit) {
    const SpectrumRecord record =
        read_swan(over_frequency("3\nDSPR\n-\n-9\nNDIR\ndegr\n-999\nEnDens\nJ/m2/Hz\n-99\n",
                                 "2 270 1000\n2 180\n2000\n"))
            .front();
    EXPECT_DOUBLE_EQ(record.density[1], 2000.0 / (1025.0 * 9.81));
    // cos^2 over a half circle: r1 = 8 / (3 pi). From the west to the east, then to the north.
    EXPECT_NEAR(record.a1[0], 8.0 / (3.0 * std::numbers::pi), 1e-12);
    EXPECT_NEAR(record.b1[1], 8.0 / (3.0 * std::numbers::pi), 1e-12);
}

TEST(Swan, OverFrequencyWithoutKnownDirectionsThereAreNone) {
    EXPECT_FALSE(
        read_swan(over_frequency("1\nVaDens\nm2/Hz\n-99\n", "1\n2\n")).front().has_moments());
    const std::string missing = over_frequency(
        "3\nVaDens\nm2/Hz\n-99\nCDIR\ndegr\n-999\nDSPRDEGR\ndegr\n-9\n", "1 -999 -9\n2 30 -9\n");
    EXPECT_FALSE(read_swan(missing).front().has_moments());
}

TEST(Swan, TimesAreReadByTheirCodingOption) {
    for (const auto& [option, time] : {std::pair{"1", "19870530.153000"},
                                       {"2", "'30-May-87 15:30:00'"},
                                       {"3", "05/30/87.15:30:00"},
                                       {"5", "87/05/30 15:30:00'"},
                                       {"6", "8705301530"}}) {
        EXPECT_EQ(read_swan(at_time(option, time)).front().time, "1987-05-30T15:30") << option;
    }
    const Refusal month = refusal_of([] { read_swan(at_time("2", "'30-anf-87 15:30:00'")); });
    EXPECT_TRUE(month.says("s.spec:15: '30-anf-87' where a time like DD-bbb-YY")) << month.message;
    const Refusal refusal = refusal_of([] { read_swan(at_time("4", "15:30:00")); });
    EXPECT_TRUE(refusal.says("s.spec:3: time coding option 4 has no dates")) << refusal.message;
}

TEST(Swan, TwoDigitsOfAYearAreWithin1950To2049) {
    for (const auto& [year, full] :
         {std::pair{"50", "1950"}, {"99", "1999"}, {"00", "2000"}, {"49", "2049"}}) {
        EXPECT_EQ(read_swan(at_time("6", year + std::string("01020304"))).front().time,
                  full + std::string("-01-02T03:04"));
    }
}

TEST(Swan, LineEndsAndBytesOfCommentsDoNoHarm) {
    std::string crlf = swan_with("$ a comment", "$ Ol\xE9ron");
    for (std::size_t at = crlf.find('\n'); at != std::string::npos; at = crlf.find('\n', at + 2)) {
        crlf.insert(at, "\r");
    }
    EXPECT_EQ(read_swan("\xEF\xBB\xBF" + crlf)[2].directional_density,
              read_swan(kSwanFile)[2].directional_density);
}

TEST(Swan, AFileCutAfterAnyLineIsRefusedUnlessATimeIsComplete) {
    std::size_t lines = 0;
    for (std::size_t at = kSwanFile.find('\n'); at + 1 < kSwanFile.size();
         at = kSwanFile.find('\n', at + 1)) {
        const std::string cut = kSwanFile.substr(0, at + 1);
        ++lines;
        if (lines == 29) {
            EXPECT_EQ(read_swan(cut).size(), 2u);
            continue;
        }
        const Refusal refusal = first_fault_of([&] { return read_swan(cut); });
        EXPECT_TRUE(refusal.says(lines == 21 ? "holds no spectrum" : ": the file ends where"))
            << lines << refusal.message;
    }
    EXPECT_EQ(lines, 35u);
}

TEST(Swan, ShortWordsForHugeSpectraAreRefused) {
    std::string file = "SWAN 1\nLONLAT\n2000\n";
    for (int i = 0; i < 2000; ++i) file += "0 0\n";
    file += "AFREQ\n180\n";
    for (int i = 1; i <= 180; ++i) file += std::to_string(i * 0.01) + "\n";
    file += "CDIR\n720\n";
    for (int i = 0; i < 720; ++i) file += std::to_string(i * 0.5) + "\n";
    file += "QUANT\n1\nVaDens\nm2/Hz/degr\n-99\n";
    for (int i = 0; i < 2000; ++i) file += "ZERO\n";
    const Refusal refusal = refusal_of([&] { read_swan(file); });
    EXPECT_TRUE(refusal.says("more than 67108864 values over all records")) << refusal.message;
}

TEST(Swan, BrokenFilesAreRefusedWithTheLine) {
    const std::tuple<std::string, std::string, std::string> broken[] = {
        {"SWAN   1", "SWAN   2", ":1: version 2 of SWAN's files; known: 1"},
        {"TIME ", "TIDE ", ":3: 'TIDE' where TIME or ITER or LONLAT or LOCATIONS should be"},
        {"     1                  time", "     7 time",
         ":4: 7 as time coding option; allowed: 1 .. 6"},
        {"     3                  number", " 1000000000 ", ":6: 1000000000 locations; allowed"},
        {"     3                  number", "     2 number", ":9: '184.87' where AFREQ or RFREQ"},
        {"     3                  number", "     4 number", ":10: 'AFREQ' is not a coordinate"},
        {"174.67", "361.0", ":7: a longitude of 361.0; allowed: -180 .. 360"},
        {"-38.17", "-90.5", ":7: a latitude of -90.5; allowed: -90 .. 90"},
        {"-38.17\n", "\n", ":7: the line ends where a coordinate"},
        {"AFREQ", "PERIOD", ":10: 'PERIOD' where AFREQ or RFREQ"},
        {"     2 ", "  5000 ", ":11: 5000 frequencies; allowed: 2 .. 4096"},
        {"     2 ", "     3 ", ":14: 'NDIR' is not a frequency"},
        {"0.2000", "0.1000", ":13: the frequencies do not ascend at bin 2"},
        {"0.1000", "-0.1000", ":12: a frequency of -0.1000; allowed: 1e-5 .. 100 Hz"},
        {"0.1000", "0.1O00", ":12: '0.1O00' is not a frequency"},
        {"     4     ", "  1e9     ", ":15: 1e9 directions; allowed: 3 .. 720"},
        {" 90.", " 1234.", ":16: a direction of 1234.; allowed"},
        {" 90.", " 0.", ":16: a direction appears twice"},
        {"     1                  number of q", " 2 ", ":18: 2 quantities; allowed: 1 .. 1"},
        {"VaDens", "Hs", ":19: 'Hs' is not a quantity; known: VaDens, EnDens"},
        {"m2/Hz/degr", "m2/Hz/gon", ":20: 'm2/Hz/gon' is not a unit of VaDens; known: m2/Hz/degr"},
        {"   -99    ", "   none   ", ":21: 'none' is not an exception value"},
        {"20161011.03", "20161311.03", ":22: '20161311.030059' where a time like YYYYMMDD.hhmmss"},
        {"20161011.030059", "20161011.030060", ":22: '20161011.030060' where a time"},
        {"20161011.030059", "20161011.0300597", ":22: '20161011.0300597' where a time"},
        {"FACTOR", "VECTOR", ":23: 'VECTOR' where FACTOR, ZERO or NODATA"},
        {"0.5D-02", "-0.5D-02", ":24: a factor of -0.5D-02; allowed: 0 or more"},
        {"0.5D-02", "********", ":24: '********' is not a factor: the number was too wide"},
        {"0.5D-02", "1e10", ":25: 1 times the factor is not within 0 .. 2500 m2/Hz/degr"},
        {"   1   2   3   4\n", "   1   2   3\n", ":26: '6' after the values of all directions"},
        {"   1   2   3   4\n", "   1   2   3   4   5\n", ":25: '5' after the values"},
        {"   1   2   3   4\n", "   1   2   3  -9e9\n", ":25: -9e9 times the factor"},
        {"   1   2   3   4\n", "   1   2 nan   4\n", ":25: 'nan' is not a density"},
        {"   7   8\n", "", ":27: 'ZERO' is not a density"},
        {"ZERO\n", "", ":29: a time where location 3 of 3 should be"},
        {"NODATA\n20161011", "NODATA\nNODATA\n20161011", ":30: 'NODATA' where a time"},
    };
    for (const auto& [from, to, words] : broken) {
        const Refusal refusal =
            first_fault_of([text = swan_with(from, to)] { return read_swan(text); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        EXPECT_TRUE(refusal.says("s.spec" + words)) << words << "\n" << refusal.message;
    }
}

TEST(Swan, BrokenQuantitiesAreRefusedWithTheLine) {
    const std::string good = "3\nVaDens\nm2/Hz\n-99\nCDIR\ndegr\n-999\nDSPRDEGR\ndegr\n-9\n";
    const std::tuple<std::string, std::string, std::string> broken[] = {
        {"VaDens\nm2/Hz\n-99", "DSPR\ndegr\n-99", ":17: a second DSPRDEGR"},
        {"3\nVaDens\nm2/Hz\n-99", "2", ":16: no VaDens, EnDens or AcDens among the quantities"},
        {"m2/Hz", "m2/Hz/degr", ":12: 'm2/Hz/degr' is not a unit of VaDens; known: m2/Hz"},
        {"CDIR\ndegr", "CDIR\nrad", ":15: 'rad' is not a unit of CDIR; known: degr"},
        {"LOCATION 1", "LOCATION 2", ":20: LOCATION 2 where LOCATION 1 should be"},
        {"LOCATION 1", "FACTOR", ":20: 'FACTOR' where LOCATION or NODATA"},
        {"1 30 20", "-2e6 30 20", ":21: a density of -2e6; allowed: 0 .. 1e6"},
        {"1 30 20", "1 1000 20", ":21: a direction of 1000; allowed"},
        {"1 30 20", "1 30 -20", ":21: a spread of -20; allowed"},
        {"1 30 20", "1 30", ":22: '30' after the quantities of a frequency"},
        {"2 30 20\n", "", ":21: the file ends where a number should be"},
    };
    const std::string file = over_frequency(good, "1 30 20\n2 30 20\n");
    EXPECT_EQ(read_swan(file).size(), 1u);
    for (const auto& [from, to, words] : broken) {
        const Refusal refusal = refusal_of([text = replaced(file, from, to)] { read_swan(text); });
        EXPECT_TRUE(refusal.says("s.spec" + words)) << words << "\n" << refusal.message;
    }
}

TEST(Swan, RealNumbersAreReadAsTheyAre) {
    const std::string real = swan_with("   1   2   3   4\n", " 1.5 2.5E0 0.35D+1 4.25\n");
    EXPECT_EQ(read_swan(real)[0].directional_density[0], 4.25 * 0.005)
        << "from the west, to the east";
    const std::string repeated = swan_with("   1   2   3   4\n", " 2*1.5 2*2.5\n");
    EXPECT_EQ(
        read_swan(repeated)[0].directional_density,
        read_swan(swan_with("   1   2   3   4\n", " 1.5 1.5 2.5 2.5\n"))[0].directional_density);
    EXPECT_TRUE(first_fault_of([] {
                    return read_swan(swan_with("   1   2   3   4\n", " 3*1.5 2*2.5\n"));
                }).says("s.spec:25: more numbers than the values of all directions"));
}

TEST(Swan, ActionTimesTheAngularFrequencyIsVariance) {
    const SpectrumRecord variance = read_swan(kSwanFile)[0];
    for (const char* unit : {"m2s/Hz/degr", "m2s/Hz/deg", "m2 s/Hz/degr", "m2*s/Hz/deg"}) {
        std::string content = swan_with("VaDens", "AcDens");
        content.replace(content.find("m2/Hz/degr"), 10, unit);
        const SpectrumRecord action = read_swan(content)[0];
        for (std::size_t i = 0; i < action.directional_density.size(); ++i) {
            const double omega = 2.0 * std::numbers::pi * action.frequency[i / 4];
            EXPECT_NEAR(action.directional_density[i], omega * variance.directional_density[i],
                        1e-15);
        }
    }
    std::string radians = swan_with("m2/Hz/degr", "m2/Hz/rad");
    EXPECT_NEAR(read_swan(radians)[0].density[0], variance.density[0] * kDegree, 1e-15);
    const std::string one_dimensional = over_frequency("1\nAcDens\nm2s/Hz\n-99\n", "1\n2\n");
    EXPECT_NEAR(read_swan(one_dimensional)[0].density[1],
                2.0 * 2.0 * std::numbers::pi * read_swan(one_dimensional)[0].frequency[1], 1e-12);
}

TEST(Swan, OfIterationsTheLastIsTheResult) {
    std::string content = swan_with("TIME ", "ITER ");
    content.replace(content.find("20161011.030059"), 15, "              7");
    content.replace(content.find("20161011.060000"), 15, "              8");
    const std::vector<SpectrumRecord> records = read_swan(content);
    ASSERT_EQ(records.size(), 1u) << "the others are NODATA";
    EXPECT_EQ(records[0].time, "");
    EXPECT_EQ(records[0].station, "pier head");
    ASSERT_EQ(records[0].warnings.size(), 1u);
    EXPECT_EQ(records[0].warnings[0],
              "the file has 2 iterations of one state: the last, number 8, is the result");
    const std::vector<SpectrumRecord> cut = read_swan(content.substr(0, content.rfind("   5   6")));
    ASSERT_EQ(cut.size(), 2u) << "of the iteration before";
    EXPECT_EQ(cut[0].warnings[0],
              "the file has 2 iterations of one state: number 8 cannot be read "
              "whole, and the one before it is taken");
}

TEST(Swan, AValueThatIsNoNumberCostsItsLocation) {
    const std::vector<SpectrumRecord> records =
        read_swan(swan_with("   1   2   3   4\n", "   1   2 ***   4\n"));
    ASSERT_EQ(records.size(), 3u);
    EXPECT_NE(records[0].fault.find("s.spec:25: '***' is not a density"), std::string::npos);
    EXPECT_EQ(records[0].longitude, 174.67);
    EXPECT_EQ(records[1].fault, "");
    EXPECT_EQ(records[1].longitude, 174.77) << "ZERO is the second's";
    EXPECT_EQ(records[2].time, "2016-10-11T06:00");
}

TEST(Swan, BehindALostLocationThePlacesAreNotKnown) {
    // The word of the first location is lost, so that ZERO would be taken for it.
    const std::vector<SpectrumRecord> records = read_swan(swan_with("FACTOR\n    0.5D-02\n", "\n"));
    ASSERT_EQ(records.size(), 3u);
    EXPECT_NE(records[0].fault.find("where FACTOR, ZERO or NODATA should be"), std::string::npos);
    EXPECT_EQ(records[1].fault, "") << "the file has as many as it should";
    const std::vector<SpectrumRecord> fewer = read_swan(
        swan_with("FACTOR\n    0.5D-02\n   1   2   3   4\n   5   6\n   7   8\n", "garbage\n"));
    ASSERT_EQ(fewer.size(), 3u);
    EXPECT_NE(fewer[0].fault.find("'garbage' where FACTOR"), std::string::npos);
    EXPECT_EQ(fewer[1].fault, "") << "two words follow, for the second and third";
    const std::vector<SpectrumRecord> lost = read_swan(
        swan_with("FACTOR\n    0.5D-02\n   1   2   3   4\n   5   6\n   7   8\nZERO\nNODATA\n",
                  "garbage\nZERO\n"));
    ASSERT_EQ(lost.size(), 4u);
    EXPECT_NE(lost[1].fault.find("the place of this one is not known"), std::string::npos);
    EXPECT_NE(lost[2].fault.find("a time where location 3 of 3"), std::string::npos);
    EXPECT_EQ(lost[3].fault, "");
}

}  // namespace
}  // namespace ocean::test
