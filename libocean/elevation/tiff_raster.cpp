// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// GeoTIFF by libtiff: see tiff_raster.hpp.
#include "tiff_raster.hpp"

#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include "geo_keys.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/elevation_rules.hpp"
#include "ocean/text.hpp"

namespace ocean::elevation {
namespace {

constexpr std::uint64_t kMaxBufferBytes = std::uint64_t{256} << 20;  // of a row of tiles

// Tags that libtiff does not know by itself.
constexpr std::uint32_t kPixelScale = 33550;
constexpr std::uint32_t kTiePoints = 33922;
constexpr std::uint32_t kTransformation = 34264;
constexpr std::uint32_t kGeoDirectory = 34735;
constexpr std::uint32_t kGeoDoubles = 34736;
constexpr std::uint32_t kGeoTexts = 34737;
constexpr std::uint32_t kGdalMetadata = 42112;
constexpr std::uint32_t kGdalNoData = 42113;

/// The message of libtiff's last error, which its functions report by false alone.
std::string& last_message() {
    static std::string message;
    return message;
}

void keep_message(const char*, const char* format, va_list arguments) {
    char text[300];
    std::vsnprintf(text, sizeof(text), format, arguments);
    last_message() = text;
}

RasterFault failed(const std::string& action) {
    const std::string why = text::printable(last_message(), 200);
    return RasterFault(action + (why.empty() ? "" : ": " + why));
}

void add_tags(TIFF* tiff) {
    static char names[8][16] = {"PixelScale", "TiePoints", "Transformation", "GeoDirectory",
                                "GeoDoubles", "GeoTexts",  "GdalMetadata",   "GdalNoData"};
    static const TIFFFieldInfo infos[] = {
        {kPixelScale, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[0]},
        {kTiePoints, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[1]},
        {kTransformation, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[2]},
        {kGeoDirectory, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, names[3]},
        {kGeoDoubles, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[4]},
        {kGeoTexts, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[5]},
        {kGdalMetadata, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[6]},
        {kGdalNoData, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[7]},
    };
    TIFFMergeFieldInfo(tiff, infos, std::size(infos));
}

// libtiff's input and output: a stream that is only read.
std::istream& stream_of(thandle_t handle) {
    return *static_cast<std::istream*>(handle);
}

tmsize_t read_bytes(thandle_t handle, void* bytes, tmsize_t count) {
    std::istream& stream = stream_of(handle);
    stream.read(static_cast<char*>(bytes), count);
    const auto got = static_cast<tmsize_t>(stream.gcount());
    stream.clear();
    return got;
}

tmsize_t write_nothing(thandle_t, void*, tmsize_t) {
    return 0;
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
    std::istream& stream = stream_of(handle);
    const std::ios::seekdir from = whence == SEEK_SET   ? std::ios::beg
                                   : whence == SEEK_CUR ? std::ios::cur
                                                        : std::ios::end;
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(offset), from);
    if (!stream) {
        stream.clear();
        return static_cast<toff_t>(-1);
    }
    return static_cast<toff_t>(stream.tellg());
}

int close_nothing(thandle_t) {
    return 0;
}

toff_t size_of(thandle_t handle) {
    std::istream& stream = stream_of(handle);
    const auto here = stream.tellg();
    stream.seekg(0, std::ios::end);
    const auto size = static_cast<toff_t>(stream.tellg());
    stream.seekg(here);
    return size;
}

struct Closer {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using File = std::unique_ptr<TIFF, Closer>;

File open(std::istream& stream) {
    last_message().clear();
    TIFFSetErrorHandler(keep_message);
    TIFFSetWarningHandler(nullptr);
    TIFFSetTagExtender(add_tags);
    // "m": not mapped into memory, where a file that shrinks would be a crash.
    File file(TIFFClientOpen("raster", "rm", &stream, read_bytes, write_nothing, seek,
                             close_nothing, size_of, nullptr, nullptr));
    if (!file) throw failed("is not a whole TIFF file");
    return file;
}

template <typename T>
T tag_or(TIFF* tiff, std::uint32_t tag, T otherwise) {
    T value = otherwise;
    return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : otherwise;
}

template <typename T>
std::vector<T> list_tag(TIFF* tiff, std::uint32_t tag) {
    std::uint16_t count = 0;
    const T* values = nullptr;
    if (TIFFGetField(tiff, tag, &count, &values) != 1 || values == nullptr) return {};
    return {values, values + count};
}

std::string text_tag(TIFF* tiff, std::uint32_t tag) {
    const char* text = nullptr;
    return TIFFGetField(tiff, tag, &text) == 1 && text != nullptr ? text : "";
}

/// The layout of a raster's samples.
struct SampleType {
    int bits;
    bool is_float;
    bool is_signed;

