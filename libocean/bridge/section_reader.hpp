// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Goes through the keys of a section of the map and takes their values, or says at which line which
// key is wrong and what is allowed.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/toml_sections.hpp"

namespace ocean::bridge {

/// What all words of an Enum are, for messages.
template <typename Enum>
std::string words_of() {
    std::string words;
    for (const std::string_view word : kEnumWords<Enum>) {
        words += (words.empty() ? "" : ", ") + std::string(word);
    }
    return words;
}

class SectionReader {
  public:
    /// Both outlive it.
    SectionReader(const TomlSection& section, const std::string& file)
        : section_(section), file_(file) {}

    /// Goes on to a key; false after the last.
    bool next();
    const std::string& key() const { return key_->name; }
    /// Back before the first key.
    void rewind() { next_ = 0; }

    /// "FILE:LINE: message" of the section.
    Error fail(const std::string& message) const;
    /// Of the key.
    Error fail_here(const std::string& message) const;
    Error refused(const std::string& allowed) const;
    Error unknown(const std::string& allowed) const;

    // The key's value. Throw Error bad_file for one of another kind, or out of range.
    const std::string& text() const;
    bool flag() const;
    double number(double lowest, double highest) const;
    int whole(int lowest, int highest) const;
    /// Two numbers, the second larger if `rising`.
    std::array<double, 2> range(bool rising) const;
    /// Whole numbers, none of them twice.
    std::vector<int> whole_list(int lowest, int highest) const;
    template <typename Enum>
    Enum word() const {
        const auto& words = kEnumWords<Enum>;
        const auto found = std::ranges::find(words, std::string_view(text()));
        if (found == words.end()) throw refused(words_of<Enum>());
        return static_cast<Enum>(found - words.begin());
    }

  private:
    std::string given() const;

    const TomlSection& section_;
    const std::string& file_;
    std::size_t next_ = 0;
    const TomlKey* key_ = nullptr;
};

}  // namespace ocean::bridge
