// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The elevation model that is the base of a terrain.
#pragma once

#include <string>

#include "ocean/internal/elevation.hpp"
#include "ocean/internal/measured_rings.hpp"

namespace ocean {

/// An elevation model as the base of a land.
struct TerrainBase {
    ElevationModel model;  // without holes; its origin is that of its own system
    MeasuredRings rings;   // its spectrum
    std::string hash;      // SHA-256 of samples and heights, in hexadecimal
};

}  // namespace ocean
