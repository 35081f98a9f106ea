// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Imports elevation models: see ocean/internal/elevation_import.hpp. A child process reads the file
// and sends rows; this process keeps them, and trusts none.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "hgt_raster.hpp"
#include "image_raster.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/child_process.hpp"
#include "ocean/internal/elevation_import.hpp"
#include "ocean/internal/elevation_rules.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/io/read_provenance.hpp"
#include "ocean/text.hpp"
#include "raster.hpp"
#include "raster_wire.hpp"
#ifdef OCEAN_HAVE_TIFF
#include "tiff_raster.hpp"
#endif

namespace ocean {
namespace {

using namespace std::string_view_literals;
using elevation::RasterFacts;
using elevation::RasterReceiver;
using elevation::RawModel;

enum class RasterFormat { none, tiff, png, exr, hgt };

Error bad_file(const std::string& path, const std::string& message) {
    return text::error_at(ErrorKind::bad_file, path, 0, message);
}

Error wrong_option(const std::string& message) {
    return Error(ErrorKind::invalid_value, message);
}

RasterFormat format_of(const std::string& path) {
    const std::string first = text::first_bytes(path, 8);
    for (const std::string_view magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
        if (first.starts_with(magic)) return RasterFormat::tiff;
    }
    if (first.starts_with("\x89PNG\r\n\x1a\n"sv)) return RasterFormat::png;
    if (first.starts_with("\x76\x2f\x31\x01"sv)) return RasterFormat::exr;
    std::string extension = text::to_utf8(utf8_path(path).extension());
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    });
    if (extension == ".hgt") return RasterFormat::hgt;
    if (extension == ".tif" || extension == ".tiff") throw bad_file(path, "is not a TIFF file");
    if (extension == ".png") throw bad_file(path, "is not a PNG file");
    if (extension == ".exr") throw bad_file(path, "is not an EXR file");
    return RasterFormat::none;
}

std::string_view library_of(RasterFormat format) {
    switch (format) {
        case RasterFormat::tiff:
            return "libtiff";
        case RasterFormat::png:
            return "libpng";
        case RasterFormat::exr:
            return "OpenEXR";
        case RasterFormat::hgt:
        case RasterFormat::none:
            break;
    }
    return "the reader";
}

std::ifstream opened(const std::string& path) {
    std::ifstream stream(utf8_path(path), std::ios::binary);
    if (!stream) throw bad_file(path, "cannot be read: no permission");
    return stream;
}

std::array<double, 2> corner_of(const std::string& path, const ElevationImport& request) {
    if (request.corner) return *request.corner;
    const std::string name = text::to_utf8(utf8_path(path).filename());
    if (const auto corner = corner_of_name(name)) return *corner;
    throw wrong_option(text::printable(path, 200) +
                       ": the name of an SRTM tile gives its corner, as N34W119.hgt does; rename "
                       "the file, or state --corner N34W119");
}

/// Runs in the child process.
void read_raster(const std::string& path, RasterFormat format, std::istream& stream,
                 const RasterReceiver& receiver) {
    switch (format) {
        case RasterFormat::tiff:
#ifdef OCEAN_HAVE_TIFF
            return elevation::read_tiff(stream, receiver);
#else
            break;
#endif
        case RasterFormat::png:
            return elevation::read_png(stream, receiver);
        case RasterFormat::exr:
            return elevation::read_exr(path, receiver);
        case RasterFormat::hgt:
        case RasterFormat::none:
            break;
    }
}

/// Collects rows as a model.
class ModelBuilder {
  public:
    /// `own` is the domain of a file that libocean wrote.
    ModelBuilder(const std::string& path, const ElevationImport& request,
                 const std::optional<Domain>& own)
        : path_(path), request_(request), own_(own) {}

    RasterReceiver receiver() {
        return {.begin = [this](const RasterFacts& facts) { begin(facts); },
                .row = [this](std::span<const float> row) { add(row); }};
    }

    RawModel take() { return std::move(raw_); }

