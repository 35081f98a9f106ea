// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The CSV reader against its grammar: columns, units, conventions, grids in any order, several
// records in a file, and broken files.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <tuple>

#include "helpers.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<SpectrumRecord> read_csv(const std::string& text) {
    return read_spectra_from({text, "s.csv", nullptr});
}
SpectrumRecord first(const std::string& text) {
    return read_csv(text).front();
}

/// A grid of two frequencies and four directions, `title` naming the directions.
std::string grid(const std::string& title, const std::string& density = "density",
                 double turn = 360.0) {
    std::string text = "frequency," + title + "," + density + "\n";
    for (const int f : {1, 2}) {
        for (const int d : {0, 1, 2, 3}) {
            text += "0." + std::to_string(f) + "," + std::to_string(0.25 * d * turn) + "," +
                    std::to_string(f * (d + 1)) + "\n";
        }
    }
    return text;
}

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

TEST(Csv, ColumnsInAnyOrderSeparatorCaseAndQuotes) {
    const SpectrumRecord plain = first("frequency,density,station\n0.1,1.5,A\n0.2,2.5,A\n");
    EXPECT_EQ(plain.frequency, (std::vector<double>{0.1, 0.2}));
    EXPECT_EQ(plain.density, (std::vector<double>{1.5, 2.5}));
    EXPECT_EQ(plain.station, "A");
    for (const char* text :
         {"# a note\n\nDENSITY;Station;Frequency [Hz]\n1.5;A;0.1\n\n2.5;A;0.2\n",
          "\xEF\xBB\xBF"
          "density\tstation\tfrequency\r\n1.5\tA\t0.1\r\n2.5\tA\t0.2",
          "\"density\",\"station\",\"frequency (Hz)\"\n1.5,\"A\",0.1\n# end\n \"2.5\" , A , 0.2\n",
          "frequency,density,station\n0.2,2.5,A\n0.1,1.5,A\n"}) {
        EXPECT_TRUE(same_record(first(text), plain)) << text;
    }
    EXPECT_EQ(first("station,frequency,density\n\"a \"\"b\"\", c\",1,1\n\"a \"\"b\"\", c\",2,2\n")
                  .station,
              "a \"b\", c");
}

TEST(Csv, EnergyIsTheSameInEveryUnitOverFrequency) {
    const double s = 3.0;  // m^2/Hz
    const auto read_unit = [&](const std::string& frequency, const std::string& density,
                               double to_file, double f_to_file) {
        std::string text = "frequency" + frequency + ",density" + density + "\n";
        for (const double f : {0.1, 0.2}) {
            char row[128];
            std::snprintf(row, sizeof row, "%.17g,%.17g\n", f * f_to_file, s * to_file);
            text += row;
        }
        return first(text);
    };
    for (const char* unit :
         {"", " (m2/Hz)", " [m^2/Hz]", " (m\xC2\xB2 s)", " (m**2 s)", "(m2*s)", " (m\xB2/Hz)"}) {
        EXPECT_NEAR(read_unit("", unit, 1.0, 1.0).density[1], s, 1e-12) << unit;
    }
    const SpectrumRecord angular = read_unit(" (rad/s)", " (m2 s/rad)", 0.5 / kPi, 2.0 * kPi);
    EXPECT_NEAR(angular.frequency[0], 0.1, 1e-15);
    EXPECT_NEAR(angular.density[0], s, 1e-12);
    EXPECT_NEAR(read_unit(" (rad/s)", " (m2/Hz)", 1.0, 2.0 * kPi).density[0], s, 1e-12);
}

TEST(Csv, EnergyIsTheSameInEveryUnitOverBoth) {
    const SpectrumRecord plain = first(grid("direction"));
    EXPECT_NEAR(plain.density[0], 90.0 * (1 + 2 + 3 + 4), 1e-9);
    for (const char* unit : {"density (m2/Hz/rad)", "density (m2 s/rad)"}) {
        EXPECT_NEAR(first(grid("direction", unit)).density[0], plain.density[0] * kPi / 180.0,
                    1e-9);
    }
    const SpectrumRecord radians = first(grid("direction (rad)", "density", 2.0 * kPi));
    EXPECT_EQ(radians.direction.size(), 4u);
    EXPECT_NEAR(radians.density[0], plain.density[0], 1e-3) << "six digits of pi";
}

