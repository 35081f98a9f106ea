// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Text for people and for JSON. The lowest layer of the `ocean` command.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/text.hpp"

namespace ocean::app {

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

}  // namespace ocean::app
