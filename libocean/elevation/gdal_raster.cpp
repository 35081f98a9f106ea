// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The work of ocean-raster, heights by GDAL: see ocean/internal/send_raster.hpp.
#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>
#ifdef OCEAN_HAVE_TIFF
#include <tiffio.h>
#endif

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <string_view>
#include <system_error>

#include "gdal_place.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/elevation_rules.hpp"
#include "ocean/internal/send_raster.hpp"
#include "ocean/internal/text.hpp"
#include "raster.hpp"

namespace ocean::elevation {
namespace {

struct DatasetCloser {
    void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, DatasetCloser>;

/// Returns a fault with GDAL's last message.
RasterFault failed(const std::string& action) {
    const std::string why = text::printable(CPLGetLastErrorMsg(), 200);
    return RasterFault(action + (why.empty() ? "" : ": " + why));
}

bool has_driver(GDALDatasetH dataset, std::string_view name) {
    return GDALGetDriverShortName(GDALGetDatasetDriver(dataset)) == name;
}

/// Throws for a TIFF whose first row is not the upper one, which GDAL does not see.
void require_upright([[maybe_unused]] const std::string& path) {
#ifdef OCEAN_HAVE_TIFF
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    TIFF* const tiff = TIFFOpen(path.c_str(), "rm");
    if (tiff == nullptr) return;
    std::uint16_t orientation = ORIENTATION_TOPLEFT;
    TIFFGetField(tiff, TIFFTAG_ORIENTATION, &orientation);
    TIFFClose(tiff);
    if (orientation == ORIENTATION_TOPLEFT) return;
    throw RasterFault("has its first row elsewhere than on top; `gdalwarp` turns it");
#endif
}

/// Returns the band of heights.
GDALRasterBandH height_band(GDALDatasetH dataset) {
    const int bands = GDALGetRasterCount(dataset);
    const bool has_alpha = bands == 2 && GDALGetRasterColorInterpretation(
                                             GDALGetRasterBand(dataset, 2)) == GCI_AlphaBand;
    if (bands != 1 && !has_alpha) {
        throw RasterFault("has " + std::to_string(bands) +
                          " bands; heights are one band (`gdal_translate -b 1` takes the first)");
    }
    const GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    if (GDALGetRasterColorTable(band) != nullptr) {
        throw RasterFault("is a picture with a palette, not heights");
    }
    const GDALDataType type = GDALGetRasterDataType(band);
    if (GDALDataTypeIsComplex(type) != 0) {
        throw RasterFault(std::string("has samples of the type ") + GDALGetDataTypeName(type) +
                          "; heights are integers or floats");
    }
    const char* const bits = GDALGetMetadataItem(band, "NBITS", "IMAGE_STRUCTURE");
    if (has_driver(dataset, "PNG") && bits != nullptr) {
        throw RasterFault(std::string("has ") + bits + " bits a pixel; allowed are 8 and 16");
    }
    return band;
}

/// Turns samples into heights.
struct SampleScale {
    std::optional<MissingMark> missing;
    double scale = 1.0;
    double offset = 0.0;
    bool is_signed_byte = false;  // GDAL before 3.7 gives 0 .. 255