  private:
    void begin(RasterFacts facts) {
        if (own_ && !facts.has_place) place_as_own(facts);
        require_options(facts);
        const std::array<double, 2> cell =
            request_.cell ? std::array{*request_.cell, *request_.cell} : facts.cell;
        raw_.model =
            elevation::make_model(path_, facts.columns, facts.rows, facts.south_west_centre, cell);
        raw_.model.crs = text::printable(facts.crs, 1000);
        for (const std::string& note : facts.notes) {
            raw_.model.notes.push_back(text::printable(note, 300));
        }
        raw_.is_geographic = facts.is_geographic;
        if (!facts.has_place) raw_.is_geographic = false;
        raw_.metres_per_unit = facts.metres_per_unit;
        raw_.height_unit = facts.height_unit;
        raw_.has_shades = facts.full_scale > 0.0;
        if (request_.range) {
            lowest_ = (*request_.range)[0];
            per_step_ = ((*request_.range)[1] - lowest_) / facts.full_scale;
        }
    }

    void place_as_own(RasterFacts& facts) const {
        Domain domain = *own_;
        domain.samples = {static_cast<int>(facts.columns), static_cast<int>(facts.rows)};
        facts.has_place = true;
        facts.south_west_centre = domain.origin;
        facts.cell = {domain.step(0), domain.step(1)};
        facts.is_geographic = false;
        facts.notes.push_back("cell and origin are those that libocean wrote into the file");
    }

    void require_options(const RasterFacts& facts) const {
        const std::string name = text::printable(path_, 200);
        if (request_.cell && facts.has_place) {
            throw wrong_option("--cell: " + name + " states the size of its cells itself");
        }
        if (!request_.cell && !facts.has_place) {
            throw wrong_option(name + " does not state the size of its cells; --cell METRES does");
        }
        const bool is_image = facts.full_scale > 0.0;
        if (request_.range && !is_image) {
            throw wrong_option("--range: the samples of " + name + " are heights themselves");
        }
        if (!request_.range && is_image) {
            throw wrong_option(name +
                               " has shades, not heights; --range LOWEST,HIGHEST states the "
                               "heights of black and white");
        }
    }

    void add(std::span<const float> row) {
        const int rows = raw_.model.domain.samples[1];
        float* const to =
            raw_.model.heights.data() + static_cast<std::size_t>(rows - 1 - next_row_) * row.size();
        std::ranges::transform(row, to, [&](float sample) {
            if (elevation::is_fill_value(double{sample})) return std::nanf("");
            return static_cast<float>(lowest_ + per_step_ * double{sample});
        });
        if (request_.options.progress && next_row_ % 64 == 0) {
            request_.options.progress(next_row_, rows);
        }
        ++next_row_;
    }

    const std::string& path_;
    const ElevationImport& request_;
    std::optional<Domain> own_;
    RawModel raw_;
    double lowest_ = 0.0;
    double per_step_ = 1.0;
    int next_row_ = 0;
};

/// Reads a raster by a library, in a child process.
void read_in_child(const std::string& path, RasterFormat format, const RasterReceiver& receiver) {
    constexpr sandbox::ChildLimits kLimits{.memory_bytes = std::uint64_t{2} << 30,
                                           .cpu_seconds = 600};
    std::ifstream stream = opened(path);
    const auto produce = [&](const sandbox::Sink& sink) {
        elevation::encode(
            [&](const RasterReceiver& sender) { read_raster(path, format, stream, sender); }, sink);
    };
    try {
        sandbox::run_in_child(kLimits, produce, [&](const sandbox::Source& source) {
            elevation::decode(source, receiver);
        });
    } catch (const sandbox::ChildFailure& failure) {
        throw bad_file(path,
                       std::string(library_of(format)) + " failed on this file: " + failure.what());
    }
}

/// Returns the domain of a file that libocean baked, which states no georeference of GIS programs.
std::optional<Domain> own_domain(const std::string& path) {
    try {
        const auto provenance = io::read_provenance(path);
        if (provenance) return provenance->domain;
    } catch (const Error&) {
        // Another program's image.
    }
    return std::nullopt;
}

