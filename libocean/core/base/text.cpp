// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Small pieces of text; see text.hpp.
#include "ocean/text.hpp"

#include <charconv>
#include <cstdarg>
#include <cstddef>
#include <cstdio>

#include "ocean/error.hpp"

namespace ocean {
namespace {

template <typename Number>
std::string shortest(Number value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

std::string format_text(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    va_list again;
    va_copy(again, arguments);
    const int length = std::vsnprintf(nullptr, 0, format, arguments);
    va_end(arguments);
    std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    return text;
}

std::string shortest_text(double value) {
    return shortest(value);
}

std::string shortest_text(float value) {
    return shortest(value);
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

double parse_number(std::string_view text, const std::string& what, double lowest, double highest) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    // The comparison is written so that NaN fails it.
    if (code != std::errc() || stop != end || !(value >= lowest && value <= highest)) {
        throw Error(ErrorKind::invalid_value,
                    what + " = " + std::string(text) +
                        format_text(": allowed is a number, %g .. %g", lowest, highest));
    }
    return value;
}

int parse_whole_number(std::string_view text, const std::string& what, int lowest, int highest) {
    const double value = parse_number(text, what, lowest, highest);
    const int whole = static_cast<int>(value);
    if (whole == value) return whole;
    throw Error(ErrorKind::invalid_value,
                what + " = " + std::string(text) + ": allowed is a whole number");
}

}  // namespace ocean
