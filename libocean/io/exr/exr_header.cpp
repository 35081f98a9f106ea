// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads our own strings back out of an EXR header, without OpenEXR: its reader believes the sizes
// that a file claims and would allocate gigabytes for a hostile one. Layout: magic, version, then
// attributes (name\0 type\0 size value), then an empty name. Multi-part files: the first part.
#include <algorithm>
#include <cstdint>
#include <fstream>

#include "ocean/error.hpp"
#include "ocean/io.hpp"
#include "ocean/platform.hpp"

namespace ocean::io {
namespace {

constexpr std::uint32_t kMagic = 20000630;
constexpr std::size_t kLongestName = 255;                      // the format's own limit
constexpr std::size_t kLargestHeader = std::size_t{16} << 20;  // a buoy record is some 10 kB
constexpr std::size_t kMostAttributes = 4096;

class HeaderReader {
  public:
    HeaderReader(const std::string& path, std::string bytes)
        : path_(path), bytes_(std::move(bytes)) {}

    std::uint32_t integer() {
        const std::string_view four = take(4);
        std::uint32_t value = 0;
        for (std::size_t i = 4; i-- > 0;) {
            value = (value << 8) | static_cast<unsigned char>(four[i]);
        }
        return value;
    }

    std::string_view name() {
        const std::size_t length = rest().substr(0, kLongestName + 1).find('\0');
        if (length == std::string_view::npos) fail("a name in its header does not end");
        const std::string_view text = take(length);
        take(1);
        return text;
    }

    std::string_view take(std::size_t count) {
        if (count > rest().size()) {
            fail(bytes_.size() >= kLargestHeader ? "its header is larger than 16 MiB"
                                                 : "it ends inside its header");
        }
        const std::string_view taken = rest().substr(0, count);
        position_ += count;
        return taken;
    }

    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(ErrorKind::bad_file, "cannot read the header of '" + path_ + "': " + reason);
    }

  private:
    std::string_view rest() const { return std::string_view(bytes_).substr(position_); }

    const std::string& path_;
    std::string bytes_;
    std::size_t position_ = 0;
};

std::string read_beginning(const std::string& path) {
    const auto native = utf8_path(path);
    std::error_code error;
    if (std::filesystem::is_directory(native, error)) {
        throw Error(ErrorKind::bad_file, "cannot read '" + path + "': it is a directory");
    }
    std::ifstream file(native, std::ios::binary);
    if (!file) throw Error(ErrorKind::bad_file, "cannot open '" + path + "' for reading");
    std::string bytes;
    char block[65536];
    while (bytes.size() < kLargestHeader && file) {
        file.read(block, sizeof block);
        bytes.append(block, static_cast<std::size_t>(file.gcount()));
    }
    return bytes;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> read_exr_header(const std::string& path) {
    HeaderReader reader(path, read_beginning(path));
    if (reader.integer() != kMagic) reader.fail("it is not an OpenEXR file");
    if ((reader.integer() & 0xff) != 2) reader.fail("its OpenEXR version is not 2");

    std::vector<std::pair<std::string, std::string>> strings;
    for (std::size_t count = 0;; ++count) {
        if (count > kMostAttributes) reader.fail("it has more than 4096 attributes");
        const std::string_view name = reader.name();
        if (name.empty()) break;
        const std::string_view type = reader.name();
        const std::string_view value = reader.take(reader.integer());
        if (type == "string" && name.starts_with("ocean:")) strings.emplace_back(name, value);
    }
    if (strings.empty()) {
        reader.fail("it has no 'ocean:' strings, so it was not written by libocean");
    }
    std::sort(strings.begin(), strings.end());
    return strings;
}

}  // namespace ocean::io
