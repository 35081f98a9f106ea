// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps as POV-Ray's density_file, the only binary that POV-Ray 3.7 reads.
#pragma once

#include <cstdint>
#include <string>

#include "ocean/detail.hpp"
#include "ocean/surface.hpp"

namespace ocean::io {

/// Maps along the z axis of a DF3 file: height, dx, dz, two of the normal, foam, cover. See
/// df3.cpp.
inline constexpr int kDf3Slices = 7;
/// Of a file of height, dx and dz alone, which needs dx, dy and height.
inline constexpr int kDf3PositionSlices = 3;
ChannelSet df3_position_channels();
/// What write_df3 needs: dx, dy, height, nx, ny, nz, foam, cover.
ChannelSet df3_channels();
std::uint64_t df3_bytes(int resolution, int slices = kDf3Slices);
/// Heights to 2.4e-7 m, offsets to half a step of the patch mesh's grid, which keeps the seam of
/// copies free of cracks. Throws Error output, invalid_value for a length that is not finite or
/// beyond 1024 m.
void write_df3(const Surface& surface, const std::string& path, int slices = kDf3Slices);

std::uint64_t slopes_df3_bytes(int samples, int bands);
void write_slopes_df3(const Detail& detail, const std::string& path);

}  // namespace ocean::io
