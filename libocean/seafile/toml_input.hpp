// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// TOML that nobody has checked: bounds before the parser sees it, and what the readers of sections
// and records ask of its nodes. The only header here that includes toml++.
#pragma once

// Debian builds toml++ as a shared library; compiled in, libocean.so depends on nothing.
#define TOML_HEADER_ONLY 1
#define TOML_MAX_NESTED_VALUES 16
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/impl/preprocessor.h>

// toml++ 3.3 asserts, or lets the compiler assume, what hostile text can break (a key that begins
// with '#' after a value that was cut off); the code behind each assertion reports the error.
#undef TOML_ASSERT
#undef TOML_ASSUME
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT(...) static_assert(true)
#define TOML_ASSUME(...) static_assert(true)
#define TOML_ASSERT_ASSUME(...) static_assert(true)
#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ocean {

inline constexpr std::size_t kMaxSeaFileBytes = std::size_t{4} << 20;

/// Parses after the bounds are checked: 4 MiB, no NUL, keys of at most 16 parts. Throws Error
/// bad_file "NAME:LINE: ...".
toml::table parse_toml(std::string_view text, const std::string& name);

struct TomlEntry {
    std::string_view key;
    std::size_t line;
    const toml::node* node;
};
/// The entries of a table in the order of the file, so that the first fault is reported first.
std::vector<TomlEntry> in_file_order(const toml::table& table);

std::size_t line_of(const toml::node& node);
/// Of a float, or of an integer that stands for one; nothing if the node is neither.
std::optional<double> number_of(const toml::node& node);
/// A value as a message shows it: 300, "text", a table, an array of 3.
std::string shown(const toml::node& node);

}  // namespace ocean
