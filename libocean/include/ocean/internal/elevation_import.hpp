// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Imports elevation models from the formats of other programs: SRTM (.hgt), OpenEXR, the formats of
// read_elevation(), and by GDAL GeoTIFF, grey PNG and others. Foreign libraries read files in a
// process of their own, because they are not safe against hostile files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "ocean/internal/elevation_file.hpp"

namespace ocean {

struct ElevationImport {
    ElevationOptions options;
    std::optional<double> cell = {};                   // of files that do not state it [m]
    std::optional<std::array<double, 2>> range = {};   // heights of black and white [m]
    std::optional<std::array<double, 2>> corner = {};  // of .hgt [degrees east, degrees north]
};

/// Returns the model of a file, recognised by its content, and .hgt by its name. Throws as
/// read_elevation; Error invalid_value for a missing option that the file needs and for an option
/// without a use; unsupported if the format needs the program ocean-raster, which is not installed.
ElevationModel import_elevation(const std::string& path, const ElevationImport& request);

/// Reads the corner of an SRTM tile from its name: "N34W119" at the start of a file's name. Returns
/// degrees east and north, or nothing.
std::optional<std::array<double, 2>> corner_of_name(std::string_view name);

}  // namespace ocean
