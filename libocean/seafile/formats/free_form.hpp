// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Text of wave models in Fortran's free form: numbers over as many lines as they need. Shared by
// the readers of WAVEWATCH III and SWAN, between lines and records.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fortran_number.hpp"
#include "line_checks.hpp"
#include "ocean/internal/utc_time.hpp"

namespace ocean {

/// A format that marks whole lines as comments also has comments after the values of its header.
/// References must outlive the reader.
class FreeForm {
  public:
    FreeForm(std::string_view content, std::string_view name, char comment_mark = '\0')
        : lines_(content, name), comment_mark_(comment_mark) {}

    /// Leaves the line for the next one with more than a comment; false at the end of the file.
    bool next_line() {
        repeats_ = 0;
        if (held_) {
            held_ = false;
            rest_ = lines_.line();
            skip_blanks();
            begun_ = false;
            return true;
        }
        do {
            rest_ = {};
            if (!lines_.next_filled()) return false;
            rest_ = lines_.line();
            skip_blanks();
            begun_ = false;
        } while (comment_mark_ != '\0' && rest_.starts_with(comment_mark_));
        return true;
    }
    /// Makes the next call of next_line() return this line again.
    void hold_line() { held_ = true; }
    const LineReader& lines() const { return lines_; }
    std::size_t line_number() const { return lines_.number(); }
    /// Recovers from a fault in the item that begins in line `first`: searches the lines after it
    /// for one that `begins` a new item, which next_line() then returns.
    template <typename Begins>
    void resume_after(std::size_t first, const Begins& begins) {
        const std::string_view line = lines_.line();
        rest_ = line;
        if (lines_.number() > first && begins(rest())) return hold_line();
        while (next_line()) {
            if (begins(rest_)) return hold_line();
        }
    }
    void need_line(std::string_view what) {
        if (!next_line()) throw fail("the file ends where " + std::string(what) + " should be");
    }
    /// Returns the rest of the line that has not been read, without blanks before it.
    std::string_view rest() {
        skip_blanks();
        return rest_;
    }
    std::string_view word() {
        begun_ = true;
        return next_word(rest_);
    }
    void skip(std::size_t bytes) { rest_.remove_prefix(bytes); }
    void leave_line() { rest_ = {}; }
    void end_line(std::string_view what) {
        if (repeats_ > 0) throw fail("more numbers than " + std::string(what));
        if (!rest().empty()) {
            throw fail("'" + shown(rest()) + "' after " + std::string(what) +
                       ", where the line should end");
        }
    }

    /// Reads the next number, of this line or a later one. `what` names it: "a density".
    double number(std::string_view what) {
        if (repeats_ > 0) {
            --repeats_;
            return repeated_;
        }
        while (rest().empty()) need_line(what);
        const std::string_view before = rest_;
        std::optional<double> value = text::next_fortran_number(rest_);
        if (!value) value = next_repeated();
        if (!value) throw no_number(what);
        number_ = before.substr(0, before.size() - rest_.size());
        begun_ = true;
        return *value;
    }
    /// Reads the next number of this line.
    double number_here(std::string_view what) {
        if (rest().empty()) throw fail("the line ends where " + std::string(what) + " should be");
        return number(what);
    }
    /// Reads the next number of a header, of this line or a later one.
    double header_number(std::string_view what) {
        const bool comment = comment_mark_ != '\0' && begun_ && !begins_number(rest());
        if (comment) leave_line();
        return number(what);
    }
    /// Reads a count of `what`: "frequencies".
    std::size_t count(std::string_view what, std::size_t least, std::size_t most) {
        const double value = header_number("the number of " + std::string(what));
        const bool within =
            value >= static_cast<double>(least) && value <= static_cast<double>(most);
        if (!within || value != std::floor(value)) {
            throw fail(last_number() + " " + std::string(what) +
                       "; allowed: " + std::to_string(least) + " .. " + std::to_string(most));
        }
        return static_cast<std::size_t>(value);
    }
    /// Returns the last number as the file spells it.
    std::string last_number() const { return shown(number_); }
    void require_within(double value, double low, double high, std::string_view what,
                        std::string_view allowed) const {
        if (value >= low && value <= high) return;
        throw fail(std::string(what) + " of " + last_number() +
                   "; allowed: " + std::string(allowed));
    }

