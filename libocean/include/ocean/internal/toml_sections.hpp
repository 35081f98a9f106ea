// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Untrusted flat TOML files as plain values: lists of tables, [[map]] and [[out]], whose values are
// numbers, texts, flags or lists of numbers. Files beside the sea file have this form.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ocean {

struct TomlKey {
    std::string name;
    std::size_t line = 0;
    std::variant<bool, double, std::string, std::vector<double>> value;
};

/// One [[NAME]] with its keys in the order of the file.
struct TomlSection {
    std::string name;
    std::size_t line = 0;
    std::vector<TomlKey> keys;
};

/// Returns the sections in the order of the file. `known` are the names that sections may have.
/// Throws Error bad_file "NAME:LINE: ..." for text that is not TOML or not of this form.
std::vector<TomlSection> parse_toml_sections(std::string_view text, const std::string& name,
                                             std::span<const std::string_view> known);

}  // namespace ocean
