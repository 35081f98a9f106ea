// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads our own strings and the pixel layout from an EXR header without OpenEXR, whose reader
// trusts the sizes in a file and would allocate gigabytes for a hostile one. Layout: magic,
// version, then attributes (name\0 type\0 size value), then an empty name. Of a multi-part file it
// reads the first part only.
#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <system_error>

#include "exr_library.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/io/exr.hpp"

namespace ocean::io {
namespace {

constexpr std::uint32_t kMagic = 20000630;
constexpr std::size_t kMaxName = 255;                      // the format's own limit
constexpr std::size_t kMaxHeader = std::size_t{16} << 20;  // a buoy record has about 10 kB
constexpr std::size_t kMaxAttributes = 4096;

class HeaderReader {
  public:
    HeaderReader(const std::string& path, std::string bytes)
        : path_(path), bytes_(std::move(bytes)) {}

    std::uint32_t integer() {
        const std::string_view four = read(4);
        std::uint32_t value = 0;
        for (int shift = 0; const char byte : four) {
            value |= std::uint32_t{static_cast<unsigned char>(byte)} << shift;
            shift += 8;
        }
        return value;
    }

    std::string_view name() {
        const std::size_t length = rest().substr(0, kMaxName + 1).find('\0');
        if (length == std::string_view::npos) fail("a name in its header does not end");
        const std::string_view text = read(length);
        read(1);
        return text;
    }

    std::string_view read(std::size_t count) {
        if (count > rest().size()) {
            fail(bytes_.size() >= kMaxHeader ? "its header is larger than 16 MiB"
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
    while (bytes.size() < kMaxHeader && file) {
        file.read(block, sizeof block);
        bytes.append(block, static_cast<std::size_t>(file.gcount()));
    }
    return bytes;
}

struct Attribute {
    std::string name, type, value;
};

/// `excluded` are the bits of the version field that the file must not have.
std::vector<Attribute> read_attributes(const std::string& path, std::uint32_t excluded = 0) {
    HeaderReader reader(path, read_beginning(path));
    if (reader.integer() != kMagic) reader.fail("it is not an OpenEXR file");
    const std::uint32_t version = reader.integer();
    if ((version & 0xff) != 2) reader.fail("its OpenEXR version is not 2");
    if ((version & excluded) != 0) reader.fail("it has several parts or deep pixels");
    std::vector<Attribute> attributes;
    for (;;) {
        if (attributes.size() > kMaxAttributes) reader.fail("it has more than 4096 attributes");
        Attribute attribute;
        attribute.name = reader.name();
        if (attribute.name.empty()) return attributes;
        attribute.type = reader.name();
        attribute.value = reader.read(reader.integer());
        attributes.push_back(std::move(attribute));
    }
}

/// Returns a reader of the value of one attribute.
HeaderReader value_reader(const std::string& path, const std::vector<Attribute>& attributes,
                          std::string_view name, std::string_view type) {
    for (const Attribute& attribute : attributes) {
        if (attribute.name == name && attribute.type == type) return {path, attribute.value};
    }
    HeaderReader(path, "").fail("it has no " + std::string(name));
}

/// Returns the width and the height.
std::array<std::int64_t, 2> read_size(HeaderReader& window) {
    std::int64_t corner[4];
    for (std::int64_t& value : corner) value = static_cast<std::int32_t>(window.integer());
    return {corner[2] - corner[0] + 1, corner[3] - corner[1] + 1};
}

std::array<int, 2> read_samples(HeaderReader window) {
    constexpr std::int64_t kMaxSamples = 1 << 20;  // along a side: many tiles of a terrain
    const auto [width, height] = read_size(window);
    if (std::min(width, height) < 1 || std::max(width, height) > kMaxSamples) {
        window.fail("its image has no size, or more than 1048576 samples along a side");
    }
    return {static_cast<int>(width), static_cast<int>(height)};
}

std::optional<ExrCompression> read_compression(HeaderReader code) {
    const auto value = static_cast<unsigned char>(code.read(1).front());
    if (value >= enum_count<ExrCompression>()) return std::nullopt;
    return static_cast<ExrCompression>(value);
}

std::vector<ExrChannel> read_channels(HeaderReader list) {
    constexpr std::uint32_t kHalf = 1, kFloat = 2;
    constexpr std::size_t kSampling = 12;  // linearity, and the sampling in x and y
    std::vector<ExrChannel> channels;
    for (;;) {
        const std::string name(list.name());
        if (name.empty()) break;
        const std::uint32_t type = list.integer();
        if (type != kHalf && type != kFloat) list.fail("its channels are neither half nor float");
        list.read(kSampling);
        channels.push_back({name, type == kHalf ? PixelType::half_float : PixelType::full_float});
    }
    return channels;
}

}  // namespace

std::vector<HeaderString> read_exr_header(const std::string& path) {
    std::vector<HeaderString> strings;
    for (Attribute& attribute : read_attributes(path)) {
        if (attribute.type != "string" || !attribute.name.starts_with("ocean:")) continue;
        strings.push_back({std::move(attribute.name), std::move(attribute.value)});
    }
    if (strings.empty()) {
        HeaderReader(path, "").fail(
            "it has no 'ocean:' strings, so it was not written by libocean");
    }
    std::sort(strings.begin(), strings.end(),
              [](const HeaderString& a, const HeaderString& b) { return a.name < b.name; });
    return strings;
}

ExrLayout read_exr_layout(const std::string& path) {
    const std::vector<Attribute> attributes = read_attributes(path);
    return {read_samples(value_reader(path, attributes, "dataWindow", "box2i")),
            read_compression(value_reader(path, attributes, "compression", "compression")),
            read_channels(value_reader(path, attributes, "channels", "chlist"))};
}

ExrClaims read_exr_claims(const std::string& path) {
    constexpr std::uint32_t kDeep = 0x800, kSeveralParts = 0x1000;
    const std::vector<Attribute> attributes = read_attributes(path, kDeep | kSeveralParts);
    HeaderReader window = value_reader(path, attributes, "dataWindow", "box2i");
    const auto [width, height] = read_size(window);
    ExrClaims claims{width, height, 0,
                     read_channels(value_reader(path, attributes, "channels", "chlist"))};
    for (const Attribute& attribute : attributes) {
        if (attribute.name != "tiles" || attribute.type != "tiledesc") continue;
        HeaderReader tiles(path, attribute.value);
        const std::uint32_t tile_width = tiles.integer();
        claims.tile = std::max(tile_width, tiles.integer());
    }
    return claims;
}

}  // namespace ocean::io
