// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A bed as land for the renderer: the texels of its ground and of its sand.
#pragma once

#include <cstdint>
#include <vector>

#include "ocean/internal/preview/land_maps.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean::preview {

/// Returns the square of a bed's ground, along its longer side, with at most `max_resolution`
/// samples: beyond the shorter one it holds the edge.
LandImage bed_image(const SeaBed& bed, int max_resolution);

/// Returns the masks of such an image as DrawnLand::masks holds them, four bytes a texel: sand
/// where level ground lies near still water, cliffs where it is steep there.
std::vector<std::uint8_t> bed_masks(const LandImage& image);

/// Returns the ground without its textures.
DrawnLand bed_land(const SeaBed& bed, LandImage image);

}  // namespace ocean::preview
