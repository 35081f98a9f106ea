// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The reader of Datawell's .spt against the text of such files: densities relative to the highest,
// directions, the buoy's own height, the information in the file's name, and broken files.
#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "helpers.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/grid.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

const std::string kWaverider = kData + "/spectra/buoy}2024-09-09T01h15Z.spt";

/// Smax is 2.0 m^2/Hz; waves from the west, the south and the east.
const std::string kDatawellFile =
    "10\r\n85.0\r\n4.545\r\n2.0E0\r\n25.05\r\n19.65\r\n7\r\n-0.17625\r\n0.37500\r\n0.26250\r\n"
    "213.8\r\n68.203\r\n"
    "0.100,5.0000E-1,270.0,36.0,1.49,2.34\r\n"  // 13
    "0.150,1.0000E+0,180.0,36.0,0.22,1.57\r\n"
    "0.250,2.5000E-1,90.0,36.0,-0.32,1.99\r\n";

std::vector<SpectrumRecord> read_datawell(const std::string& content,
                                          const std::string& name = "b.spt") {
    return read_spectra_from({content, name, {}});
}
std::string datawell_with(const std::string& from, const std::string& to) {
    return replaced(kDatawellFile, from, to);
}

TEST(Datawell, ReadsWhatTheFileSays) {
    const std::vector<SpectrumRecord> records = read_spectra(kWaverider);
    ASSERT_EQ(records.size(), 1u);
    const SpectrumRecord& record = records[0];
    EXPECT_EQ(record.station, "buoy");
    EXPECT_EQ(record.time, "2024-09-09T01:15");
    EXPECT_TRUE(std::isnan(record.latitude) && std::isnan(record.longitude));
    ASSERT_EQ(record.frequency.size(), 64u);
    EXPECT_EQ(record.frequency[0], 0.025);
    EXPECT_EQ(record.frequency[63], 0.58);
    // "0.140,6.5050E-1,229.2,24.2,6.04,12.74", Smax 5.4183E-1.
    EXPECT_DOUBLE_EQ(record.density[19], 0.65050 * 0.54183);
    const double r1 = 1.0 - 0.5 * std::pow(24.2 * kDegree, 2);
    EXPECT_NEAR(record.a1[19], r1 * std::cos((270.0 - 229.2) * kDegree), 1e-12);
    EXPECT_NEAR(record.b1[19], r1 * std::sin((270.0 - 229.2) * kDegree), 1e-12);
    EXPECT_TRUE(std::isnan(record.a2[19]));
}

TEST(Datawell, HeightIsThatWhichTheBuoyReports) {
    const RecordSummary summary = summarize(read_spectra(kWaverider).front());
    EXPECT_NEAR(4.0 * std::sqrt(summary.m0), 0.850, 0.0025) << "the header's 85.0 cm";
    EXPECT_DOUBLE_EQ(summary.peak_period, 1.0 / 0.16) << "where the relative density is 1";
}

TEST(Datawell, DensitiesAreSharesOfTheHighest) {
    const SpectrumRecord record = read_datawell(kDatawellFile).front();
    EXPECT_EQ(record.density, (std::vector<double>{1.0, 2.0, 0.5}));
}

TEST(Datawell, DirectionsAreWhereWavesComeFrom) {
    const SpectrumRecord record = read_datawell(kDatawellFile).front();
    const double r1 = 1.0 - 0.5 * std::pow(36.0 * kDegree, 2);
    EXPECT_NEAR(record.a1[0], r1, 1e-12) << "from the west to the east";
    EXPECT_NEAR(record.b1[1], r1, 1e-12) << "from the south to the north";
    EXPECT_NEAR(record.a1[2], -r1, 1e-12) << "from the east to the west";
}

