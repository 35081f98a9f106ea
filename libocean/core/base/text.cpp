// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Small pieces of text; see text.hpp.
#include "ocean/internal/text.hpp"

#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>

#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean {
namespace {

template <typename Number, typename... Format>
std::string digits_of(Number value, Format... format) {
    char text[400];  // the largest number has 309 digits before its point
    return {text, std::to_chars(text, text + sizeof text, value, format...).ptr};
}

}  // namespace

std::string format_text(const char* format, ...) {
    const PointNumbers points;
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
    return digits_of(value);
}

std::string shortest_text(float value) {
    return digits_of(value);
}

std::string plain_text(double value) {
    const double size = std::abs(value);
    const bool plain = value == 0.0 || (size >= 1e-5 && size < 1e15);
    return digits_of(value, plain ? std::chars_format::fixed : std::chars_format::general);
}

std::string fixed_text(double value, int digits) {
    return digits_of(value, std::chars_format::fixed, digits);
}

std::string significant_text(double value, int digits) {
    return digits_of(value, std::chars_format::general, digits);
}

std::vector<std::string> split(std::string_view text, std::string_view separator) {
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + separator.size());
    }
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

std::size_t utf8_character(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
    std::uint32_t code = lead & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0u) != 0x80u) return 0;
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return overlong || surrogate || code > 0x10FFFF ? 0 : length;
}

double parse_number(std::string_view text, const std::string& what, double lowest, double highest) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    // The comparison is written so that NaN fails it.
    if (code != std::errc() || stop != end || !(value >= lowest && value <= highest)) {
        const std::string allowed = format_text("a number, %g .. %g", lowest, highest);
        throw Error(ErrorKind::invalid_value,
                    what + " = " + std::string(text) + "; allowed: " + allowed,
                    {.parameter = what, .value = std::string(text), .allowed = allowed});
    }
    return value;
}

int parse_whole_number(std::string_view text, const std::string& what, int lowest, int highest) {
    const double value = parse_number(text, what, lowest, highest);
    const int whole = static_cast<int>(value);
    if (whole == value) return whole;
    throw Error(ErrorKind::invalid_value,
                what + " = " + std::string(text) + "; allowed: a whole number",
                {.parameter = what, .value = std::string(text), .allowed = "a whole number"});
}

}  // namespace ocean
