// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The header line of a CSV: its columns, their positions and their units. csv.cpp documents the
// allowed names.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "ocean/enum_words.hpp"
#include "ocean/internal/csv_rows.hpp"

namespace ocean::csv {

/// The columns by their names in a header line.
enum Column : std::size_t {
    frequency,
    density,
    direction,
    direction_to,
    direction_cartesian,
    mean_direction,
    mean_direction_to,
    mean_direction_cartesian,
    spread,
    a1,
    b1,
    a2,
    b2,
    time,
    station,
    latitude,
    longitude,
    depth,
};
inline constexpr std::size_t kColumns = enum_count<Column>();
inline constexpr auto kNone = static_cast<Column>(kColumns);
/// Returns the name of a column in a header line.
std::string_view name_of(Column column);
/// Returns the column of a title, also for the names of wavespectra, xarray and pandas; kNone for
/// an unknown name.
Column column_of(std::string_view title);
/// Returns true for a column of row numbers, as pandas writes it: it has no name, or one that says
/// so.
bool is_row_index(std::string_view title);
/// Returns true for a row index and for the columns that wavespectra writes beside a spectrum.
bool is_passed_over(std::string_view title);
/// Returns the column that a mistyped title probably means; else empty.
std::string_view mistyped_column(std::string_view title);
/// Returns the message "unknown column 'x'" with the name that was probably meant, or the known
/// names.
std::string unknown_column(std::string_view name);

/// Returns the factor of densities of a unit; `unit` is that of parse_title, empty for the record's
/// own. Throws Error bad_file for other units.
double density_factor(const LineReader& lines, std::string_view unit, bool directional);
/// Returns the factor of a frequency's unit to Hz. Throws Error bad_file for an unknown unit.
double frequency_factor(const LineReader& lines, std::string_view unit);

/// Returns true if a cell has no value.
bool is_missing(std::string_view cell);
/// Returns a record's UTC time of "2020-06-08T03:50" and its kind (see parse_utc_time), a date
/// alone, 2020/06/08 03:50 or 08.06.2020 03:50; nothing for other text.
std::optional<std::string> time_text(std::string_view cell);

/// The positions of the columns in a row, and the factors of their values.
class Header {
  public:
    /// Reads the titles of a table.
    explicit Header(const TableReader& table);

    std::size_t place(Column column) const { return place_[column]; }
    double factor(Column column) const { return factor_[column]; }
    bool has(Column column) const { return place_[column] != kNone; }
    /// Returns the one that is present of a column and the two after it, else kNone.
    Column any_of(Column first) const;

  private:
    void check_columns(const LineReader& lines) const;

    std::array<std::size_t, kColumns> place_{};
    std::array<double, kColumns> factor_{};
};

}  // namespace ocean::csv
