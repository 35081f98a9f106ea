// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the keys of one section of a control map. Its errors name the line, the key and the values
// that are allowed.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/toml_sections.hpp"

namespace ocean::bridge {

/// Returns all words of an Enum for a message: "range, toggle, momentary".
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
    /// `section` and `file` must outlive the reader.
    SectionReader(const TomlSection& section, const std::string& file)
        : section_(section), file_(file) {}

    /// Goes to the next key, first to the first one. Returns false after the last key.
    bool next();
    const std::string& key() const { return key_->name; }

    /// Returns the error "FILE:LINE: message", with the line of the section.
    Error fail(const std::string& message) const;
    /// Returns the error "FILE:LINE: key = value: message", with the line of the current key.
    Error fail_here(const std::string& message) const;
    /// Returns fail_here() for a value that is not among `allowed`.
    Error refused(const std::string& allowed) const;
    /// Returns fail_here() for a text that is none of `words`.
    Error refused_word(std::span<const std::string_view> words) const;
    /// Returns the error for a current key that is not among the keys `allowed`.
    Error unknown(const std::string& allowed) const;

    // Return the value of the current key. They throw Error bad_file for a value of another type or
    // out of range.
    const std::string& text() const;
    bool flag() const;
    double number(double min, double max) const;
    int whole(int min, int max) const;
    /// Returns two numbers; if `rising`, the second is larger.
    std::array<double, 2> range(bool rising) const;
    /// Returns distinct whole numbers.
    std::vector<int> whole_list(int min, int max) const;
    template <typename Enum>
    Enum word() const {
        const auto& words = kEnumWords<Enum>;
        const auto found = std::ranges::find(words, std::string_view(text()));
        if (found == words.end()) throw refused_word(words);
        return static_cast<Enum>(found - words.begin());
    }

  private:
    std::string given() const;

    const TomlSection& section_;
    const std::string& file_;
    std::size_t next_ = 0;
    const TomlKey* key_ = nullptr;
};

/// A [[device]] without its keys `id` and `driver`, which are read before its driver is known.
class DeviceSection : public SectionReader {
  public:
    using SectionReader::SectionReader;

    bool next() {
        while (SectionReader::next()) {
            if (key() != "id" && key() != "driver") return true;
        }
        return false;
    }
    Error unknown(const std::string& allowed) const {
        return SectionReader::unknown("id, driver, " + allowed);
    }
};

}  // namespace ocean::bridge
