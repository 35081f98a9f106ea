// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Imports elevation models: see ocean/internal/elevation_import.hpp. Another process reads the file
// and sends rows; this process keeps them, and trusts none.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/child_process.hpp"
#include "ocean/internal/elevation_import.hpp"
#include "ocean/internal/elevation_rules.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/platform.hpp"
#include "raster.hpp"

namespace ocean {
namespace {

using elevation::ElevationReader;
using elevation::ForeignFormat;
using elevation::GridWindow;
using elevation::RasterFacts;
using elevation::RasterReceiver;
using elevation::RawModel;

/// The limits of a child, and of ocean-raster, which is larger itself.
constexpr sandbox::ChildLimits kLimits{.memory_bytes = std::uint64_t{2} << 30, .cpu_seconds = 600};

Error bad_file(const std::string& path, const std::string& message) {
    return text::error_at(ErrorKind::bad_file, path, 0, message);
}

Error wrong_option(const std::string& message) {
    return Error(ErrorKind::invalid_value, message);
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

    /// Returns a model of the facts without heights.
    RawModel raw_of(RasterFacts facts) const {
        require_size(facts);
        if (own_ && !facts.has_place) place_as_own(facts);
        require_options(facts);
        const std::array<double, 2> cell =
            request_.cell ? std::array{*request_.cell, *request_.cell} : facts.cell;
        RawModel raw;
        raw.is_geographic = facts.has_place ? facts.is_geographic : false;
        raw.metres_per_unit = facts.metres_per_unit;
        raw.ground_scale = facts.ground_scale;
        raw.height_unit = facts.height_unit;
        raw.sample_scale = facts.sample_scale;
        raw.has_shades = facts.full_scale > 0.0;
        raw.model.domain =
            elevation::make_domain(path_, facts.columns, facts.rows, facts.south_west_centre, cell);
        raw.model.crs = text::printable(facts.crs, 1000);
        raw.model.crs_definition = text::printable(facts.definition, 65536);
        for (const std::string& note : facts.notes) {
            raw.model.notes.push_back(text::printable(note, 300));
        }
        return raw;
    }

  private:
    void begin(const RasterFacts& facts) {
        raw_ = raw_of(facts);
        elevation::allocate_heights(raw_.model, path_);
        rows_from_south_ = facts.rows_from_south;
        if (request_.range) {
            lowest_ = (*request_.range)[0];
            per_step_ = ((*request_.range)[1] - lowest_) / facts.full_scale;
        }
    }

    void require_size(const RasterFacts& facts) const {
        const std::int64_t less = std::min(facts.columns, facts.rows);
        const std::int64_t more = std::max(facts.columns, facts.rows);
        if (less < kMinElevationSide) elevation::require_sides(path_, facts.columns, facts.rows);
        if (more <= kMaxElevationSide || request_.options.crop) return;
        throw bad_file(path_, "has " + std::to_string(facts.columns) + " x " +
                                  std::to_string(facts.rows) +
                                  " cells; allowed: 2 .. 65536 along each side; --crop "
                                  "WEST,SOUTH,EAST,NORTH keeps a part");
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
        const int j = rows_from_south_ ? next_row_ : rows - 1 - next_row_;
        float* const to = raw_.model.heights.data() + static_cast<std::size_t>(j) * row.size();
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
    bool rows_from_south_ = false;
    double lowest_ = 0.0;
    double per_step_ = 1.0;
    int next_row_ = 0;
};

/// Returns the path of ocean-raster beside this program, as in the folders of a build and of an
/// installation, else where libocean is installed; "" if it is in neither.
std::string raster_program() {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path self = fs::read_symlink("/proc/self/exe", ignored);
    for (const fs::path& program : {self.parent_path().parent_path() / OCEAN_RASTER_BESIDE,
                                    fs::path(OCEAN_RASTER_INSTALLED)}) {
        if (fs::is_regular_file(program, ignored)) return program.string();
    }
    return "";
}

/// Reads an EXR image in a child process.
void read_exr_in_child(const std::string& path, const RasterReceiver& receiver) {
    static_cast<void>(opened(path));
    const auto produce = [&](const sandbox::Sink& sink) {
        elevation::encode([&](const RasterReceiver& sender) { elevation::read_exr(path, sender); },
                          sink);
    };
    sandbox::run_in_child(kLimits, produce, [&](const sandbox::Source& source) {
        elevation::decode(source, receiver);
    });
}

/// Runs ocean-raster on a file.
void run_ocean_raster(const std::string& path, std::vector<std::string> request,
                      const std::function<void(const sandbox::Source&)>& consume) {
    static_cast<void>(opened(path));
    const std::filesystem::path file = std::filesystem::absolute(utf8_path(path));
    request.insert(request.begin(), {raster_program(), text::to_utf8(file)});
    sandbox::run_program(kLimits, request, consume);
}

/// Reads a raster by GDAL: all of it, or what the crop keeps.
void read_by_gdal(const std::string& path, const ElevationImport& request, ModelBuilder& builder) {
    std::vector<std::string> window;
    if (request.options.crop) {
        run_ocean_raster(path, {"facts"}, [&](const sandbox::Source& source) {
            const RawModel whole = builder.raw_of(elevation::decode_facts(source));
            const GridWindow kept = elevation::crop_window(whole, path, request.options);
            for (const std::int64_t number : {kept.west, kept.south, kept.columns, kept.rows}) {
                window.push_back(std::to_string(number));
            }
        });
    }
    run_ocean_raster(path, window, [&](const sandbox::Source& source) {
        elevation::decode(source, builder.receiver());
    });
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

ElevationModel read_foreign(const std::string& path, const ForeignFormat& format,
                            const ElevationImport& request) {
    const bool is_image = format.reader == ElevationReader::exr || format.name == "PNG";
    ModelBuilder builder(path, request, is_image ? own_domain(path) : std::nullopt);
    ElevationOptions options = request.options;
    try {
        if (format.reader == ElevationReader::hgt) {
            std::ifstream stream = opened(path);
            elevation::read_hgt(stream, std::filesystem::file_size(utf8_path(path)),
                                corner_of(path, request), builder.receiver());
        } else if (format.reader == ElevationReader::exr) {
            read_exr_in_child(path, builder.receiver());
        } else {
            read_by_gdal(path, request, builder);
            options.crop.reset();  // is done
        }
    } catch (const elevation::RasterFault& fault) {
        throw bad_file(path, fault.what());
    } catch (const sandbox::ChildFailure& failure) {
        const bool is_exr = format.reader == ElevationReader::exr;
        throw bad_file(path, std::string(is_exr ? "OpenEXR" : "ocean-raster") +
                                 " failed on this file: " + failure.what());
    }
    return elevation::finish(builder.take(), path, options);
}

}  // namespace

ElevationModel import_elevation(const std::string& path, const ElevationImport& request) {
    std::error_code ignored;
    const bool is_file = std::filesystem::is_regular_file(utf8_path(path), ignored);
    const ForeignFormat* const format = is_file ? elevation::foreign_format(path) : nullptr;
    const ElevationReader reader = format != nullptr ? format->reader : ElevationReader::library;
    if (request.corner && reader != ElevationReader::hgt) {
        throw wrong_option("--corner is for SRTM tiles (.hgt)");
    }
    if (reader == ElevationReader::ocean_raster && raster_program().empty()) {
        throw text::error_at(ErrorKind::unsupported, path, 0,
                             "is a file of the format " + std::string(format->name) +
                                 ", which ocean-raster reads; that program is not installed "
                                 "(Debian: ocean-terrain; sources: a build with libgdal-dev)");
    }
    if (reader != ElevationReader::library && reader != ElevationReader::gdal_translate) {
        return read_foreign(path, *format, request);
    }
    if (request.cell || request.range) {
        throw wrong_option("--cell and --range are for images, which state neither");
    }
    return read_elevation(path, request.options);
}

}  // namespace ocean
