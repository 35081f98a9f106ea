// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Times of records: see utc_time.hpp.
#include "ocean/internal/utc_time.hpp"

#include <algorithm>
#include <chrono>

namespace ocean {
namespace {

std::chrono::year_month_day calendar(const UtcTime& time) {
    return std::chrono::year_month_day(std::chrono::year(time.year),
                                       std::chrono::month(static_cast<unsigned>(time.month)),
                                       std::chrono::day(static_cast<unsigned>(time.day)));
}

void append_padded(std::string& out, int value, std::size_t width) {
    const std::string digits = std::to_string(value);
    if (digits.size() < width) out.append(width - digits.size(), '0');
    out += digits;
}

/// Removes `width` digits from the front and returns their number; -1 if they are missing.
int next_digits(std::string_view& text, std::size_t width) {
    if (text.size() < width) return -1;
    int value = 0;
    for (char c : text.substr(0, width)) {
        if (c < '0' || c > '9') return -1;
        value = 10 * value + (c - '0');
    }
    text.remove_prefix(width);
    return value;
}

bool accept(std::string_view& text, std::string_view any_of) {
    if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
    text.remove_prefix(1);
    return true;
}

/// Skips one or more digits; returns false if there are none.
bool skip_fraction(std::string_view& text) {
    const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
    text.remove_prefix(count);
    return count > 0;
}

/// Removes "Z", " UTC", " GMT", or an offset from UTC: "+01:00", "-0530", "+01". Returns the offset
/// in minutes, 0 without any of these; nothing for an offset beyond a day.
std::optional<int> next_zone(std::string_view& text) {
    for (const std::string_view name : {"Z", " UTC", "UTC", " GMT", "GMT"}) {
        if (text != name) continue;
        text = {};
        return 0;
    }
    std::string_view rest = text;
    accept(rest, " ");
    const bool west = rest.starts_with('-');
    if (!accept(rest, "+-")) return 0;
    const int hours = next_digits(rest, 2);
    const bool colon = accept(rest, ":");
    const int minutes = rest.empty() && !colon ? 0 : next_digits(rest, 2);
    if (hours < 0 || hours > 23 || minutes < 0 || minutes > 59) return std::nullopt;
    text = rest;
    return (west ? -1 : 1) * (60 * hours + minutes);
}

}  // namespace

bool UtcTime::valid() const {
    return year >= 1800 && year <= 2999 && month >= 1 && month <= 12 && day >= 1 && day <= 31 &&
           calendar(*this).ok() && hour >= 0 && hour <= 23 && minute >= 0 && minute <= 59;
}

std::string UtcTime::text() const {
    std::string out;
    append_padded(out, year, 4);
    append_padded(out += '-', month, 2);
    append_padded(out += '-', day, 2);
    append_padded(out += 'T', hour, 2);
    append_padded(out += ':', minute, 2);
    return out;
}

std::int64_t UtcTime::minutes() const {
    const auto days = std::chrono::sys_days(calendar(*this)).time_since_epoch();
    return std::int64_t{days.count()} * 1440 + hour * 60 + minute;
}

std::optional<UtcTime> utc_time_at(std::int64_t minutes) {
    constexpr std::int64_t kFarthest = 1'000'000'000;  // the year 3871
    if (minutes < -kFarthest || minutes > kFarthest) return std::nullopt;
    const std::chrono::minutes since(minutes);
    const auto day = std::chrono::floor<std::chrono::days>(since);
    const std::chrono::year_month_day date{std::chrono::sys_days(day)};
    const int of_day = static_cast<int>((since - day).count());
    const UtcTime time{static_cast<int>(date.year()), static_cast<int>(unsigned{date.month()}),
                       static_cast<int>(unsigned{date.day()}), of_day / 60, of_day % 60};
    return time.valid() ? std::optional(time) : std::nullopt;
}

std::optional<UtcTime> parse_utc_time(std::string_view text) {
    UtcTime time;
    time.year = next_digits(text, 4);
    if (!accept(text, "-")) return std::nullopt;
    time.month = next_digits(text, 2);
    if (!accept(text, "-")) return std::nullopt;
    time.day = next_digits(text, 2);
    if (!accept(text, "T ")) return std::nullopt;
    time.hour = next_digits(text, 2);
    if (!accept(text, ":")) return std::nullopt;
    time.minute = next_digits(text, 2);
    if (accept(text, ":")) {
        if (next_digits(text, 2) < 0) return std::nullopt;
        if (accept(text, ".,") && !skip_fraction(text)) return std::nullopt;
    }
    const std::optional<int> zone = next_zone(text);
    if (!zone || !text.empty() || !time.valid()) return std::nullopt;
    return *zone == 0 ? time : utc_time_at(time.minutes() - *zone);
}

}  // namespace ocean
