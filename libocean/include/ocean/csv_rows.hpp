// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows of a CSV that nobody has checked: what readers of spectra and of points begin with.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "ocean/line_reader.hpp"

namespace ocean::csv {

/// Without blanks around it.
std::string_view trimmed(std::string_view text);

/// The next line that is neither blank nor a comment.
bool next_row(LineReader& lines);
/// The fields of a line, at most one more than `limit`, without blanks and quotes around them;
/// nothing if a quote is not closed.
std::optional<std::vector<std::string_view>> split(std::string_view line, char separator,
                                                   std::size_t limit);
/// Those of the reader's line. Throws Error bad_file if a quote is not closed.
std::vector<std::string_view> fields_of(const LineReader& lines, char separator, std::size_t limit);

}  // namespace ocean::csv
