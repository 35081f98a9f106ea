// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// GeoTIFF by libtiff. The tags of [GeoTIFF 1.1] are registered here: libtiff does not know them,
// and libgeotiff would bring PROJ along.
//
//   ModelPixelScale  cell sizes along x and y [m]
//   ModelTiepoint    the first sample of the file, the north-western one, and its place [m]
//   GeoKeyDirectory  a projected, user-defined system in metres, samples as points
#include "ocean/internal/io/geotiff.hpp"

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

#include "geotiff_header.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/provenance.hpp"

namespace ocean::io {
namespace {

constexpr std::uint32_t kTileSide = 256;
constexpr std::uint32_t kPixelScale = 33550, kTiepoint = 33922, kGeoKeys = 34735, kGeoTexts = 34737;
constexpr int kDeflateLevel = 6;
constexpr std::uint64_t kMaxClassicBytes = 0xF0000000u;  // beyond it offsets need 64 bits

char kScaleName[] = "ModelPixelScaleTag", kTiepointName[] = "ModelTiepointTag";
char kKeysName[] = "GeoKeyDirectoryTag", kTextsName[] = "GeoAsciiParamsTag";
constexpr std::uint16_t kAnyPlace = FIELD_CUSTOM;
const TIFFFieldInfo kGeoFields[] = {
    {kPixelScale, -1, -1, TIFF_DOUBLE, kAnyPlace, 1, 1, kScaleName},
    {kTiepoint, -1, -1, TIFF_DOUBLE, kAnyPlace, 1, 1, kTiepointName},
    {kGeoKeys, -1, -1, TIFF_SHORT, kAnyPlace, 1, 1, kKeysName},
    {kGeoTexts, -1, -1, TIFF_ASCII, kAnyPlace, 1, 0, kTextsName},
};

// Keys and codes of [GeoTIFF 1.1] chapter 7.
enum Key : std::uint16_t {
    kModelType = 1024,
    kRasterType = 1025,
    kCitation = 1026,
    kProjectedSystem = 3072,
    kProjectedCitation = 3073,
    kLinearUnits = 3076,
    kVerticalUnits = 4099,
};
enum Code : std::uint16_t {
    kProjected = 1,
    kPixelIsPoint = 2,
    kUserDefined = 32767,
    kMetre = 9001
};
constexpr std::string_view kGridName = "libocean: local grid in metres, x east, y north|";

/// A TIFF in memory, as libtiff's client.
struct Memory {
    std::string bytes;
    std::uint64_t position = 0;
    std::string message;  // the first error of libtiff

    static Memory& of(thandle_t handle) { return *static_cast<Memory*>(handle); }
    static tmsize_t read(thandle_t handle, void* data, tmsize_t count) {
        Memory& memory = of(handle);
        if (memory.position >= memory.bytes.size()) return 0;
        const std::size_t given = std::min<std::size_t>(static_cast<std::size_t>(count),
                                                        memory.bytes.size() - memory.position);
        std::memcpy(data, memory.bytes.data() + memory.position, given);
        memory.position += given;
        return static_cast<tmsize_t>(given);
    }
    static tmsize_t write(thandle_t handle, void* data, tmsize_t count) {
        Memory& memory = of(handle);
        const std::size_t end = memory.position + static_cast<std::size_t>(count);
        if (memory.bytes.size() < end) memory.bytes.resize(end);
        std::memcpy(memory.bytes.data() + memory.position, data, static_cast<std::size_t>(count));
        memory.position = end;
        return count;
    }
    static toff_t seek(thandle_t handle, toff_t offset, int whence) {
        Memory& memory = of(handle);
        if (whence == SEEK_CUR) offset += memory.position;
        if (whence == SEEK_END) offset += memory.bytes.size();
        return memory.position = offset;
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return of(handle).bytes.size(); }
};

/// Keeps the first error of a file as its message. Returns that it was handled.
int keep_error(TIFF*, void* message, const char*, const char* format, va_list arguments) {
    std::array<char, 256> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    auto& kept = *static_cast<std::string*>(message);
    if (kept.empty()) kept = text.data();
    return 1;
}
int ignore_warning(TIFF*, void*, const char*, const char*, va_list) {
    return 1;
}

struct Closer {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using OpenTiff = std::unique_ptr<TIFF, Closer>;

struct OptionsCloser {
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
std::unique_ptr<TIFFOpenOptions, OptionsCloser> options_of(std::string& message) {
    std::unique_ptr<TIFFOpenOptions, OptionsCloser> options(TIFFOpenOptionsAlloc());
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_error, &message);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_warning, nullptr);
    return options;
}

void set_geo_tags(TIFF* tiff, const Domain& domain) {
    TIFFMergeFieldInfo(tiff, kGeoFields, std::size(kGeoFields));
    const double scale[] = {domain.step(0), domain.step(1), 0.0};
    const auto [west, north] = domain.place(0, domain.samples[1] - 1);
    const double tiepoint[] = {0.0, 0.0, 0.0, west, north, 0.0};
    const auto name_size = static_cast<std::uint16_t>(kGridName.size());
    // A row of four: key, tag that holds its value (0: the row itself), count, value or offset.
    const std::uint16_t keys[][4] = {
        {1, 1, 1, 7},  // the version, and the number of keys
        {kModelType, 0, 1, kProjected},
        {kRasterType, 0, 1, kPixelIsPoint},
        {kCitation, kGeoTexts, name_size, 0},
        {kProjectedSystem, 0, 1, kUserDefined},
        {kProjectedCitation, kGeoTexts, name_size, 0},
        {kLinearUnits, 0, 1, kMetre},
        {kVerticalUnits, 0, 1, kMetre},
    };
    TIFFSetField(tiff, kPixelScale, static_cast<int>(std::size(scale)), scale);
    TIFFSetField(tiff, kTiepoint, static_cast<int>(std::size(tiepoint)), tiepoint);
    TIFFSetField(tiff, kGeoKeys, static_cast<int>(4 * std::size(keys)), keys);
    TIFFSetField(tiff, kGeoTexts, std::string(kGridName).c_str());
}

void set_tags(TIFF* tiff, const Image& image) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_FLOATINGPOINT);
    TIFFSetField(tiff, TIFFTAG_ZIPQUALITY, kDeflateLevel);
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kTileSide);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, kTileSide);
    TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION,
                 comment_lines(image.header_strings(), kGeotiffLine).c_str());
    set_geo_tags(tiff, *image.domain);
}

