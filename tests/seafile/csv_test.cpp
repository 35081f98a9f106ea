// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the corpus does not show of CSV: which headers are taken for CSV, what is wrong with those
// that are not, and a whole record against that of another format.

#include "helpers.hpp"

namespace ocean::test {
namespace {

TEST(Csv, TheBuoyAsCsvHasTheFirstMomentsOfTheBuoy) {
    const SpectrumRecord record = read_spectra(kData + "/spectra/ndbc_41010.csv").front();
    const SpectrumRecord buoy = read_spectra(kBuoy).front();
    EXPECT_EQ(record.station, buoy.station);
    EXPECT_EQ(record.time, buoy.time);
    EXPECT_EQ(record.frequency, buoy.frequency);
    EXPECT_EQ(record.density, buoy.density);
    ASSERT_TRUE(record.has_moments());
    for (std::size_t i = 0; i < buoy.frequency.size(); ++i) {
        ASSERT_EQ(std::isnan(record.a1[i]), std::isnan(buoy.a1[i])) << i;
        if (std::isnan(buoy.a1[i])) continue;
        EXPECT_NEAR(record.a1[i], buoy.a1[i], 2e-6) << i;
        EXPECT_NEAR(record.b1[i], buoy.b1[i], 2e-6) << i;
    }
}

TEST(Csv, IsRecognisedByItsHeader) {
    EXPECT_TRUE(kCsv.recognises("# x\n\nFrequency (Hz);Density\n"));
    EXPECT_TRUE(kCsv.recognises("freq,density\n")) << "a mistyped name is to be told";
    EXPECT_FALSE(kCsv.recognises("the density, frequency and more\n"));
    EXPECT_FALSE(kCsv.recognises("density\n"));
    EXPECT_FALSE(kCsv.recognises("x,y\n"));
    EXPECT_FALSE(kCsv.recognises(std::string("\xFF\xFE", 2) + std::string("x\0,\0", 4)));
}

TEST(Csv, AHeaderWhoseQuoteIsOpenIsRefused) {
    const Refusal refusal = refusal_of([] {
        read_format(kCsv, {"# note\nfrequency,density,\"time\n1,1\n", "s.csv", nullptr});
    });
    EXPECT_TRUE(refusal.says("s.csv:2: ", "quote"));
}

}  // namespace
}  // namespace ocean::test
