// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Points of the world as users hand them over: a table with a header line. What `ocean query` and
// `ocean gauge` read.
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
    enum class Kind { needed, optional, text };  // text is optional too

    std::string name;
    Kind kind = Kind::needed;
    std::string unit{};  // that a title may name; empty = it has none
};

/// Largest coordinate, m, or other number of a table, either sign.
inline constexpr double kMaxPointNumber = 1e9;
inline constexpr std::size_t kMaxPoints = 10'000'000;
inline constexpr std::size_t kMaxPointTextBytes = 80;

/// The rows of a table, column by column. Numbers are finite and within kMaxPointNumber; texts are
/// one line of UTF-8.
class PointTable {
  public:
    std::size_t size() const { return rows_; }
    bool has(std::string_view column) const { return find(column) != nullptr; }
    /// size() values; none where the table does not have the column.
    std::span<const double> numbers(std::string_view column) const;
    std::span<const std::string> texts(std::string_view column) const;
    /// One line that names the columns of the file that are not known and were left out; empty
    /// where there are none. Row names without a title are not worth a word.
    const std::string& left_out() const { return left_out_; }

  private:
    friend PointTable parse_points(std::string_view text, const std::string& name,
                                   std::span<const PointColumn> known);

    struct Column {
        PointColumn known;
        std::size_t place;  // in the file's rows
        std::vector<double> numbers;
        std::vector<std::string> texts;
    };
    const Column* find(std::string_view column) const;
    void take_columns(const csv::TableReader& reader, std::span<const PointColumn> known);

    std::vector<Column> columns_;  // in the file's order
    std::string left_out_;
    std::size_t rows_ = 0;
};

/// Reads a table in any dialect of csv::TableReader. A title is a name in any case, and may name
/// the unit in () or []. A column that is not known is left out, but for a mistyped name. `name` is
/// for messages. Throws Error bad_file "NAME:LINE: ...".
PointTable parse_points(std::string_view text, const std::string& name,
                        std::span<const PointColumn> known);

/// The same from a file of at most 1 GiB; "-" = standard input.
PointTable read_points(const std::string& path, std::span<const PointColumn> known);

}  // namespace ocean::app
