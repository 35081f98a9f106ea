// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The readers of Nortek AWAC, Obscape and Octopus: their sample files against wavespectra 4.9.0,
// which reads all three, and the faults of broken files.
#include <gtest/gtest.h>

#include <numbers>
#include <span>
#include <tuple>

#include "helpers.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

/// The values that wavespectra's spec.stats gives: hs, dm, dspr, tm01.
struct Judged {
    const char* time;
    double hs, from, spread, mean_period;
};
void expect_judged(const std::vector<SpectrumRecord>& records, std::span<const Judged> judged,
                   double height_tolerance) {
    ASSERT_EQ(records.size(), judged.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        SCOPED_TRACE(judged[i].time);
        EXPECT_EQ(records[i].time, judged[i].time);
        const RecordSummary summary = summarize(records[i]);
        EXPECT_NEAR(4.0 * std::sqrt(summary.m0), judged[i].hs, height_tolerance * judged[i].hs);
        EXPECT_NEAR(coming_from(summary.mean_direction / kDegree), judged[i].from, 1.0);
        EXPECT_NEAR(summary.directional_spread / kDegree, judged[i].spread, 1.0);
        EXPECT_NEAR(summary.mean_period, judged[i].mean_period, 0.02 * judged[i].mean_period);
    }
}

// --- Nortek AWAC

std::string sentence(const std::string& body) {
    unsigned sum = 0;
    for (const char c : body) sum ^= static_cast<unsigned char>(c);
    return "$" + body + format_text("*%02X\n", sum);
}
/// Waves of 4 sqrt(0.115) = 1.356 m from the east and the south-east.
std::string measurement(const std::string& time, const std::string& hm0 = "1.36",
                        const std::string& densities = "0.5,2.0,6.0,3.0,0.5") {
    const std::string at = ",050120," + time;
    const std::string moments = at + ",3,0.10,0.01,4,";
    return sentence("PNORW" + at + ",3,4," + hm0 + ",2.20,2.73") +
           sentence("PNORE" + at + ",3,0.10,0.01,5," + densities) +
           sentence("PNORF,A1" + moments + "0.0,0.0,-0.5,-9.0000") +
           sentence("PNORF,B1" + moments + "0.8,0.8,0.5,-9.0000") +
           sentence("PNORF,A2" + moments + "-0.6,-0.6,0.0,-9.0000") +
           sentence("PNORF,B2" + moments + "0.0,0.0,-0.3,-9.0000");
}
std::vector<SpectrumRecord> read_awac(const std::string& content) {
    return read_spectra_from({content, "a.nmea", {}});
}

TEST(Awac, AgreesWithWavespectra) {
    std::vector<SpectrumRecord> records = read_spectra(kData + "/spectra/awac.nmea");
    ASSERT_EQ(records.size(), 11u);
    EXPECT_NE(records[0].fault.find("awac.nmea:24: $PNORE, with the densities, is missing at "
                                    "2020-04-30T23:41"),
              std::string::npos);
    records.erase(records.begin());
    const Judged judged[] = {{"2020-05-01T00:01", 2.303, 157.696, 20.757, 9.354},
                             {"2020-05-01T00:21", 2.394, 155.864, 20.798, 9.537},
                             {"2020-05-01T00:41", 2.413, 158.203, 20.077, 9.462},
                             {"2020-05-01T01:01", 2.543, 156.578, 19.674, 9.972},
                             {"2020-05-01T01:21", 2.223, 155.812, 21.413, 9.736},
                             {"2020-05-01T01:41", 2.433, 156.217, 19.837, 9.989},
                             {"2020-05-01T02:01", 2.274, 156.274, 20.744, 9.908},
                             {"2020-05-01T02:21", 2.060, 156.697, 20.870, 9.538},
                             {"2020-05-01T02:41", 2.326, 154.030, 19.244, 9.656},
                             {"2020-05-01T03:01", 2.425, 154.573, 18.273, 10.049}};
    // wavespectra drops the frequencies beyond the 48 of the moments, and scales to Hm0.
    for (SpectrumRecord& record : records) {
        EXPECT_EQ(record.frequency.size(), 98u);
        for (auto* values :
             {&record.frequency, &record.density, &record.a1, &record.b1, &record.a2, &record.b2}) {
            values->resize(48);
        }
    }
    expect_judged(records, judged, 0.01);
}

