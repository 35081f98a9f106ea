// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The rules that the readers of elevation models share: units, degrees, holes and limits.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/elevation_file.hpp"

namespace ocean::elevation {

/// The value that a file declares for missing heights. Cells may hold it with less precision than
/// the header: as floats, or as texts with fewer digits.
struct MissingMark {
    double value = -9999.0;  // ESRI's default
    double rounding = 0.0;   // of the header's word, see rounding_of()

    /// Returns true if a height equals the mark: both are the same float, or one is the other,
    /// rounded to the digits of its word.
    bool matches(double height, std::string_view word = {}) const;
};

/// Returns half of the last decimal place of a number's word if it has six significant digits or
/// more, the default of programs that round; 0 for a shorter word, which is exact.
double rounding_of(std::string_view word);

/// A part of a grid, counted in cells from the south-west.
struct GridWindow {
    std::int64_t west;
    std::int64_t south;
    std::int64_t columns;
    std::int64_t rows;
};

/// The part of this program, or the other program, that reads an elevation model.
enum class ElevationReader {
    library,  // read_elevation()
    hgt,      // the rest by `ocean terrain import`
    exr,
    ocean_raster,
    gdal_translate,  // by hand
};
/// A format that read_elevation() refuses: its name, and how a file of it begins or is named.
struct ForeignFormat {
    std::string_view name;
    std::array<std::string_view, 4> first_bytes;
    std::array<std::string_view, 3> extensions;
    ElevationReader reader;
};
/// Returns the format of an existing file; nullptr for a format that read_elevation() reads and for
/// an unknown one.
const ForeignFormat* foreign_format(const std::string& path);

/// A model as in its file: domain and heights in the file's units, holes as NaN.
struct RawModel {
    ElevationModel model;
    std::optional<bool> is_geographic = {};  // cells of degrees; unset if the file is silent
    double metres_per_unit = 1.0;            // of the horizontal coordinates
    /// The length of a cell on the ground for its length on the map, to the east and to the north,
    /// at the map's centre.
    std::array<double, 2> ground_scale = {1.0, 1.0};
    std::optional<double> height_unit = {};           // as stated in the file [m]
    std::array<double, 2> sample_scale = {1.0, 0.0};  // a height is s[0] times its sample plus s[1]
    bool has_shades = false;                          // an image, whose heights the user stated
    std::string hint = {};  // appended to the error of a height out of range
};

/// Returns a domain in the file's units. Throws Error bad_file, with `name`, for cells that are not
/// positive and coordinates beyond 1e9.
Domain make_domain(const std::string& name, std::int64_t columns, std::int64_t rows,
                   const std::array<double, 2>& south_west_centre,
                   const std::array<double, 2>& cell);
/// Gives a model the heights of its domain. Throws as require_sides; out_of_memory if they exceed
/// the available memory.
void allocate_heights(ElevationModel& model, const std::string& name);
/// Throws Error bad_file for a side outside kMinElevationSide .. kMaxElevationSide.
void require_sides(const std::string& name, std::int64_t columns, std::int64_t rows);

/// Returns true for a value that marks a missing height: NaN, or a magnitude of at least 1e30.
bool is_fill_value(double value);

/// Returns the cells of a model that options.crop keeps. Reads no heights. Throws Error
/// invalid_value for fewer than 2 x 2 cells.
GridWindow crop_window(const RawModel& raw, const std::string& name,
                       const ElevationOptions& options);

/// Returns the model in metres with the options applied, and a note for each assumption. Throws
/// Error bad_file, with `name`, for a height beyond kMaxElevation, cells of degrees beyond a pole,
/// a model without any height, and holes that options.holes refuses.
ElevationModel finish(RawModel raw, const std::string& name, const ElevationOptions& options);

/// Applies the policy to the holes of a model. Throws Error bad_file, with `name`, for a model
/// without any height, and for holes that are refused.
void apply_holes(ElevationModel& model, const std::string& name, HolePolicy policy);

/// Returns the text of the .prj file beside `path`, as one line; "" without one.
std::string read_projection(const std::string& path);
/// Returns the name of a system: "EPSG:26911", the name in a definition, or the text itself; "" if
/// it is unknown.
std::string crs_name(const std::string& crs);
/// Returns the reference system of a local system that write_elevation named after it: "EPSG:2193",
/// or "" for an unknown one. Returns other texts unchanged.
std::string without_local_names(const std::string& crs);
/// Returns true for a system of degrees, false for one of lengths, nothing for an unknown text.
std::optional<bool> is_geographic(const std::string& crs);
/// Returns true for a definition of Mercator's map, which stretches the ground: twice at 60
/// degrees.
bool is_mercator(const std::string& crs);
/// Returns the length [m] of the unit of a projected system; 1 if the text names none.
double metres_per_unit(const std::string& crs);

}  // namespace ocean::elevation