    float height(double sample) const {
        if (is_signed_byte && sample > 127.0) sample -= 256.0;
        if (is_fill_value(sample) || (missing && missing->matches(sample))) {
            return std::numeric_limits<float>::quiet_NaN();
        }
        return static_cast<float>(scale * sample + offset);
    }
};

std::optional<MissingMark> missing_mark(GDALRasterBandH band) {
    int is_given = 0;
    const GDALDataType type = GDALGetRasterDataType(band);
    const double value =
        type == GDT_Int64 ? static_cast<double>(GDALGetRasterNoDataValueAsInt64(band, &is_given))
        : type == GDT_UInt64
            ? static_cast<double>(GDALGetRasterNoDataValueAsUInt64(band, &is_given))
            : GDALGetRasterNoDataValue(band, &is_given);
    if (is_given != 0) return MissingMark{value, rounding_of(shortest_text(value))};
    if (type == GDT_Int16) return MissingMark{-32768.0};
    return std::nullopt;
}

SampleScale sample_scale(GDALRasterBandH band) {
    const double scale = GDALGetRasterScale(band, nullptr);
    const double offset = GDALGetRasterOffset(band, nullptr);
    const char* const type = GDALGetMetadataItem(band, "PIXELTYPE", "IMAGE_STRUCTURE");
    return {.missing = missing_mark(band),
            .scale = is_fill_value(scale) ? 1.0 : scale,
            .offset = is_fill_value(offset) ? 0.0 : offset,
            .is_signed_byte = type != nullptr && type == std::string_view("SIGNEDBYTE")};
}

/// Returns the band whose zeros are holes, if the raster has one: a mask or alpha.
GDALRasterBandH mask_band(GDALDatasetH dataset, GDALRasterBandH band) {
    if (GDALGetRasterCount(dataset) == 2) return GDALGetRasterBand(dataset, 2);
    return (GDALGetMaskFlags(band) & GMF_PER_DATASET) != 0 ? GDALGetMaskBand(band) : nullptr;
}

/// Lets the cache hold the blocks that a row of the raster crosses, so that none is unpacked twice.
void set_cache(GDALRasterBandH band) {
    constexpr std::int64_t kLeast = std::int64_t{64} << 20, kMost = std::int64_t{1} << 30;
    int width = 0, height = 0;
    GDALGetBlockSize(band, &width, &height);
    const std::int64_t bytes = std::int64_t{GDALGetRasterBandXSize(band) + width} * height *
                               (GDALGetDataTypeSizeBytes(GDALGetRasterDataType(band)) + 1);
    GDALSetCacheMax64(std::clamp(2 * bytes, kLeast, kMost));
}

/// Throws unless the path is absolute and that of a regular file which a driver reads.
Dataset open_raster(const std::string& path) {
    std::error_code ignored;
    const bool is_file = path.starts_with('/') && std::filesystem::is_regular_file(path, ignored);
    if (!is_file || path.starts_with("/vsi")) throw RasterFault("is no file");
    CPLErrorReset();
    Dataset dataset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_INTERNAL,
                               nullptr, nullptr, nullptr));
    if (!dataset) {
        // GDAL's own words for a file that no driver knows are longer and have its path.
        if (std::strstr(CPLGetLastErrorMsg(), "not recognized as") != nullptr) CPLErrorReset();
        throw failed("is not a whole file of its format");
    }
    if (has_driver(dataset.get(), "GTiff")) require_upright(path);
    return dataset;
}

/// Returns the facts of a raster, or of a window of it.
RasterFacts facts_of(GDALDatasetH dataset, const std::optional<GridWindow>& window) {
    const GDALRasterBandH band = height_band(dataset);
    const std::int64_t columns = GDALGetRasterXSize(dataset), rows = GDALGetRasterYSize(dataset);
    RasterFacts facts;
    facts.columns = window ? window->columns : columns;
    facts.rows = window ? window->rows : rows;
    if (window && (window->west < 0 || window->south < 0 || facts.columns < 1 || facts.rows < 1 ||
                   window->west > columns - facts.columns || window->south > rows - facts.rows)) {
        throw RasterFault("has " + std::to_string(columns) + " x " + std::to_string(rows) +
                          " cells, and not the window");
    }
    set_place(dataset, window, facts);
    const bool is_byte = GDALGetRasterDataType(band) == GDT_Byte;
    if (has_driver(dataset, "PNG")) {  // shades, whose heights the user states
        facts.full_scale = is_byte ? 255.0 : 65535.0;
        if (is_byte)
            facts.notes.push_back(
                "the image has 8 bits: heights are in steps of 1/255 of the range");
    }
    const SampleScale samples = sample_scale(band);
    facts.sample_scale = {samples.scale, samples.offset};
    if (samples.scale != 1.0 || samples.offset != 0.0) {
        facts.notes.push_back("the file states that a height is " + shortest_text(samples.scale) +
                              " times its sample plus " + shortest_text(samples.offset));
    }
    return facts;
}

/// Sends the rows of a window in the order of the file.
void send_rows(GDALDatasetH dataset, const std::optional<GridWindow>& window,
               const RasterFacts& facts, const RasterReceiver& receiver) {
    const GDALRasterBandH band = height_band(dataset);
    const GDALRasterBandH mask = mask_band(dataset, band);
    const SampleScale samples = sample_scale(band);
    set_cache(band);
    const int west = window ? static_cast<int>(window->west) : 0;
    const std::int64_t south = window ? window->south : 0;
    const std::int64_t north = GDALGetRasterYSize(dataset) - south - facts.rows;
    const int top = static_cast<int>(facts.rows_from_south ? south : north);
    const int columns = static_cast<int>(facts.columns);
    std::vector<double> line(static_cast<std::size_t>(columns));
    std::vector<std::uint8_t> known(line.size(), 255);
    std::vector<float> row(line.size());
    const auto read = [&](GDALRasterBandH from, int y, void* to, GDALDataType type) {
        return GDALRasterIO(from, GF_Read, west, y, columns, 1, to, columns, 1, type, 0, 0) ==
               CE_None;
    };
    for (int j = 0; j < facts.rows; ++j) {
        CPLErrorReset();
        if (!read(band, top + j, line.data(), GDT_Float64) ||
            (mask != nullptr && !read(mask, top + j, known.data(), GDT_Byte))) {
            throw failed("cannot be read in row " + std::to_string(top + j + 1));
        }
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] =
                known[i] == 0 ? std::numeric_limits<float>::quiet_NaN() : samples.height(line[i]);
        }
        receiver.row(row);
    }
}

