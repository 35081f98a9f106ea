// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Values as TOML and JSON spell them: the writers' side of strings and numbers. See toml_text.hpp
// and json_text.hpp; both languages share their escapes.
#include <cmath>
#include <cstdint>

#include "json_text.hpp"
#include "ocean/error.hpp"
#include "text.hpp"
#include "toml_text.hpp"

namespace ocean {
namespace {

constexpr std::string_view kHexDigits = "0123456789ABCDEF";

/// A character that TOML's basic strings and JSON's strings cannot hold as it is. DEL is legal in
/// JSON, and its escape as well.
std::string escaped(char c) {
    if (c == '"' || c == '\\') return {'\\', c};
    const auto byte = static_cast<std::uint8_t>(c);
    if (byte >= 0x20 && byte != 0x7F) return {c};
    return {'\\', 'u', '0', '0', kHexDigits[byte >> 4], kHexDigits[byte & 15u]};
}

}  // namespace

std::string json_string(std::string_view text) {
    std::string out = "\"";
    while (!text.empty()) {
        const std::size_t length = text::utf8_character(text);
        if (length == 1) out += escaped(text[0]);
        if (length == 0) out += '?';
        if (length > 1) out += text.substr(0, length);
        text.remove_prefix(length > 0 ? length : 1);
    }
    return out + '"';
}

std::string json_number(double value) {
    return std::isfinite(value) ? to_text(ParameterValue(value)) : "null";
}

std::string toml_string(std::string_view text) {
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t length = text::utf8_character(rest);
        if (length == 0) {
            throw Error(ErrorKind::invalid_value, "the text \"" + text::printable(text) +
                                                      "\" is not UTF-8; a sea file cannot hold it");
        }
        rest.remove_prefix(length);
    }
    std::string out = "\"";
    for (char c : text) out += escaped(c);
    return out + '"';
}

std::string toml_number(double value) {
    if (std::isnan(value)) return "nan";
    std::string digits = to_text(ParameterValue(value));
    const bool whole = std::isfinite(value) && digits.find_first_of(".eE") == std::string::npos;
    return whole ? digits + ".0" : digits;
}

std::string toml_value(const ParameterValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return toml_number(*number);
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
    if (const auto* word = std::get_if<std::string>(&value)) return toml_string(*word);
    std::string list;
    for (std::int64_t item : std::get<std::vector<std::int64_t>>(value)) {
        list += (list.empty() ? "" : ", ") + std::to_string(item);
    }
    return "[" + list + "]";
}

}  // namespace ocean
