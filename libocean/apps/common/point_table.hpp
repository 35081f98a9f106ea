// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Points of the world in a table with a header line, the input of `ocean query` and `ocean gauge`.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ocean::csv {
class TableReader;
}

namespace ocean::app {

/// A column that a table may have.
struct PointColumn {
    enum class Kind { needed, optional, text };  // text is optional as well

    std::string name;
    Kind kind = Kind::needed;
    std::string unit{};  // that a title may name; empty = no unit
};

/// The limit of coordinates [m] and other numbers of a table, of either sign.
inline constexpr double kMaxPointNumber = 1e9;
inline constexpr std::size_t kMaxPoints = 10'000'000;
inline constexpr std::size_t kMaxPointTextBytes = 80;

/// The rows of a table, column by column. Numbers are finite and within kMaxPointNumber; a text is
/// one line of UTF-8.
class PointTable {
  public:
    std::size_t size() const { return rows_; }
    bool has(std::string_view column) const { return find(column) != nullptr; }
    /// Return size() values, or none if the table does not have the column.
    std::span<const double> numbers(std::string_view column) const;
    std::span<const std::string> texts(std::string_view column) const;
    /// Returns a line with the names of the unknown columns, which were ignored; empty if there are
    /// none. A column of row names without a title is ignored silently.
    const std::string& left_out() const { return left_out_; }

  private:
    friend PointTable parse_points(std::string_view text, const std::string& name,
                                   std::span<const PointColumn> known);

    struct Column {
        PointColumn known;
        std::size_t place;  // index in the file's rows
        std::vector<double> numbers;
        std::vector<std::string> texts;
    };
    const Column* find(std::string_view column) const;
    void find_columns(const csv::TableReader& reader, std::span<const PointColumn> known);

    std::vector<Column> columns_;  // in the file's order
    std::string left_out_;
    std::size_t rows_ = 0;
};

/// Reads a table in any dialect of csv::TableReader. Titles are not case-sensitive and may have a
/// unit in () or []. Ignores unknown columns, but refuses one whose name resembles a known name.
/// `name` is for messages. Throws Error bad_file "NAME:LINE: ...".
PointTable parse_points(std::string_view text, const std::string& name,
                        std::span<const PointColumn> known);

/// Reads the table in a file of at most 1 GiB; "-" = standard input. Throws Error bad_file.
PointTable read_points(const std::string& path, std::span<const PointColumn> known);

}  // namespace ocean::app
