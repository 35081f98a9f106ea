// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers as Fortran writes them; see fortran_number.hpp.
#include "fortran_number.hpp"

#include <cstddef>
#include <string>

#include "ocean/internal/checked_text.hpp"

namespace ocean::text {

std::optional<double> next_fortran_number(std::string_view& text) {
    const auto is_any = [&](std::size_t at, std::string_view of) {
        return at < text.size() && of.find(text[at]) != std::string_view::npos;
    };
    const auto after_digits = [&](std::size_t at) {
        while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
        return at;
    };
    const std::size_t first = is_any(0, "+-") ? 1 : 0;
    const std::size_t point = after_digits(first);
    const bool has_point = is_any(point, ".");
    const std::size_t mantissa = has_point ? after_digits(point + 1) : point;
    if (mantissa == first + (has_point ? 1 : 0)) return std::nullopt;

    const bool letter = is_any(mantissa, "eEdD");
    const std::size_t exponent = mantissa + (letter ? 1 : 0);
    const std::size_t signless = exponent + (is_any(exponent, "+-") ? 1 : 0);
    std::size_t end = after_digits(signless);
    const bool bare = has_point && signless > exponent && end == signless + 3 && !is_any(end, ".");
    if (letter && end == signless) return std::nullopt;
    if (!letter && !bare) end = mantissa;
    if (end < text.size() && !is_any(end, " \t+-")) return std::nullopt;

    std::string spelled(text.substr(0, mantissa));
    if (end > mantissa) spelled.append("e").append(text.substr(exponent, end - exponent));
    const std::optional<double> value = parse_number(spelled);
    if (value) text.remove_prefix(end);
    return value;
}

}  // namespace ocean::text
