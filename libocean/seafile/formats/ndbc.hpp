// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Common parts of the tables of the National Data Buoy Center, real-time and historical: dates,
// missing values, and the way from five tables of one station to records. The buoy's degrees become
// libocean's directions here, and only here.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "line_checks.hpp"
#include "ocean/enum_words.hpp"

namespace ocean::ndbc {

/// Two digits may round an r1 or r2 up to here.
inline constexpr double kMaxSpread = 1.05;

/// Before the header line of a table.
inline constexpr std::size_t kMaxMetadataLines = 1000;

/// The contents of the five tables: density, alpha1, alpha2, r1, r2.
enum class Quantity { density, direction1, direction2, spread1, spread2 };
inline constexpr std::size_t kCompanions = enum_count<Quantity>() - 1;  // all but the density

struct Bin {
    double frequency;
    double value;  // NaN = missing
};

struct Row {
    std::string time;
    std::vector<Bin> bins;  // ascending in frequency
    std::string station;    // in a table of several stations
    std::string fault;      // why the line cannot be used, "NAME:LINE: ..."
    std::string warning;
};

/// Rows of one companion by station and time, and all of a station.
using Companion = std::map<std::pair<std::string, std::string>, Row>;
using Companions = std::array<Companion, kCompanions>;

/// Returns a finite number. Throws Error bad_file stating that the word is not `what`.
double number(const LineReader& lines, std::string_view word, std::string_view what);
/// Takes year, month, day, hour and perhaps minute off the front of a line: "2020-06-08T03:50".
std::string next_time(const LineReader& lines, std::string_view& line, bool minutes);
/// Returns the frequency that follows those of `bins`: within the limits, ascending.
double next_frequency(const LineReader& lines, std::string_view word, const std::vector<Bin>& bins);
/// Returns a value of a table; `full` is how that table writes an r1 or r2 of 1. Nines mean
/// missing: 999 in every table, 99 too if it is not a possible value. (A direction may be 99
/// degrees; its bin is missing all the same if the spread beside it is.)
double value(const LineReader& lines, std::string_view word, Quantity quantity, double full);

/// Reads the rows of a table: `read_header` returns true for a header line, `read_row` reads
/// another one, beside the rows before it. Lines that begin with '#' are skipped.
template <typename ReadHeader, typename ReadRow>
std::vector<Row> read_rows(LineReader& lines, const ReadHeader& read_header,
                           const ReadRow& read_row) {
    std::vector<Row> rows;
    while (lines.next_filled()) {
        if (read_header(lines.line()) || lines.line().starts_with('#')) continue;
        require_room(lines, rows.size());
        Row row;
        catch_fault(row.fault, [&] { read_row(row, rows); });
        rows.push_back(std::move(row));
    }
    return rows;
}
/// Returns true if a header line begins the table, after lines of metadata with a '#'.
template <typename IsHeader>
bool begins_with_header(std::string_view content, const IsHeader& is_header) {
    LineReader lines(content, "");
    for (std::size_t i = 0; i < kMaxMetadataLines && lines.next_filled(); ++i) {
        if (is_header(lines.line())) return true;
        if (!lines.line().starts_with('#')) return false;
    }
    return false;
}

/// Returns the rows of a table whose time is known; of two with one time, the first. Throws Error
/// bad_file if no time is known.
Companion by_time(std::vector<Row> rows);
/// Returns the four companions; nothing if `read`, which reads the table of a quantity, returns
/// nothing for one of them.
std::optional<Companions> read_companions(
    const std::function<std::optional<std::vector<Row>>(Quantity)>& read);
/// Returns the station of a file's stem. NDBC's identifiers have five characters: "41010" of
/// "ndbc_41010" and "41010_5day", else the whole stem.
std::string station_of(std::string_view stem);
/// Returns a record for each row that has at least two densities, or a fault. `station`: for rows
/// that name none.
std::vector<SpectrumRecord> make_records(const std::string& station, const std::vector<Row>& rows,
                                         const std::optional<Companions>& companions);

}  // namespace ocean::ndbc
