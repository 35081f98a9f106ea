// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The georeference of a GeoTIFF: where its pixels lie, and in which system [OGC 19-008r4, "OGC
// GeoTIFF Standard", 1.1].
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "raster.hpp"

namespace ocean::elevation {

/// The values of the tags, empty where a file lacks one.
struct GeoTags {
    std::vector<double> pixel_scale;       // 33550
    std::vector<double> tie_points;        // 33922
    std::vector<double> transformation;    // 34264
    std::vector<std::uint16_t> directory;  // 34735
    std::vector<double> doubles;           // 34736
    std::string texts;                     // 34737
};

/// Sets place, system and units of the facts, whose columns and rows are known. Throws RasterFault
/// for a raster that is turned, or not in a plane.
void apply_geo_tags(const GeoTags& tags, RasterFacts& facts);

}  // namespace ocean::elevation
