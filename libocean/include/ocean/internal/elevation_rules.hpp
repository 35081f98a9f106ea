// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The rules that the readers of elevation models share: units, degrees, holes and limits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ocean/elevation_file.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::elevation {

/// A model as its file has it: the domain in the file's units, heights in its unit with NaN as
/// holes.
struct RawModel {
    ElevationModel model;
    std::optional<bool> is_geographic = {};      // cells of degrees; unset if the file is silent
    double metres_per_unit = 1.0;                // of the horizontal coordinates
    std::optional<HeightUnit> height_unit = {};  // as the file states
    bool has_shades = false;                     // an image's, whose heights the user stated
    std::string hint = {};                       // appended to the error of a height out of range
};

/// Returns a model whose domain is in the file's units. Throws Error bad_file, with `name`, for a
/// side outside kMinElevationSide .. kMaxElevationSide, cells that are not positive or coordinates
/// beyond 1e9; out_of_memory if the heights exceed the available memory. Allocates the heights.
ElevationModel make_model(const std::string& name, std::int64_t columns, std::int64_t rows,
                          const std::array<double, 2>& south_west_centre,
                          const std::array<double, 2>& cell);
/// Throws as make_model for sides, before anything else is known.
void require_sides(const std::string& name, std::int64_t columns, std::int64_t rows);

/// Returns true for a value that no file means as a height: NaN, or a magnitude of at least 1e30,
/// by which programs fill what is missing.
bool is_fill_value(double value);

/// Returns the model in metres with the options applied, and a note for each assumption. Throws
/// Error bad_file, with `name`, for a height beyond kMaxElevation, cells of degrees beyond a pole,
/// a model of holes alone, and holes that options.holes refuses.
ElevationModel finish(RawModel raw, const std::string& name, const ElevationOptions& options);

/// Applies the policy to the holes of a model. Throws Error bad_file, with `name`, for a model of
/// holes alone, and for holes that are refused.
void apply_holes(ElevationModel& model, const std::string& name, HolePolicy policy);

/// Returns the text of the .prj file beside `path`, as one line; "" without one.
std::string read_projection(const std::string& path);
/// Returns the name of a system: "EPSG:26911", the name in a definition, or the text itself; "" if
/// it is unknown.
std::string crs_name(const std::string& crs);
/// Returns the system that write_elevation names in a local one, "EPSG:2193" or "" for an unknown
/// one; other texts as they are.
std::string without_local_names(const std::string& crs);
/// Returns true for a system of degrees, false for one of lengths, nothing for an unknown text.
std::optional<bool> is_geographic(const std::string& crs);
/// Returns the length [m] of the unit of a projected system; 1 if the text names none.
double metres_per_unit(const std::string& crs);

}  // namespace ocean::elevation