    std::size_t bytes() const { return static_cast<std::size_t>(bits) / 8; }

    double value(const std::byte* at) const {
        const auto as = [&]<typename T>(T sample) {
            std::memcpy(&sample, at, sizeof(sample));
            return static_cast<double>(sample);
        };
        if (is_float) return bits == 64 ? as(double()) : as(float());
        switch (bits) {
            case 8:
                return is_signed ? as(std::int8_t()) : as(std::uint8_t());
            case 16:
                return is_signed ? as(std::int16_t()) : as(std::uint16_t());
            default:
                return is_signed ? as(std::int32_t()) : as(std::uint32_t());
        }
    }
};

SampleType sample_type(TIFF* tiff) {
    const auto bits = tag_or<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
    const auto format = tag_or<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    const SampleType type{bits, format == SAMPLEFORMAT_IEEEFP, format == SAMPLEFORMAT_INT};
    const bool known = format == SAMPLEFORMAT_IEEEFP || format == SAMPLEFORMAT_INT ||
                       format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID;
    const bool good =
        type.is_float ? bits == 32 || bits == 64 : known && (bits == 8 || bits == 16 || bits == 32);
    if (good) return type;
    throw RasterFault("has samples of " + std::to_string(bits) +
                      " bits; allowed are integers of 8, 16 and 32 bits and floats of 32 and 64");
}

void require_readable(TIFF* tiff) {
    const auto bands = tag_or<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    if (bands != 1) {
        throw RasterFault("has " + std::to_string(bands) +
                          " bands; heights are one band (`gdal_translate -b 1` takes the first)");
    }
    if (tag_or<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK) ==
        PHOTOMETRIC_PALETTE) {
        throw RasterFault("is a picture with a palette, not heights");
    }
    if (tag_or<std::uint16_t>(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) !=
        ORIENTATION_TOPLEFT) {
        throw RasterFault("has its first row elsewhere than on top; `gdalwarp` turns it");
    }
    const auto compression = tag_or<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    if (TIFFIsCODECConfigured(compression) != 1) {
        throw RasterFault("has the compression " + std::to_string(compression) +
                          ", which this libtiff lacks; `gdal_translate -co COMPRESS=DEFLATE` "
                          "converts it");
    }
}

/// Returns the number after `role="scale">` or `role="offset">` in GDAL's metadata.
double metadata_number(const std::string& metadata, const std::string& role, double otherwise) {
    const std::string mark = "role=\"" + role + "\">";
    const std::size_t at = metadata.find(mark);
    if (at == metadata.npos) return otherwise;
    const std::size_t begin = at + mark.size();
    const auto number = text::parse_number(
        std::string_view(metadata).substr(begin, metadata.find('<', begin) - begin));
    return number && !is_fill_value(*number) ? *number : otherwise;
}

/// Turns samples into heights.
struct SampleScale {
    SampleType type;
    std::optional<double> missing;
    double scale = 1.0;
    double offset = 0.0;

