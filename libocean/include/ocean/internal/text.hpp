// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Small text functions that every layer needs: formatting, splitting, numbers to and from text
// without regard to the locale.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ocean {

/// Returns the text of printf, with a decimal point in any locale.
[[gnu::format(printf, 1, 2)]] std::string format_text(const char* format, ...);
/// Returns the shortest decimal form that reads back to the same bits: "0.1", "1e+22", "inf".
std::string shortest_text(double value);
std::string shortest_text(float value);
/// Returns the shortest digits that read back to the same bits, with an exponent only below 1e-5
/// and from 1e15 on: "300000", not "3e+05".
std::string plain_text(double value);
/// Returns the text of "%.*f", in any locale.
std::string fixed_text(double value, int digits);
/// Returns the text of "%.*g", in any locale.
std::string significant_text(double value, int digits);

/// Returns the parts between the separators, empty parts included.
std::vector<std::string> split(std::string_view text, std::string_view separator);
inline std::vector<std::string> split(std::string_view text, char separator) {
    return split(text, std::string_view(&separator, 1));
}
/// Returns the texts of the elements of `range` with `separator` between them; `text_of` returns
/// the text of one element, or is a pointer to its member.
template <typename Range, typename TextOf = std::identity>
std::string joined(const Range& range, std::string_view separator, const TextOf& text_of = {}) {
    std::string text;
    for (const auto& element : range) {
        if (!text.empty()) text += separator;
        text += std::invoke(text_of, element);
    }
    return text;
}
/// Returns the text with a .. z for A .. Z.
std::string lower_case(std::string_view text);
/// Returns the length in bytes of the well-formed UTF-8 character at the start of `text`; 0 if
/// there is none.
std::size_t utf8_character(std::string_view text);

/// Returns the finite number within [lowest, highest] that all of `text` spells. Throws Error
/// invalid_value with `what`, the text and the range.
double parse_number(std::string_view text, const std::string& what, double lowest, double highest);
/// Returns the whole number within [lowest, highest] that all of `text` spells. Throws Error
/// invalid_value with `what`, the text and the range.
int parse_whole_number(std::string_view text, const std::string& what, int lowest, int highest);

}  // namespace ocean
