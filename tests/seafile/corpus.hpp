// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of the corpus: where they are, their texts as bytes, names of tests.
#pragma once

#include <cctype>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include "ocean/internal/checked_text.hpp"
#include "paths.hpp"
#include "testing.hpp"
#include "toml_input.hpp"

namespace ocean::test {

/// If true, tests print what readers give: the author of a new row copies it from there.
inline const bool kPrints = std::getenv("OCEAN_CORPUS_PRINT") != nullptr;

/// Returns the bytes that a text of a table stands for: U+00E9 for the byte E9.
inline std::string bytes_of(std::string_view utf8) {
    std::string bytes;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        const auto lead = static_cast<unsigned char>(utf8[i]);
        if (lead < 0x80) {
            bytes += utf8[i];
        } else {
            if (lead > 0xC3) {
                throw std::runtime_error("a character beyond U+00FF: " + std::string(utf8));
            }
            bytes += static_cast<char>((lead & 3) << 6 | (utf8[++i] & 0x3F));
        }
    }
    return bytes;
}
inline std::string text_of(const toml::node& node) {
    return bytes_of(node.value<std::string>().value());
}

/// Expects a sentence of a table, in which "(...)" stands for any words.
inline void expect_sentence(const std::string& actual, const std::string& wanted) {
    constexpr std::string_view kAny = "(...)";
    const std::size_t any = wanted.find(kAny);
    if (any == std::string::npos) {
        EXPECT_EQ(actual, wanted);
        return;
    }
    std::size_t at = 0;
    for (std::size_t from = 0, to = any; from < wanted.size();) {
        const std::string piece = wanted.substr(from, to - from);
        at = actual.find(piece, at);
        ASSERT_TRUE(at != std::string::npos && (from > 0 || at == 0)) << wanted << "\n" << actual;
        at += piece.size();
        from = std::min(to, wanted.size() - kAny.size()) + kAny.size();
        to = std::min(wanted.find(kAny, from), wanted.size());
    }
}

inline void expect_sentence(const std::string& actual, const toml::node* expected) {
    expect_sentence(actual, expected == nullptr ? "?" : text_of(*expected));
}

inline toml::table read_table(const std::filesystem::path& path) {
    return parse_toml(text::read_file(path.string(), 4 << 20), path.string());
}

/// Returns the tables of a folder below `tests`, and of the folders in it.
inline std::vector<std::filesystem::path> tables_in(const std::string& folder) {
    std::vector<std::filesystem::path> found;
    const std::string root = source_dir() + "/tests/" + folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        if (entry.path().extension() == ".toml") found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Returns the name of a test: folders and file below the first two.
inline std::string name_of_table(const testing::TestParamInfo<std::filesystem::path>& info) {
    const std::filesystem::path path =
        std::filesystem::path(info.param).replace_extension().lexically_relative(source_dir());
    std::string name;
    for (auto part = std::next(path.begin(), 3); part != path.end(); ++part) {
        name += (name.empty() ? "" : "_") + part->string();
    }
    for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

}  // namespace ocean::test
