// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads rasters by GDAL, in the calling process: that of ocean-raster, a program of its own,
// because GDAL is neither small nor safe against hostile files.
#pragma once

#include <optional>
#include <string>

#include "raster.hpp"

namespace ocean::elevation {

/// Registers GDAL's drivers of elevation models, no others, and switches networks, threads, plugins
/// and files of configuration off. Is called once, before all else.
void start_gdal();

struct RasterRequest {
    bool facts_alone = false;
    std::optional<GridWindow> window = {};  // default: all cells
};

/// Sends facts and, unless facts alone are requested, rows. Throws RasterFault unless the path is
/// absolute and that of a regular file, which a registered driver reads as one band of heights.
void read_gdal(const std::string& path, const RasterRequest& request,
               const RasterReceiver& receiver);

}  // namespace ocean::elevation