/// Writes the tiles, row by row from the north. Beyond the image a tile repeats its last column and
/// row, which readers crop.
bool write_tiles(TIFF* tiff, const Image& image) {
    const auto width = static_cast<std::uint32_t>(image.width);
    const auto height = static_cast<std::uint32_t>(image.height);
    const ImagePlane& plane = image.planes.front();
    std::vector<float> tile(std::size_t{kTileSide} * kTileSide);
    for (std::uint32_t top = 0; top < height; top += kTileSide) {
        for (std::uint32_t left = 0; left < width; left += kTileSide) {
            for (std::uint32_t at = 0; at < tile.size(); ++at) {
                const std::uint32_t row = std::min(top + at / kTileSide, height - 1);
                const std::uint32_t column = std::min(left + at % kTileSide, width - 1);
                tile[at] =
                    plane.factor * plane.samples[std::size_t{height - 1 - row} * width + column];
            }
            if (TIFFWriteTile(tiff, tile.data(), left, top, 0, 0) < 0) return false;
        }
    }
    return true;
}

void check(const Image& image) {
    const bool has_plane =
        !image.planes.empty() && image.width > 0 && image.height > 0 &&
        image.planes.front().samples.size() ==
            static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (!has_plane || !image.domain ||
        image.domain->samples != std::array{image.width, image.height}) {
        throw Error(ErrorKind::invalid_value, "a GeoTIFF needs a plane of heights and its domain");
    }
}

}  // namespace

void write_geotiff(const Image& image, const std::string& path) {
    check(image);
    Memory memory;
    const auto options = options_of(memory.message);
    const bool is_big = max_geotiff_bytes(*image.domain) > kMaxClassicBytes;
    bool written = false;
    if (OpenTiff tiff{TIFFClientOpenExt(path.c_str(), is_big ? "w8l" : "wl", &memory, Memory::read,
                                        Memory::write, Memory::seek, Memory::close, Memory::size,
                                        nullptr, nullptr, options.get())}) {
        set_tags(tiff.get(), image);
        written = write_tiles(tiff.get(), image) && TIFFFlush(tiff.get()) != 0;
    }
    if (!written || !memory.message.empty()) {
        throw Error(ErrorKind::output, path + ": libtiff: " + memory.message);
    }
    write_file_atomically(path, memory.bytes);
}

std::uint64_t max_geotiff_bytes(const Domain& domain) {
    constexpr std::uint64_t kHead = 8192, kPerTile = 256;
    const auto tiles = [&domain](std::size_t axis) {
        return (static_cast<std::uint64_t>(domain.samples[axis]) + kTileSide - 1) / kTileSide;
    };
    // Deflate adds five bytes to each block of 16 KiB that it cannot compress.
    constexpr std::uint64_t kTileBytes = std::uint64_t{kTileSide} * kTileSide * sizeof(float);
    return kHead + tiles(0) * tiles(1) * (kTileBytes + kPerTile);
}

void read_geotiff(const std::string& path, const Domain& domain, const ByteSink& sink) {
    std::string message;
    const auto options = options_of(message);
    const auto refuse = [&](const std::string& reason) {
        throw Error(ErrorKind::bad_file, "cannot read '" + path + "': " + reason);
    };
    const OpenTiff tiff{TIFFOpenExt(path.c_str(), "r", options.get())};
    if (tiff == nullptr) refuse(message);
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 0, format = 0, samples = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLEFORMAT, &format);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
    constexpr tmsize_t kTileBytes = tmsize_t{kTileSide} * kTileSide * sizeof(float);
    if (width != static_cast<std::uint32_t>(domain.samples[0]) ||
        height != static_cast<std::uint32_t>(domain.samples[1]) || bits != 32 || samples != 1 ||
        format != SAMPLEFORMAT_IEEEFP || TIFFIsTiled(tiff.get()) == 0 ||
        TIFFTileSize(tiff.get()) != kTileBytes) {
        refuse("it does not have the samples of this bake");
    }
    std::vector<float> tile(std::size_t{kTileSide} * kTileSide);
    std::vector<float> rows(std::size_t{kTileSide} * width);
    for (std::uint32_t top = 0; top < height; top += kTileSide) {
        for (std::uint32_t left = 0; left < width; left += kTileSide) {
            if (TIFFReadTile(tiff.get(), tile.data(), left, top, 0, 0) != kTileBytes) {
                refuse(message);
            }
            const std::uint32_t columns = std::min(kTileSide, width - left);
            for (std::uint32_t row = 0; row < kTileSide; ++row) {
                std::copy_n(&tile[std::size_t{row} * kTileSide], columns,
                            &rows[std::size_t{row} * width + left]);
            }
        }
        const std::size_t count = std::size_t{std::min(kTileSide, height - top)} * width;
        sink({reinterpret_cast<const char*>(rows.data()), count * sizeof(float)});
    }
}

}  // namespace ocean::io
