// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines of a text that nobody has checked, with their numbers for messages. What every reader of a
// text format begins with.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "ocean/internal/checked_text.hpp"

namespace ocean {

/// Ends of lines are LF or CRLF; a byte order mark is skipped. References must outlive the reader.
class LineReader {
  public:
    LineReader(std::string_view content, std::string_view name) : rest_(content), name_(name) {
        if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    }

    /// False at the end of the text.
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
    /// The same, blank lines skipped.
    bool next_filled() {
        while (next()) {
            if (line_.find_first_not_of(" \t") != std::string_view::npos) return true;
        }
        return false;
    }

    std::string_view line() const { return line_; }
    /// Of the line, from 1; 0 before the first.
    std::size_t number() const { return number_; }
    /// The line has no end: the file may have been cut there.
    bool cut_off() const { return cut_off_; }
    /// Bytes after the line: no claim of a file can need more values than these can hold.
    std::size_t bytes_left() const { return rest_.size(); }
    /// bad_file "NAME:LINE: message".
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

/// Takes the next blank-separated word off the front of a line; empty at its end.
inline std::string_view take_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    line.remove_prefix(word.size());
    return word;
}

}  // namespace ocean
