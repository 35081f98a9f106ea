// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows of untrusted CSV text: the common part of the readers of spectra and of points.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/line_reader.hpp"

namespace ocean::csv {

/// Steps to the next line that is neither blank nor a comment; false at the end.
bool next_row(LineReader& lines);
/// Returns the fields of a line, at most one more than `limit`, without blanks and quotes around
/// them; nothing if a quote is not closed. The separator ' ' stands for a run of blanks and tabs.
std::optional<std::vector<std::string_view>> split(std::string_view line, char separator,
                                                   std::size_t limit);
/// Returns the fields of the reader's line. Throws Error bad_file if a quote is not closed.
std::vector<std::string_view> fields_of(const LineReader& lines, char separator, std::size_t limit);

/// Returns `bytes` as UTF-8 with LF line ends if they are UTF-16 (with a byte order mark, or
/// recognised by the NUL in their first character) or have CR line ends; nothing if they need no
/// conversion. A half of a surrogate pair becomes U+FFFD.
std::optional<std::string> converted(std::string_view bytes);

/// The two parts of a column title such as "Density [m2/Hz]"; brackets may be () too.
struct Title {
    std::string name;  // in lower case
    std::string unit;  // empty = no unit; "()" = empty brackets
};
Title parse_title(std::string_view cell);

/// Reads a table with a header line, whichever program wrote it. It recognises
/// - the encoding: UTF-8, UTF-16; LF, CRLF or CR;
/// - the separator: comma, semicolon, tab or a run of blanks, by the header line and, where that
///   has several of them, by the first row; or as Excel's line "sep=;" before the header says;
/// - the decimal comma, by the numbers;
/// - a column of row names whose title is missing, as R and pandas write it: its title is "".
/// Blank lines and lines that begin with '#' are skipped. Views are valid until the next row.
class TableReader {
  public:
    static constexpr std::size_t kMaxColumns = 10'000;

    /// Reads the header line; titles() is empty without one. `content` and `name` must outlive the
    /// reader. Throws Error bad_file "NAME:LINE: ..." if a quote is not closed, if two separators
    /// suit header and first row alike, or if there are more than kMaxColumns columns.
    TableReader(std::string_view content, std::string_view name);
    TableReader(const TableReader&) = delete;
    TableReader& operator=(const TableReader&) = delete;

    const std::vector<std::string_view>& titles() const { return titles_; }
    char separator() const { return separator_; }
    /// Steps to the next row, which has a cell for each title; false at the end of the table.
    /// Throws Error bad_file for more or fewer cells and for an open quote, and at the end if every
    /// comma within a number may separate decimals or thousands.
    bool next();
    /// Returns a cell without blanks and quotes around it; within quotes a quote appears twice.
    std::string_view cell(std::size_t column) const { return cells_[column]; }
    /// Returns the number that all of the cell spells, finite or not, with a decimal point or
    /// comma; nothing if it spells none. Throws Error bad_file if the cell has both, or a mark that
    /// differs from an earlier number's.
    std::optional<double> number(std::size_t column);
    /// Returns the reader at the row that next() read, or at the header line; for messages.
    const LineReader& lines() const { return lines_; }

  private:
    bool has_row_names(std::string_view header, std::string_view row) const;
    std::optional<double> comma_number(std::string_view word, std::size_t comma);
    void check_marks(std::string_view word) const;
    void check_commas() const;
    Error width_error() const;

    std::string storage_;  // the converted text
    std::string_view name_;
    LineReader lines_;
    std::vector<std::string_view> titles_;
    std::vector<std::string_view> cells_;
    char separator_ = ',';
    std::size_t point_line_ = 0;  // of the first number with a decimal point
    std::size_t comma_line_ = 0;  // of the first number with a comma
    std::string first_comma_;     // that number
    bool only_thousands_ = true;  // true while every comma may separate thousands
};

/// Returns the titles of a table, in its order; empty if the table has no header line that can be
/// split. Recognisers of formats use it, because it does not throw where TableReader does.
std::vector<std::string> titles_of(std::string_view content);

}  // namespace ocean::csv
