// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Units of spectra and times: see cf_units.hpp.
#include "cf_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "names.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::netcdf {
namespace {

using namespace std::string_view_literals;

bool take(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

/// Reads up to `max_digits` digits. Returns nothing without a digit.
std::optional<int> take_number(std::string_view& text, std::size_t max_digits) {
    std::size_t digits = 0;
    int value = 0;
    while (digits < std::min(max_digits, text.size()) && text[digits] >= '0' &&
           text[digits] <= '9') {
        value = 10 * value + (text[digits++] - '0');
    }
    text.remove_prefix(digits);
    return digits == 0 ? std::nullopt : std::optional(value);
}

void skip_blanks(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
}

std::optional<double> seconds_of(std::string_view unit) {
    constexpr std::array kUnits = {
        std::pair{"d"sv, 86400.0},
        std::pair{"day"sv, 86400.0},
        std::pair{"days"sv, 86400.0},
        std::pair{"h"sv, 3600.0},
        std::pair{"hr"sv, 3600.0},
        std::pair{"hrs"sv, 3600.0},
        std::pair{"hour"sv, 3600.0},
        std::pair{"hours"sv, 3600.0},
        std::pair{"min"sv, 60.0},
        std::pair{"mins"sv, 60.0},
        std::pair{"minute"sv, 60.0},
        std::pair{"minutes"sv, 60.0},
        std::pair{"s"sv, 1.0},
        std::pair{"sec"sv, 1.0},
        std::pair{"secs"sv, 1.0},
        std::pair{"second"sv, 1.0},
        std::pair{"seconds"sv, 1.0},
        std::pair{"milliseconds"sv, 1e-3},
        std::pair{"microseconds"sv, 1e-6},
        std::pair{"nanoseconds"sv, 1e-9},
    };
    const auto found = std::find_if(kUnits.begin(), kUnits.end(),
                                    [&](const auto& known) { return known.first == unit; });
    return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

/// Parses "12", "12:30" or "12:30:15.5". Returns the seconds and writes the rest into `time`.
std::optional<double> take_clock(std::string_view& text, UtcTime& time) {
    const std::optional<int> hour = take_number(text, 2);
    if (!hour) return std::nullopt;
    time.hour = *hour;
    if (!take(text, ":")) return 0.0;
    const std::optional<int> minute = take_number(text, 2);
    if (!minute) return std::nullopt;
    time.minute = *minute;
    if (!take(text, ":")) return 0.0;
    const std::size_t length = std::min(text.find_first_not_of("0123456789."), text.size());
    const std::optional<double> seconds = text::parse_number(text.substr(0, length));
    text.remove_prefix(length);
    if (!seconds || !(*seconds >= 0.0 && *seconds < 60.0)) return std::nullopt;
    return seconds;
}

bool is_utc(std::string_view zone) {
    constexpr std::array kNames = {""sv,      "z"sv,     "utc"sv,   "gmt"sv, "+00:00"sv, "-00:00"sv,
                                   "+0:00"sv, "-0:00"sv, "0:00"sv,  "+00"sv, "+0"sv,     "-0"sv,
                                   "+0000"sv, "-0000"sv, "00:00"sv, "0"sv};
    return std::find(kNames.begin(), kNames.end(), zone) != kNames.end();
}

}  // namespace

DensityUnits parse_density_units(std::string_view units, DensityOver over) {
    std::string plain = lower_case(units);
    std::erase(plain, ' ');
    DensityUnits result;
    std::string_view rest = plain;
    result.log10 = take(rest, "log10(");
    if (!result.log10) {
        auto [factor, fault] = parse_density_unit(units, over);
        return {factor, false, std::move(fault)};
    }
    const std::size_t begin = units.find('(') + 1;
    const std::size_t offset = units.rfind('+');
    if (!rest.ends_with("+1e-12)") || offset < begin) {
        result.fault = "units '" + text::printable(units) +
                       "': a logarithm is known as log10(UNIT +1E-12) alone";
        return result;
    }
    auto [factor, fault] = parse_density_unit(units.substr(begin, offset - begin), over);
    return {factor, true, std::move(fault)};
}

std::optional<TimeUnits> parse_time_units(std::string_view units) {
    const std::string plain = lower_case(units);
    std::string_view rest = plain;
    skip_blanks(rest);
    const std::string_view unit = rest.substr(0, rest.find(' '));
    rest.remove_prefix(unit.size());
    skip_blanks(rest);
    const std::optional<double> seconds = seconds_of(unit);
    if (!seconds || !take(rest, "since ")) return std::nullopt;
    skip_blanks(rest);
    UtcTime time;
    const std::optional<int> year = take_number(rest, 4);
    if (!year || !take(rest, "-")) return std::nullopt;
    const std::optional<int> month = take_number(rest, 2);
    if (!month || !take(rest, "-")) return std::nullopt;
    const std::optional<int> day = take_number(rest, 2);
    if (!day) return std::nullopt;
    time.year = *year;
    time.month = *month;
    time.day = *day;
    if (!take(rest, "t")) skip_blanks(rest);
    double second = 0.0;
    if (!rest.empty() && rest.front() >= '0' && rest.front() <= '9') {
        const std::optional<double> clock = take_clock(rest, time);
        if (!clock) return std::nullopt;
        second = *clock;
    }
    skip_blanks(rest);
    while (rest.ends_with(' ')) rest.remove_suffix(1);
    if (!is_utc(rest) || !time.valid()) return std::nullopt;
    return TimeUnits{*seconds, 60.0 * static_cast<double>(time.minutes()) + second};
}

std::optional<UtcTime> time_at(const TimeUnits& units, double value) {
    constexpr double kMaxSeconds = 1e11;  // the year 5138
    const double seconds = units.origin + value * units.seconds;
    if (!(std::abs(seconds) < kMaxSeconds)) return std::nullopt;
    return utc_time_at(std::llround(seconds / 60.0));
}

}  // namespace ocean::netcdf
