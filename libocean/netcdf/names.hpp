// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of variables and attributes, compared without the differences between writers, and numbers
// of a file as sentences show them.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

#include "ocean/internal/text.hpp"

namespace ocean::netcdf {

using Words = std::initializer_list<std::string_view>;

inline bool among(std::string_view word, Words words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Returns true if `names`, which begins and ends with a blank, has the name between two blanks.
inline bool lists(std::string_view names, const std::string& name) {
    return names.find(" " + name + " ") != std::string_view::npos;
}

/// Returns the name in lower-case letters and digits alone: waveA1Value, wave_a1_value and WAVE A1
/// VALUE become equal.
inline std::string plain_name(std::string_view name) {
    std::string plain = lower_case(name);
    std::erase_if(plain, [](char c) { return c == '_' || c == '-' || c == ' ' || c == '.'; });
    return plain;
}

/// Returns a number in at most 23 characters.
inline std::string shown(double value) {
    std::string digits = std::to_string(value);
    return digits.size() > 20 ? digits.substr(0, 20) + "..." : digits;
}

}  // namespace ocean::netcdf