TEST(Csv, TheThreeDirectionColumnsMeanWhatTheySay) {
    // The value 2 is at 90.
    for (const auto& [title, travel] :
         {std::pair{"direction", 180.0}, {"direction_to", 0.0}, {"direction_cartesian", 90.0}}) {
        const SpectrumRecord record = first(grid(title));
        ASSERT_EQ(record.direction.size(), 4u);
        const auto j = static_cast<std::size_t>(travel / 90.0);
        EXPECT_EQ(record.directional_density[j], 2.0) << title;
        EXPECT_EQ(record.directional_density[4 + j], 4.0) << title;
    }
}

TEST(Csv, TheThreeMeanDirectionColumnsMeanWhatTheySay) {
    for (const auto& [title, x, y] : {std::tuple{"mean_direction", -1.0, 0.0},
                                      {"mean_direction_to", 1.0, 0.0},
                                      {"mean_direction_cartesian", 0.0, 1.0}}) {
        const std::string head = std::string("frequency,density,") + title;
        const SpectrumRecord record = first(head + ",spread\n.1,1,90,0\n.2,1,,20\n.3,1,nan,5\n");
        EXPECT_NEAR(record.a1[0], x, 1e-12) << title;
        EXPECT_NEAR(record.b1[0], y, 1e-12) << title;
        EXPECT_TRUE(std::isnan(record.a1[1]) && std::isnan(record.b2[2])) << title;
        const SpectrumRecord rad =
            first(head + " (rad),spread (rad)\n.1,1,1.5707963267948966,0\n.2,1,0,0\n");
        EXPECT_NEAR(rad.a1[0], x, 1e-12) << title;
    }
}

TEST(Csv, MomentsAreTakenAsTheyAre) {
    const SpectrumRecord record =
        first("frequency,density,a1,b1,a2,b2\n.2,1,.5,-.5,.25,-.25\n.1,2,.1,.2,.3,\n");
    EXPECT_EQ(record.a1[1], 0.5);
    EXPECT_EQ(record.b1[1], -0.5);
    EXPECT_EQ(record.a2[1], 0.25);
    EXPECT_EQ(record.b2[1], -0.25);
    EXPECT_TRUE(std::isnan(record.a1[0])) << "one of four is missing, all are";
    EXPECT_FALSE(first("frequency,density,a1,b1,a2,b2\n1,1,,,,\n2,2,,,,\n").has_moments());
}

TEST(Csv, RowsOfAGridMayStandInAnyOrder) {
    const std::string text = grid("direction");
    std::vector<std::string> rows;
    for (std::size_t at = text.find('\n') + 1; at < text.size(); at = text.find('\n', at) + 1) {
        rows.push_back(text.substr(at, text.find('\n', at) + 1 - at));
    }
    std::string shuffled = text.substr(0, text.find('\n') + 1);
    for (std::size_t i = 0; i < rows.size(); ++i) shuffled += rows[(3 * i + 5) % rows.size()];
    const SpectrumRecord a = first(text);
    const SpectrumRecord b = first(shuffled);
    EXPECT_TRUE(same_record(a, b));
    EXPECT_EQ(a.directional_density, b.directional_density);
}

TEST(Csv, AMissingDensityIsZeroInAGridAndNoBinWithout) {
    const SpectrumRecord over_f = first("frequency,density\n.1,\n.2,1\n.3,nan\n.4,2\n");
    EXPECT_EQ(over_f.frequency, (std::vector<double>{0.2, 0.4}));
    std::string text = grid("direction_cartesian");
    text.replace(text.find(",2\n"), 3, ",\n");
    EXPECT_EQ(first(text).directional_density[1], 0.0);
}

