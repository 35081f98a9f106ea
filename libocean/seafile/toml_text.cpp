// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Values as TOML spells them; see toml_text.hpp.
#include "toml_text.hpp"

#include <cmath>
#include <cstdint>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/json.hpp"

namespace ocean {
namespace {

template <typename Items, typename Spell>
std::string toml_array(const Items& items, const Spell& spell) {
    return "[" + joined(items, ", ", spell) + "]";
}

}  // namespace

std::string toml_string(std::string_view text) {
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t length = utf8_character(rest);
        if (length == 0) {
            throw Error(ErrorKind::invalid_value, "the text \"" + text::printable(text) +
                                                      "\" is not UTF-8; a sea file cannot hold it");
        }
        rest.remove_prefix(length);
    }
    return json_string(text);  // TOML's basic strings have the same escapes
}

std::string toml_number(double value) {
    if (std::isnan(value)) return "nan";
    std::string digits = plain_text(value);
    const bool whole = std::isfinite(value) && digits.find_first_of(".eE") == std::string::npos;
    return whole ? digits + ".0" : digits;
}

std::string toml_value(const ParameterValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return toml_number(*number);
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
    if (const auto* word = std::get_if<std::string>(&value)) return toml_string(*word);
    if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
        return toml_array(*numbers, toml_number);
    }
    if (const auto* pairs = std::get_if<NumberPairs>(&value)) {
        return toml_array(*pairs, [](const auto& pair) { return toml_array(pair, toml_number); });
    }
    return toml_array(std::get<std::vector<std::int64_t>>(value),
                      [](std::int64_t item) { return std::to_string(item); });
}

std::string toml_lines(const std::vector<double>& values, std::size_t per_line) {
    std::string out = "[";
    for (std::size_t i = 0; i < values.size(); ++i) {
        out += i % per_line == 0 ? "\n    " : " ";
        out += toml_number(values[i]) + ",";
    }
    return out + "\n]";
}

}  // namespace ocean
