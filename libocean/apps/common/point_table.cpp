// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of points that nobody has checked; see point_table.hpp.
#include "point_table.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "ocean/checked_text.hpp"
#include "ocean/csv_rows.hpp"
#include "ocean/line_reader.hpp"
#include "standard_input.hpp"

namespace ocean::app {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;
constexpr std::size_t kShownBytes = 30;  // of a cell in a message

using Kind = PointColumn::Kind;

std::string quoted(std::string_view cell) {
    return "'" + text::printable(cell, kShownBytes) + "'";
}

std::string names_of(std::span<const PointColumn> columns) {
    std::string names;
    for (const PointColumn& column : columns) names += (names.empty() ? "" : ", ") + column.name;
    return names;
}

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    });
}

/// The header line is the reader's.
std::vector<PointColumn> read_header(const LineReader& lines, char separator,
                                     std::span<const PointColumn> known) {
    std::vector<PointColumn> columns;
    for (const std::string_view cell : csv::fields_of(lines, separator, known.size())) {
        const auto named = [&](const PointColumn& column) { return same_word(column.name, cell); };
        const auto found = std::find_if(known.begin(), known.end(), named);
        if (found == known.end()) {
            throw lines.fail("the header line names an unknown column " + quoted(cell) +
                             "; known: " + names_of(known));
        }
        if (std::any_of(columns.begin(), columns.end(), named)) {
            throw lines.fail("the column " + found->name + " is there twice");
        }
        columns.push_back(*found);
    }
    for (const PointColumn& column : known) {
        const auto same = [&](const PointColumn& other) { return other.name == column.name; };
        if (column.kind == Kind::needed && std::none_of(columns.begin(), columns.end(), same)) {
            throw lines.fail("the header line lacks the column " + column.name);
        }
    }
    return columns;
}

double number_of(const LineReader& lines, const PointColumn& column, std::string_view cell) {
    if (cell.empty()) throw lines.fail(column.name + " is missing");
    const std::optional<double> number = text::parse_number(cell);
    // The comparison is written so that NaN fails it.
    if (!number || !(std::abs(*number) <= kMaxPointNumber)) {
        throw lines.fail(column.name + " = " + quoted(cell) + "; allowed is a number, -1e9 .. 1e9");
    }
    return *number;
}

std::string text_of(const LineReader& lines, const PointColumn& column, std::string_view cell) {
    if (cell.size() <= kMaxPointTextBytes && text::printable(cell, cell.size() + 1) == cell) {
        std::string content(cell);
        for (std::size_t at = 0; (at = content.find("\"\"", at)) < content.size(); ++at) {
            content.erase(at, 1);  // a quote within quotes stands twice
        }
        return content;
    }
    throw lines.fail(column.name + " = " + quoted(cell) +
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

PointTable parse_points(std::string_view text, const std::string& name,
                        std::span<const PointColumn> known) {
    LineReader lines(text, name);
    PointTable table;
    if (!csv::next_row(lines)) {
        throw lines.fail("there is no header line; known columns: " + names_of(known));
    }
    const char separator = lines.line().find(';') != std::string_view::npos ? ';' : ',';
    for (PointColumn& column : read_header(lines, separator, known)) {
        table.columns_.push_back({std::move(column), {}, {}});
    }
    const std::size_t width = table.columns_.size();
    while (csv::next_row(lines)) {
        const std::vector<std::string_view> cells = csv::fields_of(lines, separator, width);
        if (cells.size() != width) {
            throw lines.fail((cells.size() > width ? "more" : "fewer") +
                             std::string(" cells than the ") + std::to_string(width) +
                             " columns of the header line");
        }
        if (++table.rows_ > kMaxPoints) throw lines.fail("more than the 10000000 points allowed");
        for (std::size_t i = 0; i < width; ++i) {
            PointTable::Column& column = table.columns_[i];
            if (column.known.kind == Kind::text) {
                column.texts.push_back(text_of(lines, column.known, cells[i]));
            } else {
                column.numbers.push_back(number_of(lines, column.known, cells[i]));
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
