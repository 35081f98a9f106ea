// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Small pieces of text that every layer needs: formatted, cut apart, numbers both ways without
// regard to the locale.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ocean {

/// printf into a string: a host may have set a locale whose decimal point is a comma.
[[gnu::format(printf, 1, 2)]] std::string format_text(const char* format, ...);
/// The shortest decimal form that reads back to the same bits: "0.1", "1e+22", "inf".
std::string shortest_text(double value);
std::string shortest_text(float value);
/// As many digits, but an exponent only below 1e-5 and from 1e15 on: "300000", not "3e+05".
std::string plain_text(double value);
/// "%.*f".
std::string fixed_text(double value, int digits);

/// The parts between the separators, empty ones too: one more than there are separators.
std::vector<std::string> split(std::string_view text, std::string_view separator);
inline std::vector<std::string> split(std::string_view text, char separator) {
    return split(text, std::string_view(&separator, 1));
}
/// Bytes of the well-formed UTF-8 character that `text` begins with; 0 if there is none.
std::size_t utf8_character(std::string_view text);

/// A finite number within [lowest, highest], the whole of `text`. Throws Error invalid_value with
/// `what`, the text and the range.
double parse_number(std::string_view text, const std::string& what, double lowest, double highest);
/// The same for whole numbers.
int parse_whole_number(std::string_view text, const std::string& what, int lowest, int highest);

}  // namespace ocean