TEST(Csv, RowsAreGroupedByTimeStationAndPlace) {
    const std::vector<SpectrumRecord> records = read_csv(
        "time,station,latitude,longitude,depth,frequency,density\n"
        "2020-06-08T03:50Z,B,10,20,50,.1,1\n"
        "2020-06-08T03:50Z,A,10,20,,.1,2\n"
        "2020-06-08 03:50:00,B,10.0,20,50,.2,3\n"
        "2020-06-08T03:50,A,10,20,,.2,4\n"
        "2020-06-09,A,10,20,,.1,5\n"
        "2020-06-09,A,10,20,,.2,6\n"
        "2020-06-09,A,11,20,,.2,8\n"
        "2020-06-09,A,11,20,,.1,7\n"
        "2020-06-10,A,11,20,,.1,\n"
        "2020-06-10,A,11,20,,.2,nan\n");
    ASSERT_EQ(records.size(), 4u) << "one time without any density";
    EXPECT_EQ(records[0].station, "B");
    EXPECT_EQ(records[0].time, "2020-06-08T03:50");
    EXPECT_EQ(records[0].density, (std::vector<double>{1, 3}));
    EXPECT_EQ(records[0].depth, 50.0);
    EXPECT_EQ(records[1].density, (std::vector<double>{2, 4}));
    EXPECT_TRUE(std::isnan(records[1].depth));
    EXPECT_EQ(records[2].time, "2020-06-09T00:00");
    EXPECT_EQ(records[3].latitude, 11.0);
    EXPECT_EQ(records[3].density, (std::vector<double>{7, 8}));
}

TEST(Csv, IsRecognisedByItsHeader) {
    EXPECT_TRUE(kCsv.recognises("# x\n\nFrequency (Hz);Density\n"));
    EXPECT_TRUE(kCsv.recognises("freq,density\n")) << "a mistyped name is to be told";
    EXPECT_FALSE(kCsv.recognises("the density, frequency and more\n"));
    EXPECT_FALSE(kCsv.recognises("density\n"));
    EXPECT_FALSE(kCsv.recognises("x,y\n"));
    EXPECT_FALSE(kCsv.recognises(std::string("\xFF\xFE", 2) + std::string("x\0,\0", 4)));
}