    float height(const std::byte* at) const {
        const double value = type.value(at);
        const bool is_missing =
            is_fill_value(value) ||
            (missing && (value == *missing || (type.is_float && static_cast<float>(value) ==
                                                                    static_cast<float>(*missing))));
        if (is_missing) return std::numeric_limits<float>::quiet_NaN();
        return static_cast<float>(scale * value + offset);
    }
};

SampleScale sample_scale(TIFF* tiff, RasterFacts& facts) {
    SampleScale samples{.type = sample_type(tiff), .missing = {}};
    std::string missing = text_tag(tiff, kGdalNoData);
    while (!missing.empty() && missing.back() == ' ') missing.pop_back();
    samples.missing = text::parse_number(missing);
    const bool may_be_void = samples.type.bits == 16 && samples.type.is_signed;
    if (!samples.missing && may_be_void) samples.missing = -32768.0;
    const std::string metadata = text_tag(tiff, kGdalMetadata);
    samples.scale = metadata_number(metadata, "scale", 1.0);
    samples.offset = metadata_number(metadata, "offset", 0.0);
    if (samples.scale != 1.0 || samples.offset != 0.0) {
        facts.notes.push_back("the file states that a height is " + shortest_text(samples.scale) +
                              " times its sample plus " + shortest_text(samples.offset));
    }
    return samples;
}

void read_strips(TIFF* tiff, const RasterFacts& facts, const SampleScale& samples,
                 const RasterReceiver& receiver) {
    const std::size_t columns = static_cast<std::size_t>(facts.columns);
    const tmsize_t size = TIFFScanlineSize(tiff);
    if (size < static_cast<tmsize_t>(columns * samples.type.bytes()) ||
        static_cast<std::uint64_t>(size) > kMaxBufferBytes) {
        throw RasterFault("has rows of a size that does not fit its samples");
    }
    std::vector<std::byte> line(static_cast<std::size_t>(size));
    std::vector<float> row(columns);
    for (std::int64_t j = 0; j < facts.rows; ++j) {
        if (TIFFReadScanline(tiff, line.data(), static_cast<std::uint32_t>(j), 0) != 1) {
            throw failed("cannot be read in row " + std::to_string(j + 1));
        }
        for (std::size_t i = 0; i < columns; ++i) {
            row[i] = samples.height(&line[i * samples.type.bytes()]);
        }
        receiver.row(row);
    }
}

/// A row of tiles as heights.
class TileRow {
  public:
    TileRow(TIFF* tiff, const RasterFacts& facts, const SampleScale& samples)
        : tiff_(tiff), samples_(samples), columns_(static_cast<std::size_t>(facts.columns)) {
        width_ = tag_or<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0);
        height_ = tag_or<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0);
        const auto bytes = static_cast<std::uint64_t>(std::max<tmsize_t>(TIFFTileSize(tiff), 0));
        const bool whole = width_ > 0 && height_ > 0 && width_ <= (1u << 20) &&
                           height_ <= (1u << 20) &&
                           bytes == std::uint64_t{width_} * height_ * samples.type.bytes();
        if (!whole || bytes > kMaxBufferBytes ||
            std::uint64_t{height_} * columns_ * sizeof(float) > 4 * kMaxBufferBytes) {
            throw RasterFault("has tiles of a size that is not supported");
        }
        tile_.resize(static_cast<std::size_t>(bytes));
        heights_.resize(height_ * columns_);
    }

    std::uint32_t height() const { return height_; }
    std::span<const float> row(std::size_t j) const {
        return std::span(heights_).subspan(j * columns_, columns_);
    }

    /// Reads the tiles whose first row is `top`.
    void read(std::uint32_t top) {
        for (std::size_t left = 0; left < columns_; left += width_) {
            const std::uint32_t x = static_cast<std::uint32_t>(left);
            const std::uint32_t index = TIFFComputeTile(tiff_, x, top, 0, 0);
            const auto size = static_cast<tmsize_t>(tile_.size());
            if (TIFFReadEncodedTile(tiff_, index, tile_.data(), size) != size) {
                throw failed("cannot be read in the tile at row " + std::to_string(top + 1) +
                             ", column " + std::to_string(left + 1));
            }
            const std::size_t width = std::min<std::size_t>(width_, columns_ - left);
            for (std::size_t j = 0; j < height_; ++j) {
                for (std::size_t i = 0; i < width; ++i) {
                    heights_[j * columns_ + left + i] =
                        samples_.height(&tile_[(j * width_ + i) * samples_.type.bytes()]);
                }
            }
        }
    }

  private:
    TIFF* tiff_;
    const SampleScale& samples_;
    std::size_t columns_;
    std::size_t width_ = 0;
    std::uint32_t height_ = 0;
    std::vector<std::byte> tile_;
    std::vector<float> heights_;
};

void read_tiles(TIFF* tiff, const RasterFacts& facts, const SampleScale& samples,
                const RasterReceiver& receiver) {
    TileRow tiles(tiff, facts, samples);
    const auto rows = static_cast<std::uint32_t>(facts.rows);
    for (std::uint32_t top = 0; top < rows; top += tiles.height()) {
        tiles.read(top);
        for (std::uint32_t j = top; j < std::min(top + tiles.height(), rows); ++j) {
            receiver.row(tiles.row(j - top));
        }
    }
}

}  // namespace

void read_tiff(std::istream& stream, const RasterReceiver& receiver) {
    const File file = open(stream);
    TIFF* const tiff = file.get();
    RasterFacts facts;
    facts.columns = tag_or<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
    facts.rows = tag_or<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
    require_sides(facts.columns, facts.rows);
    require_readable(tiff);
    const SampleScale samples = sample_scale(tiff, facts);
    apply_geo_tags({.pixel_scale = list_tag<double>(tiff, kPixelScale),
                    .tie_points = list_tag<double>(tiff, kTiePoints),
                    .transformation = list_tag<double>(tiff, kTransformation),
                    .directory = list_tag<std::uint16_t>(tiff, kGeoDirectory),
                    .doubles = list_tag<double>(tiff, kGeoDoubles),
                    .texts = text_tag(tiff, kGeoTexts)},
                   facts);
    receiver.begin(facts);
    (TIFFIsTiled(tiff) != 0 ? read_tiles : read_strips)(tiff, facts, samples, receiver);
}

}  // namespace ocean::elevation
