// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Text for people and for JSON, and the strict reading of numbers that options share. The lowest
// layer of the `ocean` command.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ocean::app {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format_text(const char* format, ...);
/// A JSON string with its quotes.
std::string json_string(std::string_view text);
/// A JSON array of strings.
std::string json_list(const std::vector<std::string>& texts);

/// "12.4 MiB".
std::string bytes_text(std::uint64_t bytes);
/// "4.2 s", "1:38", "2:03:10".
std::string duration_text(double seconds);
/// Lines of at most `width` characters, each after `indent` spaces and with a final newline.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width);
std::vector<std::string> split(std::string_view text, char separator);

/// A finite number within [lowest, highest], the whole of `text`. Throws Error invalid_value with
/// `what`, the text and the range.
double parse_number(std::string_view text, const std::string& what, double lowest, double highest);

}  // namespace ocean::app
