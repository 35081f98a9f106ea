// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the header strings of a TIFF from its first directory [TIFF 6.0] section 2, so that the
// origin of a file is known in builds without libtiff. BigTIFF has the same directory with wider
// numbers.
#include "geotiff_header.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>

#include "ocean/error.hpp"
#include "ocean/internal/io/geotiff.hpp"
#include "ocean/internal/io/provenance.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean::io {
namespace {

constexpr std::uint64_t kDescription = 270, kAscii = 2;
constexpr std::uint64_t kMaxDescription = std::uint64_t{8} << 20;  // a subject with its rings
constexpr std::uint64_t kMaxEntries = 4096;

/// Reads numbers of one byte order from a file.
class TiffReader {
  public:
    explicit TiffReader(const std::string& path)
        : path_(path), file_(utf8_path(path), std::ios::binary) {}

    [[noreturn]] void refuse(const char* reason) const {
        throw Error(ErrorKind::bad_file, path_ + ": " + reason);
    }

    std::string bytes(std::uint64_t at, std::uint64_t count) {
        std::string bytes(static_cast<std::size_t>(count), '\0');
        file_.clear();
        file_.seekg(static_cast<std::streamoff>(at));
        file_.read(bytes.data(), static_cast<std::streamsize>(count));
        if (!file_) refuse("its header ends early");
        return bytes;
    }
    std::uint64_t number(std::uint64_t at, std::uint64_t size) {
        std::uint64_t value = 0;
        const std::string digits = bytes(at, size);
        for (std::size_t i = 0; i < digits.size(); ++i) {
            const std::size_t from = big_endian_ ? i : digits.size() - 1 - i;
            value = value << 8 | static_cast<unsigned char>(digits[from]);
        }
        return value;
    }

    /// Returns the text of ImageDescription in the first directory; nothing without it.
    std::optional<std::string> description() {
        const std::string magic = bytes(0, 4);
        big_endian_ = magic.starts_with("MM");
        if (!big_endian_ && !magic.starts_with("II")) refuse("is no TIFF file");
        const std::uint64_t version = number(2, 2);
        if (version != 42 && version != 43) refuse("is no TIFF file");
        const bool is_big = version == 43;
        const std::uint64_t wide = is_big ? 8 : 4;     // the size of an offset
        const std::uint64_t counter = is_big ? 8 : 2;  // of the number of entries
        const std::uint64_t entry_size = 4 + 2 * wide;
        const std::uint64_t directory = number(is_big ? 8 : 4, wide);
        if (directory > kMaxOffset) refuse("its directory is damaged");
        const std::uint64_t entries = number(directory, counter);
        if (entries > kMaxEntries) refuse("its directory is damaged");
        for (std::uint64_t i = 0; i < entries; ++i) {
            const std::uint64_t at = directory + counter + i * entry_size;
            if (number(at, 2) != kDescription || number(at + 2, 2) != kAscii) continue;
            const std::uint64_t count = number(at + 4, wide);
            if (count > kMaxDescription) refuse("its ImageDescription is too long");
            const std::uint64_t place = count <= wide ? at + 4 + wide : number(at + 4 + wide, wide);
            if (place > kMaxOffset) refuse("its directory is damaged");
            return bytes(place, count);
        }
        return std::nullopt;
    }

  private:
    static constexpr std::uint64_t kMaxOffset = std::uint64_t{1} << 62;

    const std::string& path_;
    std::ifstream file_;
    bool big_endian_ = false;
};

}  // namespace

std::vector<HeaderString> read_geotiff_header(const std::string& path) {
    TiffReader reader(path);
    std::string text = reader.description().value_or("");
    text.resize(text.find_last_not_of('\0') + 1);
    std::vector<HeaderString> strings = parse_comment_lines(text, kGeotiffLine);
    if (strings.empty()) {
        reader.refuse(
            "its header names no subject, so it was not written by libocean; "
            "`ocean terrain import` reads elevation models");
    }
    return strings;
}

}  // namespace ocean::io