TEST(Csv, BrokenHeadersAreRefused) {
    const std::pair<std::string, std::string> broken[] = {
        {"frequency,densty", "unknown column 'densty'; did you mean density?"},
        {"frequency,density,zzzzzzzzzzzzzzzzzzz", "known: frequency density"},
        {"frequency,station", "density is missing"},
        {"density,station", "frequency is missing"},
        {"frequency,density,density", "appears twice"},
        {"frequency (Hz),density (bar/Hz)", "density: units 'bar/Hz'"},
        {"frequency,density (m2/Hz/deg)", "is not a unit of a density over frequency, like m2/Hz"},
        {"frequency,direction,density (m2/Hz)", "over frequency and direction, like m2/Hz/deg"},
        {"frequency (kHz),density", "'kHz' of frequency"},
        {"frequency (rad/s),density", "over rad/s the density needs a unit"},
        {"frequency,density,direction,direction_to", "more than one of direction,"},
        {"frequency,density,mean_direction", "need each other"},
        {"frequency,density,spread", "need each other"},
        {"frequency,density,a1,b1,a2", "a1, b1, a2 and b2"},
        {"frequency,density,direction,a1,b1,a2,b2", "exclude each other"},
        {"frequency,density,latitude", "latitude and longitude"},
        {"frequency,density,\"time", "quote"},
    };
    for (const auto& [line, words] : broken) {
        const std::string text = "# note\n" + line + "\n1,1\n";
        const Refusal refusal = refusal_of([&] { read_format(kCsv, {text, "s.csv", nullptr}); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file) << line;
        EXPECT_TRUE(refusal.says("s.csv:2: ") && refusal.says(words)) << refusal.message;
    }
}

TEST(Csv, BrokenRowsAreRefusedWithTheirLine) {
    const std::string head = "time,station,latitude,longitude,depth,frequency,density\n";
    const std::string good = "2020-06-08T03:50,A,1,2,3,.1,1\n2020-06-08T03:50,A,1,2,3,.2,1\n";
    const std::pair<std::string, std::string> broken[] = {
        {"2020-06-08T03:50,A,1,2,3,.1,1\n", "frequency appears twice"},
        {"2020-06-08T03:50,A,1,2,3,.3,-1\n", "the density of bin 3 is not within 0 .. 1e6"},
        {"2020-06-08T03:50,A,1,2,3,.3,1e7\n", "the density '1e7' is not within 0 .. 1e+06"},
        {"2020-06-08T03:50,A,1,2,3,.2,inf\n", "'inf'"},
        {"2020-06-08T03:50,A,1,2,3,.2,x\n", "'x' is not a number"},
        {"2020-06-08T03:50,A,1,2,3,,1\n", "the frequency is missing"},
        {"2020-06-08T03:50,A,1,2,3,1e-9,1\n", "not within 1e-5 .. 100"},
        {"2020-06-08T03:50,A,1,2,3,101,1\n", "the frequency '101' is not within 0 .. 100"},
        {"2020-06-08T03:50,A,91,2,3,.2,1\n", "the latitude '91'"},
        {"2020-06-08T03:50,A,1,361,3,.2,1\n", "the longitude '361'"},
        {"2020-06-08T03:50,A,1,2,-3,.2,1\n", "the depth '-3'"},
        {"2020-06-08T03:50,A,1,2,4,.2,1\n", "the depth differs"},
        {"20201345,A,1,2,3,.2,1\n", "'20201345' is not UTC"},
        {"2020-06-08T03:50,A,1,2,3,.2,1,\n", "more cells than the 7 columns"},
        {"2020-06-08T03:50,A,1,2,3,.2\n", "fewer cells than the 7 columns"},
        {"2020-06-08T03:50,A,1,2", "the file ends within this line"},
        {"2020-06-08T03:50,\"A,1,2,3,.2,1\n", "quote"},
        {"2020-06-08T03:50,\"A\"x,1,2,3,.2,1\n", "quote"},
    };
    for (const auto& [line, words] : broken) {
        const Refusal refusal =
            first_fault_of([&, text = line] { return read_csv(head + good + text); });
        EXPECT_TRUE(refusal.says("s.csv:4: ") && refusal.says(words)) << line << refusal.message;
    }
}

TEST(Csv, ARecordOfOneFrequencyIsRefusedWithItsLine) {
    const Refusal refusal = refusal_of([] { read_csv("frequency,density\n.1,1\n"); });
    EXPECT_TRUE(refusal.says("s.csv:2: ") && refusal.says("at least 2 frequencies"))
        << refusal.message;
}

TEST(Csv, AGridWithAHoleADoubleOrTooFewDirectionsIsRefused) {
    const std::string text = grid("direction");
    const std::string without =
        text.substr(0, text.find("0.1,90.0")) + text.substr(text.find("0.1,180"));
    const Refusal hole = refusal_of([&] { read_csv(without); });
    EXPECT_TRUE(hole.says("s.csv:8: ") && hole.says("no row for 0.1 Hz and 90 degrees"))
        << hole.message;
    const Refusal twice = refusal_of([&] { read_csv(text + "0.1,90,1\n"); });
    EXPECT_TRUE(twice.says("s.csv:10: ") && twice.says("appear twice in one record"))
        << twice.message;
    const Refusal last = refusal_of([&] { read_csv(text + "0.2,270,1\n"); });
    EXPECT_TRUE(last.says("s.csv:10: ") && last.says("appear twice in one record")) << last.message;
    const Refusal few = refusal_of(
        [] { read_csv("frequency,direction,density\n.1,0,1\n.1,9,1\n.2,0,1\n.2,9,1\n"); });
    EXPECT_TRUE(few.says("s.csv:5: ") && few.says("at least 3 directions")) << few.message;
    const Refusal cut = refusal_of([&] { read_csv(text.substr(0, text.size() - 6)); });
    EXPECT_TRUE(cut.refused) << "the last row is cut";
}

TEST(Csv, ARecordThatCannotBeReadCostsNoOther) {
    const std::string head = "station,frequency,density\n";
    const std::vector<SpectrumRecord> records =
        read_csv(head + "A,.1,1\nA,.2,2\nB,.1,1\nB,.2,x\nB,.3,2\nC,.1,1\nC,.2,2\n");
    ASSERT_EQ(records.size(), 3u);
    EXPECT_EQ(records[1].fault, "s.csv:5: the density 'x' is not a number");
    EXPECT_EQ(records[1].station, "B");
    EXPECT_EQ(records[0].fault + records[2].fault, "");
    // A line that is no row may have been of the record before it or of the one after it.
    const std::vector<SpectrumRecord> garbage =
        read_csv(head + "A,.1,1\nA,.2,2\nB,.1,1\nB,.2,2\nxyz\nC,.1,1\nC,.2,2\nE,.1,1\nE,.2,2\n");
    ASSERT_EQ(garbage.size(), 4u);
    EXPECT_EQ(garbage[0].fault + garbage[3].fault, "");
    EXPECT_EQ(garbage[1].fault, "s.csv:6: fewer cells than the 3 columns of the header line");
    EXPECT_EQ(garbage[2].fault, garbage[1].fault);
    const std::vector<SpectrumRecord> growing = read_csv(head + "A,.1,1\nA,.2,2\nB,.1,1\nB,.2");
    ASSERT_EQ(growing.size(), 2u);
    EXPECT_EQ(growing[1].fault, "s.csv:5: the file ends within this line");
    EXPECT_EQ(refusal_of([&] { read_csv(head + "no row\n"); }).message,
              "s.csv:2: fewer cells than the 3 columns of the header line");
}

TEST(Csv, NamesOfWavespectraAndPandasAreKnown) {
    const std::vector<SpectrumRecord> records = read_csv(
        ",time,lat,lon,freq,dir,efth,wspd\n0,2024-03-01,1,2,.1,0,1,7\n1,2024-03-01,1,2,.1,120,2,7\n"
        "2,2024-03-01,1,2,.1,240,3,7\n3,2024-03-01,1,2,.2,0,1,7\n4,2024-03-01,1,2,.2,120,2,7\n"
        "5,2024-03-01,1,2,.2,240,NaN,7\n");
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].time, "2024-03-01T00:00");
    EXPECT_EQ(records[0].longitude, 2.0);
    EXPECT_NEAR(records[0].density[0], 6.0 * 120.0, 1e-9);
    EXPECT_EQ(read_csv("Unnamed: 0,index,f,PSD\n0,0,.1,1\n1,1,.2,2\n")[0].density[1], 2.0);
}