TEST(Awac, MomentsAreTurnedToWhereWavesTravel) {
    const SpectrumRecord record = read_awac(measurement("000101")).front();
    EXPECT_EQ(record.frequency[0], 0.10);
    EXPECT_NEAR(record.frequency[4], 0.14, 1e-12);
    EXPECT_EQ(record.density, (std::vector<double>{0.5, 2, 6, 3, 0.5}));
    EXPECT_NEAR(std::abs(std::atan2(record.b1[0], record.a1[0])), std::numbers::pi, 1e-12)
        << "from the east they travel to the west";
    EXPECT_NEAR(0.5 * std::atan2(record.b2[0], record.a2[0]), 0.0, 1e-12) << "along that line";
    EXPECT_NEAR(std::atan2(record.b1[2], record.a1[2]), 135.0 * kDegree, 1e-12)
        << "from the south-east to the north-west";
    EXPECT_NEAR(std::atan2(record.b2[2], record.a2[2]), -90.0 * kDegree, 1e-12) << "twice 135";
    EXPECT_TRUE(std::isnan(record.a1[3]) && std::isnan(record.a1[4])) << "-9 and none";
}

TEST(Awac, TheHeightTellsTheUnit) {
    const SpectrumRecord metres = read_awac(measurement("000101")).front();
    EXPECT_EQ(metres.warnings.size(), 1u) << "of the clock alone";
    const SpectrumRecord centimetres =
        read_awac(measurement("000101", "1.36", "5000,20000,60000,30000,5000")).front();
    EXPECT_NEAR(centimetres.density[2], 6.0, 1e-12);
    EXPECT_EQ(centimetres.warnings.size(), 1u);
    const SpectrumRecord other = read_awac(measurement("000101", "2.00")).front();
    ASSERT_EQ(other.warnings.size(), 2u);
    EXPECT_EQ(other.warnings[1],
              "the spectrum has a height of 1.36 m where the instrument says Hm0 = 2.00 m");
    const std::string whole = measurement("000101");
    const SpectrumRecord alone = read_awac(whole.substr(whole.find("$PNORE"))).front();
    ASSERT_EQ(alone.warnings.size(), 2u);
    EXPECT_NE(alone.warnings[1].find("m^2/Hz is assumed"), std::string::npos);
}

TEST(Awac, ASentenceThatIsDamagedCostsItsMeasurement) {
    const std::string first = measurement("000101");
    const std::string second = measurement("002101");
    for (const auto& [from, to, words] :
         {std::tuple{"2.0,6.0", "2.0,7.0", "a.nmea:2: the checksum of the sentence is wrong"},
          {"6.0,3.0,0.5*", "6.0,3.0,0.5", "a.nmea:2: the sentence has no checksum: it is cut off"},
          {"0.8,0.8,0.5", "0.8,0.8,0.6", "a.nmea:4: the checksum"}}) {
        const std::vector<SpectrumRecord> records = read_awac(replaced(first, from, to) + second);
        ASSERT_EQ(records.size(), 2u);
        EXPECT_NE(records[0].fault.find(words), std::string::npos) << records[0].fault;
        EXPECT_EQ(records[1].fault, "");
        EXPECT_EQ(records[1].time, "2020-05-01T00:21");
    }
    const std::string count = sentence("PNORE,050120,000101,3,0.10,0.01,6,0.5,2.0,6.0,3.0,0.5");
    EXPECT_TRUE(
        first_fault_of([&] { return read_awac(count); }).says("5 values for 6 frequencies"));
    const std::string date = sentence("PNORE,130120,000101,3,0.10,0.01,3,0.5,2.0,6.0");
    EXPECT_TRUE(first_fault_of([&] { return read_awac(date); }).says("date and time, MMDDYY"));
    const std::string twice = first + first;
    EXPECT_TRUE(first_fault_of([&] { return read_awac(twice); }).says("a second $PNORE"));
}

