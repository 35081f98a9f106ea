// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Recognises the files of elevation models and opens them: see elevation_file.hpp.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "float_grid.hpp"
#include "ocean/internal/elevation_file.hpp"
#include "ocean/internal/elevation_rules.hpp"
#include "ocean/internal/line_reader.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

using namespace std::string_view_literals;
using elevation::ElevationReader;
using elevation::ForeignFormat;
namespace fs = std::filesystem;

constexpr std::size_t kMaxHeaderBytes = 65536;

Error bad_file(const std::string& path, const std::string& message) {
    return text::error_at(ErrorKind::bad_file, path, 0, message);
}

std::string lower_extension(const std::string& path) {
    return lower_case(text::to_utf8(utf8_path(path).extension()));
}

using enum ElevationReader;
constexpr std::array kForeignFormats = {
    ForeignFormat{
        "TIFF", {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}, {".tif", ".tiff"}, ocean_raster},
    ForeignFormat{"PNG", {"\x89PNG"}, {".png"}, ocean_raster},
    ForeignFormat{"OpenEXR", {"\x76\x2f\x31\x01"}, {".exr"}, exr},
    ForeignFormat{"SRTM", {}, {".hgt"}, hgt},
    ForeignFormat{"DTED", {"UHL1"}, {".dt0", ".dt1", ".dt2"}, ocean_raster},
    ForeignFormat{"Surfer", {"DSAA", "DSBB", "DSRB"}, {}, ocean_raster},
    ForeignFormat{"USGS DEM", {}, {".dem"}, ocean_raster},
    ForeignFormat{"NetCDF", {"CDF"}, {".nc", ".grd"}, gdal_translate},
    ForeignFormat{"HDF", {"\x89HDF"}, {".h5", ".hdf"}, gdal_translate},
    ForeignFormat{"raster of integers", {}, {".bil", ".img"}, gdal_translate},
    ForeignFormat{"SDTS", {}, {".ddf"}, gdal_translate},
};
constexpr ForeignFormat kEnvi{"ENVI", {}, {}, ocean_raster};

/// Throws the sentence that names the command for files of another format.
[[noreturn]] void refuse(const std::string& path, const ForeignFormat& format) {
    const std::string name = text::printable(path, 200);
    const std::string import = "`ocean terrain import " + name + " -o bed.flt`";
    const std::string other = "`gdal_translate -ot Float32 " + name +
                              " bed.tif` and `ocean terrain import bed.tif -o bed.flt`";
    throw text::error_at(ErrorKind::unsupported, path, 0,
                         "is a file of the format " + std::string(format.name) +
                             ": convert it by " +
                             (format.reader == gdal_translate ? other : import));
}

/// Returns true if the text's first word outside comments is a key of a grid's header.
bool begins_as_ascii_grid(std::string_view bytes) {
    LineReader lines(bytes, "");
    while (lines.next_filled()) {
        std::string_view rest = lines.line();
        const std::string_view word = next_word(rest);
        if (word.starts_with('#') || word.starts_with("//")) continue;
        return elevation::GridHeaderReader::knows(word) && word.size() > 1;
    }
    return false;
}

void require_file(const std::string& path) {
    const fs::path file = utf8_path(path);
    std::error_code ignored;
    if (path.find('\0') != path.npos) throw bad_file(path, "has a NUL in its name");
    if (!fs::exists(file, ignored)) throw bad_file(path, "no such file");
    if (fs::is_directory(file, ignored)) throw bad_file(path, "is a directory, not a file");
    if (!fs::is_regular_file(file, ignored)) {
        throw bad_file(path, "is a pipe or a device, not a file");
    }
}

std::ifstream opened(const std::string& path) {
    std::ifstream stream(utf8_path(path), std::ios::binary);
    if (!stream) throw bad_file(path, "cannot be read: no permission");
    return stream;
}

/// Returns the existing file with one of two extensions; "" if there is none.
std::string beside(const std::string& path, std::array<const char*, 2> extensions) {
    for (const char* extension : extensions) {
        fs::path file = utf8_path(path);
        file.replace_extension(extension);
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored)) return text::to_utf8(file);
    }
    return "";
}

/// Returns true for the samples of an ENVI file, whose header lies beside them.
bool is_envi(const std::string& path) {
    const std::string header = beside(path, {".hdr", ".HDR"});
    return text::first_bytes(header.empty() ? path + ".hdr" : header, 4) == "ENVI";
}

ElevationModel read_floats(const std::string& path, const ElevationOptions& options) {
    const std::string header = beside(path, {".hdr", ".HDR"});
    if (header.empty()) {
        throw bad_file(path, "has no header beside it: a .flt file needs a .hdr file of its name");
    }
    const elevation::GridHeader grid =
        elevation::parse_float_header(text::read_file(header, kMaxHeaderBytes), header);
    std::ifstream stream = opened(path);
    return elevation::read_float_grid(grid, stream, fs::file_size(utf8_path(path)), path,
                                      elevation::read_projection(path), options);
}

}  // namespace

const ForeignFormat* elevation::foreign_format(const std::string& path) {
    const std::string extension = lower_extension(path), first = text::first_bytes(path, 1024);
    if (extension == ".flt" || extension == ".hdr" || extension == ".asc") return nullptr;
    for (const ForeignFormat& format : kForeignFormats) {
        for (const std::string_view magic : format.first_bytes) {
            if (!magic.empty() && first.starts_with(magic)) return &format;
        }
    }
    if (begins_as_ascii_grid(first)) return nullptr;
    if (is_envi(path)) return &kEnvi;
    for (const ForeignFormat& format : kForeignFormats) {
        const auto& known = format.extensions;
        if (!extension.empty() && std::ranges::find(known, extension) != known.end()) {
            return &format;
        }
    }
    return nullptr;
}

ElevationModel read_elevation(const std::string& path, const ElevationOptions& options) {
    require_file(path);
    const std::string extension = lower_extension(path);
    if (extension == ".flt") return read_floats(path, options);
    if (extension == ".hdr") {
        const std::string floats = beside(path, {".flt", ".FLT"});
        if (!floats.empty()) return read_floats(floats, options);
        throw bad_file(path, "has no .flt file of its name beside it");
    }
    if (const ForeignFormat* format = elevation::foreign_format(path)) refuse(path, *format);
    if (extension == ".asc" || begins_as_ascii_grid(text::first_bytes(path, 1024))) {
        std::ifstream stream = opened(path);
        return parse_ascii_grid(stream, fs::file_size(utf8_path(path)), path,
                                elevation::read_projection(path), options);
    }
    throw bad_file(path,
                   "is no elevation model: .asc, or .flt with .hdr, are read, and `ocean terrain "
                   "import` converts GeoTIFF, .hgt, PNG, EXR and others");
}

}  // namespace ocean
