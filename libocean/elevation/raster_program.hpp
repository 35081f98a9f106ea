// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The place of ocean-raster, which reads rasters by GDAL and is a package of its own.
#pragma once

#include <string>

namespace ocean::elevation {

/// Returns the path of ocean-raster beside this program, as in the folders of a build and of an
/// installation, else where libocean is installed; "" if it is in neither.
std::string raster_program();

}  // namespace ocean::elevation
