// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The header line of a CSV: see csv_header.hpp.
#include "csv_header.hpp"

#include <algorithm>
#include <span>

#include "ocean/checked_text.hpp"
#include "ocean/csv_rows.hpp"
#include "ocean/grid.hpp"
#include "ocean/nearest_name.hpp"

namespace ocean::csv {
namespace {

constexpr double kDegrees = 180.0 / kPi;  // of a radian

struct Unit {
    std::string_view name;
    double factor;  // to the record's
};
constexpr std::array kNoUnit = {Unit{"", 1.0}};
constexpr std::array kTime = {Unit{"UTC", 1.0}};
constexpr std::array kMetres = {Unit{"m", 1.0}};
constexpr std::array kAngle = {Unit{"deg", 1.0}, Unit{"degrees", 1.0}, Unit{"rad", kDegrees}};
constexpr std::array kFrequency = {Unit{"Hz", 1.0}, Unit{"rad/s", 0.5 / kPi}};
constexpr std::array kDensity = {Unit{"m2/Hz", 1.0}, Unit{"m2 s", 1.0},
                                 Unit{"m2 s/rad", 2.0 * kPi}};
constexpr std::array kDirectionalDensity = {Unit{"m2/Hz/deg", 1.0}, Unit{"m2/Hz/rad", 1 / kDegrees},
                                            Unit{"m2 s/rad", 1 / kDegrees}};

constexpr std::string_view kNames[] = {"frequency",
                                       "density",
                                       "direction",
                                       "direction_to",
                                       "direction_cartesian",
                                       "mean_direction",
                                       "mean_direction_to",
                                       "mean_direction_cartesian",
                                       "spread",
                                       "a1",
                                       "b1",
                                       "a2",
                                       "b2",
                                       "time",
                                       "station",
                                       "latitude",
                                       "longitude",
                                       "depth"};
static_assert(std::size(kNames) == kColumns);

std::span<const Unit> units_of(Column column, bool directional) {
    if (column == frequency) return kFrequency;
    if (column == density && directional) return kDirectionalDensity;
    if (column == density) return kDensity;
    if (column == depth) return kMetres;
    if (column == time) return kTime;
    const bool bare = column == station || (column >= a1 && column <= b2);
    return bare ? std::span<const Unit>(kNoUnit) : kAngle;
}

char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// A unit without what does not matter in it.
std::string reduced(std::string_view unit) {
    std::string out;
    for (const char c : unit) {
        if (c == ' ' || c == '*' || c == '^' || c == '\xC2') continue;
        out += c == '\xB2' ? '2' : lower_case(c);  // the square of UTF-8 and of latin-1
    }
    return out;
}

Column column_named(std::string_view name) {
    return static_cast<Column>(std::find(std::begin(kNames), std::end(kNames), name) - kNames);
}

std::string unknown_column(std::string_view name) {
    const std::string_view nearest = nearest_name(name, kNames);
    std::string message = "unknown column '" + text::printable(name, 40) + "'";
    if (!nearest.empty()) return message + "; did you mean " + std::string(nearest) + "?";
    message += "; known:";
    for (const std::string_view known : kNames) message += " " + std::string(known);
    return message;
}

}  // namespace

std::string_view name_of(Column column) {
    return kNames[column];
}

Column column_of(std::string_view title) {
    return column_named(parse_title(title).name);
}

std::optional<char> separator_of(std::string_view line) {
    for (const char c : {'\t', ';', ','}) {
        if (line.find(c) != std::string_view::npos) return c;
    }
    return std::nullopt;
}

Header::Header(const LineReader& lines) : separator_(separator_of(lines.line()).value_or(',')) {
    place_.fill(kNone);
    std::array<std::string, kColumns> units;
    for (const std::string_view field : fields_of(lines, separator_, kColumns)) {
        const Title title = parse_title(field);
        const Column column = column_named(title.name);
        if (column == kNone) throw lines.fail(unknown_column(title.name));
        if (has(column)) throw lines.fail("the column " + title.name + " is there twice");
        place_[column] = width_++;
        units[column] = title.unit;
    }
    check_columns(lines);
    for (std::size_t i = 0; i < kColumns; ++i) {
        const auto column = static_cast<Column>(i);
        if (has(column)) factor_[column] = factor_of(lines, column, units);
    }
}

Column Header::any_of(Column first) const {
    for (const std::size_t i : {0u, 1u, 2u}) {
        const auto column = static_cast<Column>(first + i);
        if (has(column)) return column;
    }
    return kNone;
}

void Header::check_columns(const LineReader& lines) const {
    const auto need = [&](bool condition, std::string_view message) {
        if (!condition) throw lines.fail(message);
    };
    const auto count = [&](Column first, std::size_t number) {
        const auto from = place_.begin() + first;
        return number - static_cast<std::size_t>(
                            std::count(from, from + static_cast<std::ptrdiff_t>(number), kNone));
    };
    need(has(frequency), "the column frequency is missing");
    need(has(density), "the column density is missing");
    need(count(direction, 3) <= 1,
         "more than one of direction, direction_to and direction_cartesian");
    need(count(mean_direction, 3) <= 1,
         "more than one of mean_direction, mean_direction_to and mean_direction_cartesian");
    need(count(mean_direction, 3) == count(spread, 1),
         "a mean direction and spread need each other");
    need(count(a1, 4) % 4 == 0, "a1, b1, a2 and b2 need each other");
    need((count(direction, 3) > 0) + (count(spread, 1) > 0) + (count(a1, 4) > 0) <= 1,
         "directions, their mean and their moments exclude each other");
    need(has(latitude) == has(longitude), "latitude and longitude need each other");
}

double Header::factor_of(const LineReader& lines, Column column,
                         const std::array<std::string, kColumns>& units) const {
    const std::span<const Unit> known = units_of(column, any_of(direction) != kNone);
    const std::string& unit = units[column];
    std::string allowed;
    for (const Unit& one : known) {
        if (reduced(one.name) == reduced(unit)) return one.factor;
        allowed += (allowed.empty() ? "" : ", ") + std::string(one.name);
    }
    if (!unit.empty()) {
        throw lines.fail("the unit '" + text::printable(unit, 30) + "' of " +
                         std::string(kNames[column]) +
                         " is unknown; allowed: " + (allowed.empty() ? "none" : allowed));
    }
    if (column == density && reduced(units[frequency]) == kFrequency[1].name) {
        throw lines.fail("over rad/s the density needs a unit, like density (m2/Hz)");
    }
    return known.front().factor;
}

}  // namespace ocean::csv
