// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A buffered writer of large text files.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "ocean/internal/io/output_file.hpp"

namespace ocean::io {

/// Collects text; with a file, writes it there in large pieces.
class TextWriter {
  public:
    TextWriter() = default;
    explicit TextWriter(OutputFile& file) : file_(&file) { buffer_.reserve(kPiece + 4096); }

    TextWriter& operator<<(std::string_view text) {
        buffer_ += text;
        if (file_ != nullptr && buffer_.size() >= kPiece) flush();
        return *this;
    }
    /// Appends the shortest text that reads back as the same number.
    template <typename Number>
    TextWriter& number(Number value) {
        char text[48];
        return *this << std::string_view(text, std::to_chars(text, text + sizeof text, value).ptr);
    }
    void flush() {
        file_->write(buffer_);
        buffer_.clear();
    }
    const std::string& text() const { return buffer_; }

  private:
    static constexpr std::size_t kPiece = std::size_t{1} << 20;
    OutputFile* file_ = nullptr;
    std::string buffer_;
};

}  // namespace ocean::io
