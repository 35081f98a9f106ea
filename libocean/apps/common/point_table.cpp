// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See point_table.hpp. Tables come from users and are untrusted.
#include "point_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "standard_input.hpp"

namespace ocean::app {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;
constexpr std::size_t kShownBytes = 30;  // limit for a cell in a message

using Kind = PointColumn::Kind;

std::string shown(std::string_view cell) {
    return "'" + text::printable(cell, kShownBytes) + "'";
}

std::vector<std::string_view> names_of(std::span<const PointColumn> columns) {
    std::vector<std::string_view> names;
    for (const PointColumn& column : columns) names.push_back(column.name);
    return names;
}

bool same_unit(std::string_view unit, std::string_view written) {
    constexpr std::pair<std::string_view, std::string_view> kSpellings[] = {
        {"m", "m"},       {"m", "metre"}, {"m", "metres"},  {"m", "meter"},
        {"m", "meters"},  {"s", "s"},     {"s", "sec"},     {"s", "second"},
        {"s", "seconds"}, {"m/s", "m/s"}, {"m/s", "m s-1"}, {"m/s", "m s^-1"}};
    const std::pair wanted(unit, trimmed(written));
    return std::find(std::begin(kSpellings), std::end(kSpellings), wanted) != std::end(kSpellings);
}

void check_unit(const LineReader& lines, const PointColumn& column, const csv::Title& title) {
    if (title.unit.empty() || same_unit(column.unit, title.unit)) return;
    throw lines.fail("the unit " + shown(title.unit) + " of " + column.name +
                     " is unknown; allowed: " + (column.unit.empty() ? "none" : column.unit));
}

double number_of(csv::TableReader& table, const PointColumn& column, std::size_t place) {
    const std::string_view cell = table.cell(place);
    if (cell.empty()) throw table.lines().fail(column.name + " is missing");
    const std::optional<double> number = table.number(place);
    // The comparison is written so that NaN fails it.
    if (!number || !(std::abs(*number) <= kMaxPointNumber)) {
        throw table.lines().fail(column.name + " = " + shown(cell) +
                                 "; allowed is a number, -1e9 .. 1e9");
    }
    return *number;
}

std::string text_of(const LineReader& lines, const PointColumn& column, std::string_view cell) {
    if (cell.size() <= kMaxPointTextBytes && text::printable(cell, cell.size() + 1) == cell) {
        std::string content(cell);
        for (std::size_t at = 0; (at = content.find("\"\"", at)) < content.size(); ++at) {
            content.erase(at, 1);  // a quote within quotes is doubled
        }
        return content;
    }
    throw lines.fail(column.name + " = " + shown(cell) +
                     "; allowed are at most 80 bytes of UTF-8 without control characters");
}

}  // namespace

const PointTable::Column* PointTable::find(std::string_view column) const {
    for (const Column& candidate : columns_) {
        if (candidate.known.name == column) return &candidate;
    }
    return nullptr;
}

std::span<const double> PointTable::numbers(std::string_view column) const {
    const Column* found = find(column);
    if (found == nullptr) return {};
    return found->numbers;
}

std::span<const std::string> PointTable::texts(std::string_view column) const {
    const Column* found = find(column);
    if (found == nullptr) return {};
    return found->texts;
}

/// Finds the known columns of a header line.
void PointTable::find_columns(const csv::TableReader& reader, std::span<const PointColumn> known) {
    const LineReader& lines = reader.lines();
    const std::vector<std::string_view> names = names_of(known);
    std::vector<std::string> others;
    for (std::size_t place = 0; place < reader.titles().size(); ++place) {
        const csv::Title title = csv::parse_title(reader.titles()[place]);
        const auto found = std::find(names.begin(), names.end(), title.name);
        if (found == names.end()) {
            if (!reader.titles()[place].empty()) others.emplace_back(reader.titles()[place]);
            continue;
        }
        const PointColumn& column = known[static_cast<std::size_t>(found - names.begin())];
        if (has(column.name)) throw lines.fail("the column " + column.name + " is repeated");
        check_unit(lines, column, title);
        columns_.push_back({column, place, {}, {}});
    }
    const bool numbers = std::any_of(others.begin(), others.end(), [](const std::string& title) {
        return text::parse_number(title).has_value();
    });
    if (columns_.empty() && numbers) {
        throw lines.fail("the header line is missing, the first line has numbers; known columns: " +
                         joined(names, ", "));
    }
    for (const std::string& other : others) {
        const std::string title = csv::parse_title(other).name;
        const std::string_view meant = nearest_name(title, names);
        if (meant.empty() || has(meant)) continue;
        throw lines.fail("the header line names an unknown column " + shown(other) +
                         did_you_mean(title, names));
    }
    for (std::string& other : others) other = shown(other);
    for (const PointColumn& column : known) {
        if (column.kind != Kind::needed || has(column.name)) continue;
        throw lines.fail("the header line lacks the column " + column.name +
                         (others.empty() ? "" : "; it has " + joined(others, ", ")));
    }
    if (!others.empty()) left_out_ = "ignored unknown columns: " + joined(others, ", ");
}

PointTable parse_points(std::string_view text, const std::string& name,
                        std::span<const PointColumn> known) {
    csv::TableReader reader(text, name);
    PointTable table;
    if (reader.titles().empty()) {
        throw reader.lines().fail("the header line is missing; known columns: " +
                                  joined(names_of(known), ", "));
    }
    table.find_columns(reader, known);
    while (reader.next()) {
        if (++table.rows_ > kMaxPoints) {
            throw reader.lines().fail("more than the 10000000 points allowed");
        }
        for (PointTable::Column& column : table.columns_) {
            if (column.known.kind == Kind::text) {
                column.texts.push_back(
                    text_of(reader.lines(), column.known, reader.cell(column.place)));
            } else {
                column.numbers.push_back(number_of(reader, column.known, column.place));
            }
        }
    }
    return table;
}

PointTable read_points(const std::string& path, std::span<const PointColumn> known) {
    if (path == kStandardInput) {
        return parse_points(read_standard_input(kMaxFileBytes), "standard input", known);
    }
    return parse_points(text::read_file_or_pipe(path, kMaxFileBytes), path, known);
}

}  // namespace ocean::app