// --- Obscape

const std::string kObscapeFile =
    "# Station name = North pier\n# Latitude [deg] = 12.5\n# Longitude [deg] = -1.5\n"
    "# Timestamp = 1712136600\n# Columns [deg] = 0,90,... 270\n# Rows [Hz] = 0.1,0.2\n"
    "# Variance-density [m2/Hz/rad]\n1,2,-0.1,0\n3,4,0,0\n";
std::vector<SpectrumRecord> read_obscape(const std::string& content) {
    return read_spectra_from({content, "o.csv", {}});
}

TEST(Obscape, AgreesWithWavespectra) {
    const Judged judged[] = {{"2024-04-03T09:30", 0.062462, 21.811, 67.131, 3.244}};
    expect_judged(read_spectra(kData + "/spectra/obscape.csv"), judged, 0.01);
}

TEST(Obscape, ReadsWhatTheFileSays) {
    const SpectrumRecord record = read_obscape(kObscapeFile).front();
    EXPECT_EQ(record.station, "North pier");
    EXPECT_EQ(record.time, "2024-04-03T09:30");
    EXPECT_EQ(record.latitude, 12.5);
    EXPECT_EQ(record.longitude, -1.5);
    EXPECT_EQ(record.frequency, (std::vector<double>{0.1, 0.2}));
    EXPECT_EQ(record.direction, (std::vector<double>{0, 90, 180, 270}));
    // From the north travels south, 270 degrees from east; 4 of the second row from the east.
    EXPECT_NEAR(record.directional_density[4 + 3] / record.directional_density[4 + 2], 0.75, 1e-12);
    EXPECT_NEAR(4.0 * std::sqrt(summarize(record).m0),
                4.0 * std::sqrt(0.1 * 0.5 * (2.9 + 7.0) * 0.5 * std::numbers::pi), 1e-9);
    EXPECT_EQ(record.warnings.size(), 1u) << "-0.1 counts as 0";
    const SpectrumRecord degrees =
        read_obscape(replaced(kObscapeFile, "m2/Hz/rad", "m2/Hz/deg")).front();
    EXPECT_NEAR(degrees.density[1] / record.density[1], 180.0 / std::numbers::pi, 1e-9);
}

TEST(Obscape, BrokenFilesAreRefusedWithTheirLine) {
    const std::tuple<std::string, std::string, std::string> broken[] = {
        {"0,90,... 270", "0,90,... 271",
         "o.csv:5: the meaning of '...' in the directions is unclear"},
        {"0,90,... 270", "0,90", "o.csv:5: a directional spectrum needs at least 3"},
        {"0.1,0.2", "0.2,0.1", "o.csv:6: the frequencies do not ascend at bin 2"},
        {"m2/Hz/rad", "m2/Hz", "o.csv:7: units 'm2/Hz'"},
        {"1,2,-0.1,0", "1,2,x,0", "o.csv:8: 'x' is not a number of a density"},
        {"1,2,-0.1,0", "1,2,-0.1", "o.csv:8: fewer values than the 4 directions"},
        {"3,4,0,0\n", "", "o.csv:8: the file ends where row 2 of 2 should be"},
        {"3,4,0,0\n", "3,4,0,0\n5,6,7,8\n", "o.csv:10: more rows than the header"},
        {"1712136600", "soon", "o.csv:4: 'soon' is not a number of Timestamp"},
    };
    for (const auto& [from, to, words] : broken) {
        const Refusal refusal = first_fault_of(
            [text = replaced(kObscapeFile, from, to)] { return read_obscape(text); });
        EXPECT_TRUE(refusal.says(words)) << refusal.message;
    }
}

// --- Octopus

