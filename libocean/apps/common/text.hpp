// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Readable texts of numbers, and line breaking.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ocean/internal/text.hpp"

namespace ocean::app {

/// Return printf's %.Nf and %.Ng, for the number formats of Json.
template <int digits>
std::string decimals(double value) {
    return format_text("%.*f", digits, value);
}
template <int digits>
std::string significant(double value) {
    return format_text("%.*g", digits, value);
}

/// Returns "12.4 MiB".
std::string bytes_text(std::uint64_t bytes);
/// Returns "412.5 m" or "12.5 km", with four digits.
std::string length_text(double metres);
/// Returns "4.2 s", "1:38" or "2:03:10".
std::string duration_text(double seconds);
/// Returns the text, in quotes if a reader of CSV would otherwise see more than one cell.
std::string csv_cell(const std::string& text);
/// Returns the text in lines of at most `width` characters, each after `indent` spaces and with a
/// final newline.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width);

}  // namespace ocean::app