    Error fail(std::string_view message) const { return lines_.fail(message); }
    static std::string shown(std::string_view text) {
        return text::printable(text.substr(0, text.find_first_of(" \t")), 20);
    }

  private:
    void skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
    }
    /// Reads "36*0.0", as list-directed output writes 36 equal numbers, and returns the first of
    /// them.
    std::optional<double> next_repeated() {
        const std::size_t star = rest_.substr(0, 8).find('*');
        if (star == std::string_view::npos) return std::nullopt;
        const std::optional<double> count = text::parse_number(rest_.substr(0, star));
        if (!count || !(*count >= 1.0 && *count <= 1e6) || *count != std::floor(*count)) {
            return std::nullopt;
        }
        std::string_view after = rest_.substr(star + 1);
        const std::optional<double> value = text::next_fortran_number(after);
        if (!value) return std::nullopt;
        rest_ = after;
        repeats_ = static_cast<std::size_t>(*count) - 1;
        repeated_ = *value;
        return value;
    }
    static bool begins_number(std::string_view text) {
        return text.find_first_of("0123456789+-.") == 0;
    }
    Error no_number(std::string_view what) const {
        const bool overflow = rest_.starts_with('*');
        return fail("'" + shown(rest_) + "' is not " + std::string(what) +
                    (overflow ? ": the number was too wide for its column" : ""));
    }

    LineReader lines_;
    char comment_mark_;
    std::string_view rest_;
    std::string_view number_;
    bool begun_ = false;  // something of the line is taken
    bool held_ = false;   // the line is to be given again
    std::size_t repeats_ = 0;
    double repeated_ = 0.0;  // the value of the next `repeats_` numbers
};

/// Reads frequencies [Hz], ascending.
inline std::vector<double> read_frequencies(FreeForm& in, std::size_t count) {
    std::vector<double> frequency;
    while (frequency.size() < count) {
        const double f = in.header_number("a frequency");
        in.require_within(f, 0.0, kMaxFrequency, "a frequency", kFrequencyRange);
        append_frequency(in.lines(), f, frequency);
    }
    return frequency;
}

/// Returns the time that `text` begins with, by a pattern with Y M D h m s for digits and b for the
/// three letters of a month; other characters match themselves. Not checked for validity; a year of
/// two digits stays one.
inline std::optional<UtcTime> match_time(std::string_view text, std::string_view pattern) {
    constexpr std::string_view kMonths = "janfebmaraprmayjunjulaugsepoctnovdec";
    if (text.size() < pattern.size()) return std::nullopt;
    UtcTime time;
    int second = 0;
    std::string month;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const std::size_t field = std::string_view("YMDhms").find(pattern[i]);
        if (field != std::string_view::npos) {
            if (text[i] < '0' || text[i] > '9') return std::nullopt;
            int* fields[] = {&time.year, &time.month, &time.day, &time.hour, &time.minute, &second};
            *fields[field] = 10 * *fields[field] + (text[i] - '0');
        } else if (pattern[i] == 'b') {
            month += static_cast<char>(text[i] | 0x20);
        } else if (text[i] != pattern[i]) {
            return std::nullopt;
        }
    }
    if (!month.empty()) {
        const std::size_t place = kMonths.find(month);
        if (place == std::string_view::npos || place % 3 != 0) return std::nullopt;
        time.month = static_cast<int>(place / 3) + 1;
    }
    if (second > 59) return std::nullopt;
    return time;
}

}  // namespace ocean