const std::string kOctopusFile =
    "Forecast valid for 11-Mar-2018 00:00:00\nnfreqs,3\nndir,4\nnrecs,2\nLatitude, -39.9723\n"
    "Longitude, 173.3090\nDepth,102.3285\n\nCCYYMM,DDHHmm,LPoint,WD\n"
    "201803,'110000,maari_20180311_00z,123\nfreq,0.1,0.2,0.4,anspec\n"
    "0,0,0.01,0,0.01,\n90,0.02,0.03,0,0.05,\n180,0,0,0,0,\n270,0,0.01,0.02,0.03,\n"
    "fSpec,0.02,0.05,0.02,\nden,1,1,1,\n\nCCYYMM,DDHHmm,LPoint,WD\n"
    "201803,'120630,maari_20180312_00z,123\nfreq,0.1,0.2,0.4,anspec\n"
    "0,0,0.04,0,0.01,\n90,0,0,0,0.05,\n180,0,0,0,0,\n270,0,0,0,0.03,\n";
std::vector<SpectrumRecord> read_octopus(const std::string& content) {
    return read_spectra_from({content, "f.oct", {}});
}

TEST(Octopus, AgreesWithWavespectra) {
    const Judged judged[] = {{"2018-03-11T00:00", 1.098, 230.101, 48.838, 6.540},
                             {"2018-03-12T00:00", 0.947, 254.603, 45.381, 8.266},
                             {"2018-03-13T00:00", 2.206, 254.407, 27.224, 5.598},
                             {"2018-03-14T00:00", 2.836, 247.227, 19.801, 8.238},
                             {"2018-03-15T00:00", 2.018, 248.300, 18.869, 8.765}};
    expect_judged(read_spectra(kData + "/spectra/octopus.oct"), judged, 0.01);
}

TEST(Octopus, TheSumOfTheEnergiesIsTheVariance) {
    const std::vector<SpectrumRecord> records = read_octopus(kOctopusFile);
    ASSERT_EQ(records.size(), 2u);
    EXPECT_NEAR(summarize(records[0]).m0, 0.09, 1e-12);
    EXPECT_NEAR(summarize(records[1]).m0, 0.04, 1e-12);
    EXPECT_EQ(records[0].station, "maari");
    EXPECT_EQ(records[1].time, "2018-03-12T06:30");
    EXPECT_EQ(records[0].latitude, -39.9723);
    EXPECT_EQ(records[0].depth, 102.3285);
    EXPECT_NEAR(coming_from(summarize(records[1]).mean_direction / kDegree), 0.0, 1e-9);
}

TEST(Octopus, BrokenFilesAreRefusedWithTheirLine) {
    const std::tuple<std::string, std::string, std::string> broken[] = {
        {"nfreqs,3", "nfreqs,1", "f.oct:2: '1' is not nfreqs within 2 .. 4096"},
        {"ndir,4", "dirs,4", "f.oct:3: 'dirs,4' where ndir should be"},
        {"Latitude, -39.9723", "Latitude, S", "f.oct:5: 'S' is not Latitude"},
        {"'110000", "'310261", "f.oct:10: '201803310261' where a time"},
        {"freq,0.1,0.2", "freq,0.2,0.1", "f.oct:11: the frequencies do not ascend at bin 2"},
        {"0,0,0.01,0,0.01,", "0,0,***,0,0.01,", "f.oct:12: '***' is not an energy"},
        {"270,0,0.01,0.02,0.03,\n", "", "f.oct:15: 'fSpec' is not a direction"},
        {"270,0,0.01,0.02,0.03,\nfSpec,0.02,0.05,0.02,\nden,1,1,1,\n\n", "",
         "f.oct:15: 'CCYYMM' is not a direction"},
    };
    for (const auto& [from, to, words] : broken) {
        const Refusal refusal = first_fault_of(
            [text = replaced(kOctopusFile, from, to)] { return read_octopus(text); });
        EXPECT_TRUE(refusal.says(words)) << refusal.message;
    }
    const std::vector<SpectrumRecord> records = read_octopus(
        replaced(kOctopusFile, "270,0,0.01,0.02,0.03,\nfSpec,0.02,0.05,0.02,\nden,1,1,1,\n\n", ""));
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[1].fault, "") << "a record that ends early does not cost the next";
}

}  // namespace
}  // namespace ocean::test
