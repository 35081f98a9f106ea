// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The header line of a CSV: see csv_header.hpp.
#include "csv_header.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "free_form.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/density_units.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::csv {
namespace {

constexpr double kDegrees = 180.0 / kPi;  // in a radian

struct Unit {
    std::string_view name;
    double factor;  // to the record's
};
constexpr std::array kNoUnit = {Unit{"", 1.0}};
constexpr std::array kTime = {Unit{"UTC", 1.0}};
constexpr std::array kMetres = {Unit{"m", 1.0}};
constexpr std::array kAngle = {Unit{"deg", 1.0}, Unit{"degrees", 1.0}, Unit{"rad", kDegrees}};
constexpr std::array kFrequency = {Unit{"Hz", 1.0}, Unit{"rad/s", 0.5 / kPi}};

constexpr auto& kNames = kEnumWords<Column>;

/// Other names of columns, in lower case, with _ for blanks.
constexpr std::pair<std::string_view, Column> kAliases[] = {
    {"freq", frequency},
    {"f", frequency},
    {"efth", density},
    {"psd", density},
    {"spectral_density", density},
    {"variance_density", density},
    {"dir", direction},
    {"lat", latitude},
    {"lon", longitude},
    {"datetime", time},
    {"date", time},
    {"timestamp", time},
    {"site", station},
    {"dpt", depth},
};

std::span<const Unit> units_of(Column column) {
    if (column == frequency) return kFrequency;
    if (column == depth) return kMetres;
    if (column == time) return kTime;
    const bool bare = column == station || (column >= a1 && column <= b2);
    return bare ? std::span<const Unit>(kNoUnit) : kAngle;
}

/// Returns a unit without the characters that do not matter in it.
std::string reduced(std::string_view unit) {
    std::string out;
    for (const char c : lower_case(unit)) {
        if (c == ' ' || c == '*' || c == '^' || c == '\xC2') continue;
        out += c == '\xB2' ? '2' : c;  // the square of UTF-8 and of latin-1
    }
    return out;
}

Column column_named(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    const auto alias = std::find_if(std::begin(kAliases), std::end(kAliases),
                                    [&](const auto& one) { return one.first == name; });
    if (alias != std::end(kAliases)) return alias->second;
    return enumerator_of<Column>(name).value_or(kNone);
}

double factor_of(const LineReader& lines, Column column, std::string_view unit) {
    std::string allowed;
    for (const Unit& one : units_of(column)) {
        if (reduced(one.name) == reduced(unit)) return one.factor;
        allowed += (allowed.empty() ? "" : ", ") + std::string(one.name);
    }
    if (unit.empty()) return units_of(column).front().factor;
    throw lines.fail("the unit '" + text::printable(unit, 30) + "' of " +
                     std::string(kNames[column]) +
                     " is unknown; allowed: " + (allowed.empty() ? "none" : allowed));
}

}  // namespace

std::string_view name_of(Column column) {
    return kNames[column];
}

Column column_of(std::string_view title) {
    return column_named(parse_title(title).name);
}

bool is_row_index(std::string_view title) {
    const std::string name = parse_title(title).name;
    return name.empty() || name == "index" || name.starts_with("unnamed:");
}

bool is_passed_over(std::string_view title) {
    constexpr std::string_view kOthers[] = {"wspd", "wdir"};  // wavespectra's wind
    const std::string name = parse_title(title).name;
    return is_row_index(title) ||
           std::find(std::begin(kOthers), std::end(kOthers), name) != std::end(kOthers);
}

std::string_view mistyped_column(std::string_view title) {
    return nearest_name(parse_title(title).name, kNames);
}

std::string unknown_column(std::string_view name) {
    std::string message = "unknown column '" + text::printable(name, 40) + "'";
    const std::string meant = did_you_mean(name, kNames);
    if (!meant.empty()) return message + meant;
    message += "; known:";
    for (const std::string_view known : kNames) message += " " + std::string(known);
    return message;
}

double density_factor(const LineReader& lines, std::string_view unit, bool directional) {
    if (unit.empty()) return 1.0;
    const DensityUnit read = parse_density_unit(
        unit, directional ? DensityOver::frequency_and_direction : DensityOver::frequency);
    if (!read.fault.empty()) throw lines.fail("density: " + read.fault);
    return read.factor;
}

double frequency_factor(const LineReader& lines, std::string_view unit) {
    return factor_of(lines, frequency, unit);
}

bool is_missing(std::string_view cell) {
    constexpr std::string_view kWords[] = {"", "-", "NA", "N/A", "#N/A", "null", "None", "NaT"};
    return std::find(std::begin(kWords), std::end(kWords), cell) != std::end(kWords);
}

std::optional<std::string> time_text(std::string_view cell) {
    if (const auto read = parse_utc_time(cell)) return read->text();
    if (cell.size() == 10) {  // pandas omits a time of midnight
        const auto read = parse_utc_time(std::string(cell) + "T00:00");
        if (read) return read->text();
    }
    for (const std::string_view pattern :
         {"YYYY/MM/DD hh:mm:ss", "YYYY/MM/DD hh:mm", "DD.MM.YYYY hh:mm:ss", "DD.MM.YYYY hh:mm",
          "DD.MM.YYYY", "YYYY/MM/DD"}) {
        if (cell.size() != pattern.size()) continue;
        const auto read = match_time(cell, pattern);
        if (read && read->valid()) return read->text();
    }
    return std::nullopt;
}

Header::Header(const TableReader& table) {
    place_.fill(kNone);
    const LineReader& lines = table.lines();
    std::array<std::string, kColumns> units;
    for (std::size_t i = 0; i < table.titles().size(); ++i) {
        if (is_passed_over(table.titles()[i])) continue;
        const Title title = parse_title(table.titles()[i]);
        const Column column = column_named(title.name);
        if (column == kNone) throw lines.fail(unknown_column(title.name));
        if (has(column)) {
            throw lines.fail("the column " + text::printable(title.name) + " appears twice");
        }
        place_[column] = i;
        units[column] = title.unit;
    }
    check_columns(lines);
    for (std::size_t i = 0; i < kColumns; ++i) {
        const auto column = static_cast<Column>(i);
        if (!has(column)) continue;
        const bool directional = any_of(direction) != kNone;
        factor_[column] = column == density ? density_factor(lines, units[column], directional)
                                            : factor_of(lines, column, units[column]);
    }
    const bool radians = has(frequency) && factor_[frequency] != 1.0;
    if (radians && units[density].empty()) {
        throw lines.fail("over rad/s the density needs a unit, like density (m2/Hz)");
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

}  // namespace ocean::csv
