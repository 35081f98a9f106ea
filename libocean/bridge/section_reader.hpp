// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the keys of one section of a control map. Its errors name the line, the key and the values
// that are allowed.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/toml_sections.hpp"

namespace ocean::bridge {

/// Returns all words of an Enum for a message: "range, toggle, momentary".
template <typename Enum>
std::string words_of() {
    return joined(kEnumWords<Enum>, ", ");
}

/// A key of a section, and a function that reads its value.
struct KeyRow {
    std::string_view key;
    std::function<void()> read;
};

class SectionReader {
  public:
    /// `section` and `file` must outlive the reader.
    SectionReader(const TomlSection& section, const std::string& file)
        : section_(section), file_(file) {}

    /// Reads the keys in the order of the file, each by its row. Those that are `read_elsewhere`
    /// may also be in the section. Throws Error bad_file for any other key.
    void read_keys(std::initializer_list<KeyRow> rows,
                   std::initializer_list<std::string_view> read_elsewhere = {});
    /// Goes to the next key, first to the first one. Returns false after the last key.
    bool next();
    const std::string& key() const { return key_->name; }
    bool has(std::string_view key) const;

    /// Returns the error "FILE:LINE: message", with the line of the section.
    Error fail(const std::string& message) const;
    /// Returns the error "FILE:LINE: key = value: message", with the line of the current key.
    Error fail_here(const std::string& message) const;
    /// Returns fail_here() for a value that is not among `allowed`.
    Error refused(const std::string& allowed) const;
    /// Returns fail_here() for a text that is none of `words`.
    Error refused_word(std::span<const std::string_view> words) const;

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
        if (const auto found = enumerator_of<Enum>(text())) return *found;
        throw refused_word(kEnumWords<Enum>);
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

    void read_keys(std::initializer_list<KeyRow> rows) {
        SectionReader::read_keys(rows, {"id", "driver"});
    }
};

}  // namespace ocean::bridge