TEST(Csv, TimesOfSpreadsheetsAndOtherZonesAreConverted) {
    for (const auto& [cell, utc] : {std::pair{"2024-03-01T12:00+02:00", "2024-03-01T10:00"},
                                    {"01.03.2024 12:00", "2024-03-01T12:00"},
                                    {"01.03.2024 12:00:30", "2024-03-01T12:00"},
                                    {"2024/03/01 12:00", "2024-03-01T12:00"},
                                    {"01.03.2024", "2024-03-01T00:00"}}) {
        const std::string row = std::string(cell) + ",";
        EXPECT_EQ(read_csv("time,frequency,density\n" + row + ".1,1\n" + row + ".2,2\n")[0].time,
                  utc);
    }
    const std::string american = "3/1/2024 12:00,";
    EXPECT_TRUE(first_fault_of([&] {
                    return read_csv("time,frequency,density\n" + american + ".1,1\n" + american +
                                    ".2,2\n");
                }).says("'3/1/2024 12:00' is not UTC"));
}

TEST(CsvWide, AColumnIsARecordThatItsTitleNames) {
    const std::vector<SpectrumRecord> records = read_csv(
        "Frequency,\"JONSWAP (2m,8s)\",2024-03-01 12:00:00+01:00,S (cm2/Hz)\n"
        "0.1,1,2,30000\n0.2,3,,40000\n");
    ASSERT_EQ(records.size(), 3u);
    EXPECT_EQ(records[0].station, "JONSWAP (2m,8s)");
    EXPECT_EQ(records[0].density, (std::vector<double>{1, 3}));
    EXPECT_EQ(
        records[0].warnings,
        (std::vector<std::string>{"the column 'JONSWAP (2m,8s)' is taken as a density in m^2/Hz"}));
    EXPECT_EQ(records[1].time, "2024-03-01T11:00");
    EXPECT_EQ(records[1].density, (std::vector<double>{2, 0}));
    EXPECT_EQ(records[2].station, "S");
    EXPECT_DOUBLE_EQ(records[2].density[1], 4.0);
    EXPECT_TRUE(records[2].warnings.empty()) << "its unit is told";
    const SpectrumRecord symbol = read_csv("f (rad/s),S(w) [m2/(rad/s)]\n1,1\n2,2\n")[0];
    EXPECT_NEAR(symbol.density[0], 2.0 * std::numbers::pi, 1e-12);
    EXPECT_TRUE(symbol.warnings.empty());
}

