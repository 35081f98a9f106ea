// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps as POV-Ray's density_file, the only binary that POV-Ray 3.7 reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "ocean/detail.hpp"
#include "ocean/io/provenance.hpp"
#include "ocean/surface.hpp"

namespace ocean::io {

/// How the voxels of a slice hold a channel; the codes are in df3.cpp.
enum class Df3Code {
    length,  // [m]
    offset,  // [m], on the grid of a patch mesh's vertices
    normal,  // a horizontal component of the normal: needs nz too
    share,   // 0 .. 1
};
struct Df3Slice {
    Channel channel;
    Df3Code code;
};
/// Maps along the z axis of a DF3 file, in their order.
using Df3Slices = std::span<const Df3Slice>;

/// Returns the slices of a subject: of a sea height, dx, dz, two of the normal, foam, cover; of
/// others, whose places stand still, height and two of the normal.
Df3Slices df3_slices(std::string_view kind = kSeaKind);
/// Returns those of a sea's position: height, dx, dz.
Df3Slices df3_position_slices();
/// Returns the channels that write_df3 needs.
ChannelSet df3_channels(Df3Slices slices);
std::uint64_t df3_bytes(int resolution, std::size_t slices);
/// Writes heights to 2.4e-7 m, offsets to half a step of the patch mesh's grid, which keeps the
/// seam of copies free of cracks. Throws Error output, invalid_value for a channel that is missing,
/// or a length that is not finite or beyond 1024 m.
void write_df3(const Surface& surface, const std::string& path, Df3Slices slices = df3_slices());

std::uint64_t slopes_df3_bytes(int samples, int bands);
void write_slopes_df3(const Detail& detail, const std::string& path);

}  // namespace ocean::io