TEST(Datawell, StationAndTimeAreThoseOfTheName) {
    const auto origin = [](const std::string& name) {
        const SpectrumRecord record = read_datawell(kDatawellFile, name).front();
        return record.station + " " + record.time;
    };
    EXPECT_EQ(origin("/some/where}/Bragar_2}2012-01-18T22h46Z.spt"), "Bragar_2 2012-01-18T22:46");
    EXPECT_EQ(origin("Bragar_2$}2012-01-18T22h46Z.spt.gz"), "Bragar_2 2012-01-18T22:46");
    EXPECT_EQ(origin("Bragar_2}2012-13-18T22h46Z.spt"), "Bragar_2 ") << "no such month";
    EXPECT_EQ(origin("Bragar_2}"), "Bragar_2 ");
    EXPECT_EQ(origin("now.spt"), " ");
}

TEST(Datawell, ABinWithoutDirectionKeepsItsEnergy) {
    for (const char* missing : {"nan", ""}) {
        const SpectrumRecord record =
            read_datawell(datawell_with("180.0,", missing + std::string(","))).front();
        EXPECT_TRUE(std::isnan(record.a1[1])) << missing;
        EXPECT_FALSE(std::isnan(record.a1[0])) << missing;
        EXPECT_EQ(record.density[1], 2.0) << missing;
    }
}

TEST(Datawell, BrokenFilesAreRefusedWithTheirLine) {
    const std::tuple<std::string, std::string, int, std::string> broken[] = {
        {"2.0E0", "-2.0E0", 4, "the highest density, Smax of -2; allowed: 0 .. 1e6 m^2/Hz"},
        {"2.0E0", "2.0E7", 4, "allowed: 0 .. 1e6"},
        {"2.0E0", "inf", 4, "'inf' is not the highest density, Smax"},
        {"25.05", "warm", 5, "'warm' is not the reference temperature"},
        {"68.203\r\n", "", 12, "'0.100,5.0000E-1,270....' is not the magnetic inclination"},
        {"0.100,", "-0.1,", 13, "a frequency of -0.1; allowed: 1e-5 .. 100 Hz"},
        {"0.150,", "0.1,", 14, "the frequencies do not ascend at bin 2"},
        {"0.150,", "0.15O,", 14, "'0.15O' is not a frequency"},
        {"1.0000E+0", "1.1", 14, "a relative density of 1.1; allowed: 0 .. 1, of Smax"},
        {"1.0000E+0", "-1.1", 14, "a relative density of -1.1"},
        {"1.0000E+0", "nan", 14, "'nan' is not a relative density"},
        {"180.0", "1800", 14, "a direction of 1800; allowed: -360 .. 720 degrees"},
        {"36.0,0.22", "181,0.22", 14, "a spread of 181; allowed: 0 .. 180 degrees"},
        {",0.22,1.57", ",0.22", 14, "fewer than the 6 numbers"},
        {",0.22,1.57", ",0.22,1.57,0", 14, "more than the 6 numbers"},
        {"\r\n0.150", "\r\n\"0.150", 14, "a quote is not closed"},
    };
    for (const auto& [from, to, line, words] : broken) {
        const Refusal refusal =
            refusal_of([text = datawell_with(from, to)] { read_datawell(text); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file) << to;
        const std::string where = "b.spt:" + std::to_string(line) + ": ";
        EXPECT_TRUE(refusal.says(where) && refusal.says(words)) << to << ": " << refusal.message;
    }
    const Refusal cut =
        refusal_of([] { read_datawell(kDatawellFile.substr(0, kDatawellFile.size() - 10)); });
    EXPECT_TRUE(cut.says("b.spt:15: the file ends within this line")) << cut.message;
    const Refusal header =
        refusal_of([] { read_datawell(kDatawellFile.substr(0, kDatawellFile.find("0.100,"))); });
    EXPECT_TRUE(header.says("b.spt: is not a spectrum file of a known format")) << header.message;
    const Refusal one =
        refusal_of([] { read_datawell(kDatawellFile.substr(0, kDatawellFile.find("0.150,"))); });
    EXPECT_TRUE(one.says("b.spt:13: fewer than 2 frequencies")) << one.message;
}

}  // namespace
}  // namespace ocean::test
