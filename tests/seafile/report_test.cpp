// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Files of kinds that people reported, see tests/data/reports/README.md: the height, peak period
// and direction that each was made with, the number of readable records, and the warnings.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "helpers.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean::test {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

struct Report {
    const char* file;
    RecordChoice choice;
    double hs;           // m
    double tp;           // s
    double coming_from;  // degrees clockwise from north; NaN: without directions
    std::size_t readable;
    std::size_t faults;
    const char* warning;  // words of one of records_warnings; empty: none is needed
};
const Report kReports[] = {
    {"swan_negative.spec", {}, 2.5, 10.60, 25.0, 1, 0, "25 of 576 densities are below 0"},
    {"swan_reals.spc2d", {}, 1.5, 8.76, 160.0, 1, 0, ""},
    {"swan_asterisks.spec", {"", "48.3,-3.5"}, 3.0, 10.60, 290.0, 2, 1, "swan_asterisks.spec:106:"},
    {"swan_action.hot", {}, 2.0, 10.60, 250.0, 1, 0, ""},
    {"swan_iterations.s2d", {}, 1.8, 9.64, 310.0, 1, 0, "3 iterations of one state: the last"},
    {"41999.data_spec", {"2024-03-01T04:00", ""}, 1.8, 9.64, kNowhere, 4, 1, "41999.data_spec:4:"},
    {"hour_12.data_spec", {"", "41998"}, 1.7, 9.64, kNowhere, 3, 0, ""},
    {"41999_5day.spectral", {"2024-03-01T12:00", "41999"}, 1.5, 9.64, 100.0, 2, 0, ""},
    {"41999w2024.txt", {"", "41999"}, 2.1, 10.60, kNowhere, 1, 0, ""},
    {"welch_zero_hertz.csv", {}, 1.9, 9.64, kNowhere, 1, 0, ""},
    {"pandas_index.csv", {}, 2.0, 9.64, kNowhere, 1, 0, ""},
    {"pandas_time_zone.csv", {"2024-03-01T12:00", ""}, 1.6, 8.76, kNowhere, 1, 0, ""},
    {"decimal_comma.csv", {}, 2.4, 11.66, kNowhere, 1, 0, ""},
    {"blanks.csv", {}, 1.2, 7.24, kNowhere, 1, 0, ""},
    {"utf16.csv", {}, 1.4, 7.97, kNowhere, 1, 0, ""},
    {"per_radian_second.csv", {}, 3.0, 12.83, kNowhere, 1, 0, ""},
};

TEST(Reports, HaveTheHeightPeriodAndDirectionTheyWereMadeWith) {
    for (const Report& report : kReports) {
        SCOPED_TRACE(report.file);
        const std::string path = kData + "/reports/" + report.file;
        const std::vector<SpectrumRecord> records = read_spectra(path);
        const auto faults = static_cast<std::size_t>(
            std::count_if(records.begin(), records.end(),
                          [](const SpectrumRecord& record) { return !record.fault.empty(); }));
        EXPECT_EQ(faults, report.faults);
        EXPECT_EQ(records.size() - faults, report.readable);
        const RecordSummary summary = summarize(choose_record(records, report.choice, path));
        EXPECT_NEAR(4.0 * std::sqrt(summary.m0), report.hs, 0.01 * report.hs);
        EXPECT_NEAR(summary.peak_period, report.tp, 0.02 * report.tp);
        EXPECT_EQ(std::isnan(report.coming_from), std::isnan(summary.mean_direction));
        if (!std::isnan(report.coming_from)) {
            EXPECT_NEAR(coming_from(summary.mean_direction / kDegree), report.coming_from, 0.5);
        }
        std::string said;
        for (const std::string& warning : records_warnings(records)) said += warning + "\n";
        EXPECT_NE(said.find(report.warning), std::string::npos) << said;
    }
}

TEST(Reports, TheRecordThatCannotBeReadSaysWhyAndNamesAnother) {
    const std::string swan = kData + "/reports/swan_asterisks.spec";
    const Refusal place = refusal_of([&] {
        choose_record(read_spectra(swan), {"", "48.3,-4.0"}, swan);
    });
    EXPECT_EQ(place.kind, ErrorKind::bad_file);
    EXPECT_TRUE(place.says("swan_asterisks.spec:106: '0******' is not a density")) << place.message;
    const std::string ndbc = kData + "/reports/41999.data_spec";
    const Refusal time = refusal_of([&] {
        choose_record(read_spectra(ndbc), {"2024-03-01T02:00", ""}, ndbc);
    });
    EXPECT_TRUE(time.says("41999.data_spec:4: ") &&
                time.says("a record that can be read is that of 2024-03-01T00:00"))
        << time.message;
}

}  // namespace
}  // namespace ocean::test
