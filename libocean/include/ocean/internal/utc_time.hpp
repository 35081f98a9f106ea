// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Times of records: UTC, to the minute, as ISO 8601 text. Spectrum formats write them; the choice
// of a record compares them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ocean {

struct UtcTime {
    int year = 0;
    int month = 0;
    int day = 0;
    int hour = 0;
    int minute = 0;

    /// Returns true for a date of the calendar and a time of the day, years 1800 .. 2999.
    bool valid() const;
    /// Returns "2020-06-08T03:50".
    std::string text() const;
    /// Returns the minutes since 1970. Requires valid().
    std::int64_t minutes() const;
};

/// Parses "2020-06-08T03:50", with or without seconds and their fractions (both dropped); a blank
/// may replace the T. Z, UTC, GMT or nothing after it means UTC; the offset of another zone,
/// "+01:00", "-0530" or "+01", is converted. Returns nothing for other text.
std::optional<UtcTime> parse_utc_time(std::string_view text);
/// Returns the inverse of UtcTime::minutes(); nothing outside the years of valid().
std::optional<UtcTime> utc_time_at(std::int64_t minutes);

}  // namespace ocean
