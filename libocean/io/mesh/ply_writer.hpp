// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A writer of binary PLY files, for meshes and points.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/provenance.hpp"

namespace ocean::io {

static_assert(std::endian::native == std::endian::little);

inline constexpr std::string_view kPlyComment = "comment";
/// An upper bound of the header's size without its comments [bytes].
inline constexpr std::uint64_t kMaxPlyHead = 1024;

class PlyHeader {
  public:
    explicit PlyHeader(std::span<const HeaderString> strings)
        : text_("ply\nformat binary_little_endian 1.0\n" + comment_lines(strings, kPlyComment)) {}

    void element(const char* name, std::size_t count) {
        text_ += "element " + std::string(name) + " " + std::to_string(count) + "\n";
    }
    /// Adds a property to the last element.
    void properties(const std::string& type, const std::vector<std::string>& names) {
        for (const std::string& name : names) text_ += "property " + type + " " + name + "\n";
    }
    std::string text() const { return text_ + "end_header\n"; }

  private:
    std::string text_;
};

/// Throws Error output.
class PlyWriter {
  public:
    PlyWriter(const std::string& path, const PlyHeader& header) : file_(path) {
        file_.write(header.text());
        buffer_.reserve(kPiece + 64);
    }

    template <typename Value>
    void put(const Value* values, std::size_t count) {
        buffer_.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
        if (buffer_.size() >= kPiece) flush();
    }
    void commit() {
        flush();
        file_.commit();
    }

  private:
    static constexpr std::size_t kPiece = std::size_t{1} << 20;

    void flush() {
        file_.write(buffer_);
        buffer_.clear();
    }

    OutputFile file_;
    std::string buffer_;
};

}  // namespace ocean::io