RawModel read_raw(const std::string& path, RasterFormat format, const ElevationImport& request) {
    const bool is_image = format == RasterFormat::exr || format == RasterFormat::png;
    ModelBuilder builder(path, request, is_image ? own_domain(path) : std::nullopt);
    try {
        if (format == RasterFormat::hgt) {
            std::ifstream stream = opened(path);
            elevation::read_hgt(stream, std::filesystem::file_size(utf8_path(path)),
                                corner_of(path, request), builder.receiver());
        } else {
            read_in_child(path, format, builder.receiver());
        }
    } catch (const elevation::RasterFault& fault) {
        throw bad_file(path, fault.what());
    }
    return builder.take();
}

/// Keeps the cells whose centres lie within the edges.
void crop(ElevationModel& model, const std::array<double, 4>& edges) {
    const Domain whole = model.domain;
    std::array<int, 2> first{}, last{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double step = whole.step(axis);
        const double low = (edges[axis] - whole.origin[axis]) / step;
        const double high = (edges[axis + 2] - whole.origin[axis]) / step;
        const double end = whole.samples[axis] - 1;
        first[axis] = static_cast<int>(std::ceil(std::clamp(low, 0.0, end + 1.0)));
        last[axis] = static_cast<int>(std::floor(std::clamp(high, -1.0, end)));
        if (last[axis] - first[axis] + 1 < kMinElevationSide) {
            throw wrong_option("--crop leaves fewer than 2 x 2 cells; the centres lie within " +
                               plain_text(whole.origin[0]) + "," + plain_text(whole.origin[1]) +
                               "," + plain_text(whole.origin[0] + whole.size[0]) + "," +
                               plain_text(whole.origin[1] + whole.size[1]));
        }
    }
    const std::size_t columns = static_cast<std::size_t>(last[0] - first[0] + 1);
    PageVector<float> kept;
    kept.reserve(columns * static_cast<std::size_t>(last[1] - first[1] + 1));
    for (int j = first[1]; j <= last[1]; ++j) {
        const float* const row =
            model.heights.data() +
            static_cast<std::size_t>(j) * static_cast<std::size_t>(whole.samples[0]) +
            static_cast<std::size_t>(first[0]);
        kept.insert(kept.end(), row, row + columns);
    }
    model.heights = std::move(kept);
    model.domain = {
        .origin = whole.place(first[0], first[1]),
        .size = {whole.step(0) * (last[0] - first[0]), whole.step(1) * (last[1] - first[1])},
        .samples = {last[0] - first[0] + 1, last[1] - first[1] + 1},
        .wraps = false};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        model.geographic_origin[axis] += model.geographic_cell[axis] * first[axis];
    }
}

}  // namespace

ElevationModel import_elevation(const std::string& path, const ElevationImport& request) {
    std::error_code ignored;
    const bool is_file = std::filesystem::is_regular_file(utf8_path(path), ignored);
    const RasterFormat format = is_file ? format_of(path) : RasterFormat::none;
    if (request.corner && format != RasterFormat::hgt) {
        throw wrong_option("--corner is for SRTM tiles (.hgt)");
    }
#ifndef OCEAN_HAVE_TIFF
    if (format == RasterFormat::tiff) {
        throw Error(ErrorKind::unsupported,
                    path + ": is a TIFF file, and this program was built without libtiff");
    }
#endif
    ElevationOptions options = request.options;
    if (request.crop) options.holes = HolePolicy::keep;
    ElevationModel model;
    if (format == RasterFormat::none) {
        if (request.cell || request.range) {
            throw wrong_option("--cell and --range are for images, which state neither");
        }
        model = read_elevation(path, options);
    } else {
        model = elevation::finish(read_raw(path, format, request), path, options);
    }
    if (!request.crop) return model;
    crop(model, *request.crop);
    elevation::apply_holes(model, path, request.options.holes);
    return model;
}

}  // namespace ocean
