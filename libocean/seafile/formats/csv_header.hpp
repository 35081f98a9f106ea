// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The header line of a CSV: which columns there are, where, in which units. What can stand there is
// documented in csv.cpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "ocean/line_reader.hpp"

namespace ocean::csv {

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
    kColumns,
    kNone = kColumns,
};
/// As a header line names it.
std::string_view name_of(Column column);
/// kNone for a name that is unknown.
Column column_of(std::string_view title);

/// Of a header line; nothing if it has one field.
std::optional<char> separator_of(std::string_view line);

/// Where in a row the columns are, and what their values are to be multiplied by.
class Header {
  public:
    /// From the current line.
    explicit Header(const LineReader& lines);

    char separator() const { return separator_; }
    std::size_t width() const { return width_; }
    std::size_t place(Column column) const { return place_[column]; }
    double factor(Column column) const { return factor_[column]; }
    bool has(Column column) const { return place_[column] != kNone; }
    /// The one there is of a column and the two after it, else kNone.
    Column any_of(Column first) const;

  private:
    void check_columns(const LineReader& lines) const;
    double factor_of(const LineReader& lines, Column column,
                     const std::array<std::string, kColumns>& units) const;

    char separator_;
    std::size_t width_ = 0;
    std::array<std::size_t, kColumns> place_{};
    std::array<double, kColumns> factor_{};
};

}  // namespace ocean::csv