/// Registers the drivers of elevation models, no others, and switches networks, threads, plugins
/// and files of configuration off.
void start_gdal() {
    // PROJ reads the folder of a user before its own: /tmp/proj where there is no user's.
    ::setenv("PROJ_SKIP_READ_USER_WRITABLE_DIRECTORY", "YES", 1);
    CPLSetErrorHandler(CPLQuietErrorHandler);
    constexpr const char* kOptions[][2] = {{"GDAL_DRIVER_PATH", "disable"},
                                           {"OGR_DRIVER_PATH", "disable"},
                                           {"GDAL_CONFIG_FILE", ""},
                                           {"GDAL_NUM_THREADS", "1"},
                                           {"GDAL_DISABLE_READDIR_ON_OPEN", "TRUE"},
                                           {"CPL_VSIL_CURL_ALLOWED_EXTENSIONS", "none"}};
    for (const auto& [key, value] : kOptions) CPLSetConfigOption(key, value);
    OSRSetPROJEnableNetwork(0);
    GDALRegister_GTiff();
    GDALRegister_PNG();
    GDALRegister_ENVI();
    GDALRegister_GSAG();
    GDALRegister_GSBG();
    GDALRegister_GS7BG();
    GDALRegister_DTED();
    GDALRegister_USGSDEM();
}

/// Returns the window that four arguments say.
GridWindow window_of(std::span<const char* const> words) {
    std::int64_t numbers[4] = {};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string_view word = words[i];
        const auto [stop, error] = std::from_chars(word.begin(), word.end(), numbers[i]);
        if (error != std::errc() || stop != word.end()) throw RasterFault("is asked for no window");
    }
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

void read_raster(std::span<const char* const> arguments, const RasterReceiver& receiver) {
    std::optional<GridWindow> window;
    if (arguments.size() == 5) window = window_of(arguments.subspan(1));
    start_gdal();
    const Dataset dataset = open_raster(arguments[0]);
    const RasterFacts facts = facts_of(dataset.get(), window);
    receiver.begin(facts);
    if (arguments.size() != 2) send_rows(dataset.get(), window, facts, receiver);
}

}  // namespace
}  // namespace ocean::elevation

int ocean::send_raster(std::span<const char* const> arguments) {
    if (arguments.size() != 1 && arguments.size() != 2 && arguments.size() != 5) {
        std::fputs("ocean-raster is a part of `ocean terrain import`\n", stderr);
        return 2;
    }
    bool is_whole = true;
    elevation::encode([&](const auto& receiver) { elevation::read_raster(arguments, receiver); },
                      [&](const void* bytes, std::size_t size) {
                          is_whole = std::fwrite(bytes, 1, size, stdout) == size && is_whole;
                      });
    return std::fflush(stdout) == 0 && is_whole ? 0 : 1;
}
