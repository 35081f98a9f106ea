// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines of an untrusted text, with their numbers for messages: the common part of the readers of
// text formats.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "ocean/internal/checked_text.hpp"

namespace ocean {

/// Splits a text into lines that end in LF or CRLF, and skips a byte order mark. Text and name must
/// outlive the reader.
class LineReader {
  public:
    LineReader(std::string_view content, std::string_view name) : rest_(content), name_(name) {
        if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    }

    /// Steps to the next line; false at the end of the text.
    bool next() {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        cut_off_ = end == std::string_view::npos;
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(cut_off_ ? rest_.size() : end + 1);
        if (line_.ends_with('\r')) line_.remove_suffix(1);
        ++number_;
        return true;
    }
    /// Steps to the next line that is not blank; false at the end of the text.
    bool next_filled() {
        while (next()) {
            if (line_.find_first_not_of(" \t") != std::string_view::npos) return true;
        }
        return false;
    }

    std::string_view line() const { return line_; }
    /// Returns the number of the line, from 1; 0 before the first.
    std::size_t number() const { return number_; }
    /// Returns true if the line has no line end, so that the file may have been cut off in it.
    bool cut_off() const { return cut_off_; }
    /// Returns the bytes after the line, a bound on how many values a file can still contain.
    std::size_t bytes_left() const { return rest_.size(); }
    /// Returns Error bad_file "NAME:LINE: message".
    Error fail(std::string_view message) const {
        return text::error_at(ErrorKind::bad_file, name_, number_, message);
    }

  private:
    std::string_view rest_;
    std::string_view name_;
    std::string_view line_;
    std::size_t number_ = 0;
    bool cut_off_ = false;
};

/// Returns the text without blanks around it.
inline std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text.substr(0, text.find_last_not_of(" \t") + 1);
}

/// Removes the next blank-separated word from the front of a line and returns it; empty at its end.
inline std::string_view next_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    line.remove_prefix(word.size());
    return word;
}

}  // namespace ocean