TEST(CsvWide, AFirstColumnWithoutATitleIsTheFrequencyUnlessItNumbersTheRows) {
    const std::vector<SpectrumRecord> records = read_csv(",surge\n0.0,7\n0.05,1\n0.1,2\n");
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].frequency, (std::vector<double>{0.05, 0.1}));
    EXPECT_EQ(records[0].warnings.size(), 3u) << "the frequency, the density, the bin of 0 Hz";
    EXPECT_TRUE(refusal_of([] {
                    read_csv(",surge\n0,7\n1,1\n2,2\n");
                }).says("the first column numbers the rows, and none is named frequency"));
    EXPECT_TRUE(refusal_of([] {
                    read_csv("frequency (rad/s),surge\n.1,7\n.2,1\n");
                }).says("over rad/s the density needs a unit"));
}

TEST(CsvWide, ARowIsARecordWhoseFrequenciesAreTheTitles) {
    for (const char* title : {"", "time", "index"}) {
        const std::vector<SpectrumRecord> records =
            read_csv(std::string(title) +
                     ",0.1,0.2,0.4\n2024-03-01 12:00:00,1,2,3\n"
                     "2024-03-01 13:00:00,4,x,6\n2024-03-01 14:00:00,7,,9\n");
        ASSERT_EQ(records.size(), 3u) << title;
        EXPECT_EQ(records[0].time, "2024-03-01T12:00");
        EXPECT_EQ(records[0].frequency, (std::vector<double>{0.1, 0.2, 0.4}));
        EXPECT_EQ(records[0].density, (std::vector<double>{1, 2, 3}));
        EXPECT_EQ(records[0].warnings.size(), 1u);
        EXPECT_EQ(records[1].fault, "s.csv:3: 'x' is not a density");
        EXPECT_EQ(records[1].time, "2024-03-01T13:00");
        EXPECT_EQ(records[2].frequency, (std::vector<double>{0.1, 0.4}));
    }
    EXPECT_EQ(read_csv("station;0,1;0,2;0,4\nA;1,5;2,5;3\n")[0].density,
              (std::vector<double>{1.5, 2.5, 3.0}));
}

TEST(CsvWide, WhatIsNoDensityIsAnUnknownColumn) {
    EXPECT_TRUE(refusal_of([] {
                    read_csv("frequency,amplitude\n.1,1\n.2,2\n");
                }).says("unknown column 'amplitude'; known:"));
    EXPECT_TRUE(refusal_of([] {
                    read_csv("frequency,densty\n.1,1\n.2,2\n");
                }).says("did you mean density?"));
}

}  // namespace
}  // namespace ocean::test
