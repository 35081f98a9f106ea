// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The formats whose headers hold a provenance; see read_provenance.hpp.
#include "ocean/internal/io/read_provenance.hpp"

#include <array>
#include <fstream>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/internal/io/geotiff.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/io/usd.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/io/exr.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/io/vdb.hpp"

namespace ocean::io {
namespace {

struct HeaderFormat {
    std::string_view magic;
    std::vector<HeaderString> (*read)(const std::string& path);
};
constexpr std::array kHeaderFormats = {
    HeaderFormat{"\x76\x2f\x31\x01", read_exr_header},
    HeaderFormat{"\x20\x42\x44\x56", read_vdb_header},
    HeaderFormat{"PXR-USDC", read_usd_header},
    HeaderFormat{"ply\n", read_ply_header},
    HeaderFormat{"# The surface of", read_obj_header},
    HeaderFormat{"\x89PNG\r\n\x1a\n", read_png_header},
    HeaderFormat{std::string_view("II*\0", 4), read_geotiff_header},
    HeaderFormat{std::string_view("II+\0", 4), read_geotiff_header},
};

std::string first_bytes(const std::string& path) {
    constexpr std::size_t kLongestMagic = 16;
    std::string bytes(kLongestMagic, '\0');
    std::ifstream file(utf8_path(path), std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

}  // namespace

std::optional<std::vector<HeaderString>> read_header(const std::string& path) {
    const std::string bytes = first_bytes(path);
    for (const HeaderFormat& format : kHeaderFormats) {
        if (bytes.starts_with(format.magic)) return format.read(path);
    }
    return std::nullopt;
}

std::optional<Provenance> read_provenance(const std::string& path) {
    const auto strings = read_header(path);
    if (!strings) return std::nullopt;
    std::optional<Provenance> provenance = find_provenance(*strings, path);
    if (provenance) return provenance;
    throw Error(ErrorKind::bad_file, path +
                                         ": the file has no sea; only files that `ocean bake` "
                                         "wrote have one");
}

}  // namespace ocean::io
