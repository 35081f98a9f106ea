// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Heights by GDAL: see gdal_raster.hpp.
#include "gdal_raster.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "gdal_place.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/elevation_rules.hpp"
#include "ocean/text.hpp"

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

/// Returns true for shades, whose heights the user states.
bool is_image(GDALDatasetH dataset) {
    return has_driver(dataset, "PNG");
}

/// Reads whole numbers of either byte order.
class NumberStream {
  public:
    explicit NumberStream(const std::string& path) : file_(path, std::ios::binary) {
        is_big_endian_ = file_.get() == 'M';
        file_.seekg(2);
    }
    std::uint64_t next(int bytes) {
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) {
            const auto byte = static_cast<std::uint64_t>(file_.get() & 0xFF);
            value = is_big_endian_ ? value << 8 | byte : value | byte << 8 * i;
        }
        return value;
    }
    void seek(std::uint64_t offset) { file_.seekg(static_cast<std::streamoff>(offset)); }
    bool is_good() const { return file_.good(); }

  private:
    std::ifstream file_;
    bool is_big_endian_ = false;
};

/// Throws for a TIFF whose first row is not the upper one, which GDAL does not see [TIFF 6.0,
/// section 8, tag 274].
void require_upright(const std::string& path) {
    constexpr std::uint64_t kBigTiff = 43, kOrientation = 274;
    NumberStream file(path);
    const bool is_big = file.next(2) == kBigTiff;
    file.seek(is_big ? 8 : 4);
    file.seek(file.next(is_big ? 8 : 4));
    for (std::uint64_t left = file.next(is_big ? 8 : 2); left > 0 && file.is_good(); --left) {
        const std::uint64_t tag = file.next(2);
        file.next(is_big ? 10 : 6);  // type and count
        const std::uint64_t value = file.next(2);
        file.next(is_big ? 6 : 2);
        if (tag != kOrientation || value == 1) continue;
        throw RasterFault("has its first row elsewhere than on top; `gdalwarp` turns it");
    }
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
    if (is_image(dataset) && bits != nullptr) {
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

void add_notes(const SampleScale& samples, GDALRasterBandH band, RasterFacts& facts) {
    if (samples.scale != 1.0 || samples.offset != 0.0) {
        facts.notes.push_back("the file states that a height is " + shortest_text(samples.scale) +
                              " times its sample plus " + shortest_text(samples.offset));
    }
    if (facts.full_scale > 0.0 && GDALGetRasterDataType(band) == GDT_Byte) {
        facts.notes.push_back("the image has 8 bits: heights are in steps of 1/255 of the range");
    }
}

/// Returns the first line of a window in the file.
int first_line(GDALDatasetH dataset, const std::optional<GridWindow>& window,
               const RasterFacts& facts) {
    if (!window) return 0;
    const std::int64_t lines = GDALGetRasterYSize(dataset);
    return static_cast<int>(facts.rows_from_south ? window->south
                                                  : lines - window->south - window->rows);
}

/// Throws unless the path is absolute and that of a regular file which a driver reads.
Dataset open_raster(const std::string& path) {
    std::error_code ignored;
    const bool is_file = path.starts_with('/') && std::filesystem::is_regular_file(path, ignored);
    if (!is_file || path.starts_with("/vsi")) throw RasterFault("is no file");
    CPLErrorReset();
    Dataset dataset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_INTERNAL,
                               nullptr, nullptr, nullptr));
    if (dataset) {
        if (has_driver(dataset.get(), "GTiff")) require_upright(path);
        return dataset;
    }
    if (std::string_view(CPLGetLastErrorMsg()).find("not recognized as") !=
        std::string_view::npos) {
        throw RasterFault("is not a whole file of its format");
    }
    throw failed("is not a whole file of its format");
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
    if (is_image(dataset)) {
        facts.full_scale = GDALGetRasterDataType(band) == GDT_UInt16 ? 65535.0 : 255.0;
    }
    add_notes(sample_scale(band), band, facts);
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
    const int top = first_line(dataset, window, facts);
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

}  // namespace

void start_gdal() {
    // PROJ reads the folder of a user before its own: /tmp/proj where there is no user's.
    ::setenv("PROJ_SKIP_READ_USER_WRITABLE_DIRECTORY", "YES", 1);
    CPLSetErrorHandler(CPLQuietErrorHandler);
    for (const auto& [key, value] :
         {std::pair{"GDAL_DRIVER_PATH", "disable"}, std::pair{"OGR_DRIVER_PATH", "disable"},
          std::pair{"GDAL_CONFIG_FILE", ""}, std::pair{"GDAL_NUM_THREADS", "1"},
          std::pair{"GDAL_DISABLE_READDIR_ON_OPEN", "TRUE"},
          std::pair{"CPL_VSIL_CURL_ALLOWED_EXTENSIONS", "none"},
          std::pair{"CPL_TMPDIR", "/nonexistent"}}) {
        CPLSetConfigOption(key, value);
    }
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

void read_gdal(const std::string& path, const RasterRequest& request,
               const RasterReceiver& receiver) {
    const Dataset dataset = open_raster(path);
    const RasterFacts facts = facts_of(dataset.get(), request.window);
    receiver.begin(facts);
    if (!request.facts_alone) send_rows(dataset.get(), request.window, facts, receiver);
}

}  // namespace ocean::elevation
