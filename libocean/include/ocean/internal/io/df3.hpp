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
#include <vector>

#include "ocean/detail.hpp"
#include "ocean/internal/io/provenance.hpp"
#include "ocean/surface.hpp"

namespace ocean::io {

/// The encoding of a channel in the voxels of a slice; df3.cpp has the formulas.
enum class Df3Code {
    length,  // [m], up to 1024 m
    range,   // [m], from the minimal to the maximal height of the surface
    offset,  // [m], on the grid of a patch mesh's vertices
    normal,  // a horizontal component of the normal; needs nz as well
    share,   // 0 .. 1
};
struct Df3Slice {
    Channel channel;
    Df3Code code;
};
/// Maps along the z axis of a DF3 file, in their order.
using Df3Slices = std::span<const Df3Slice>;

/// Returns the slices of a kind of subject: a sea has height, dx, dz, two components of the normal,
/// foam and cover; a subject that is not displaced has height, in codes of its own range, and two
/// components of the normal.
Df3Slices df3_slices(std::string_view kind = kSeaKind);
/// Returns the slices of a sea's position: height, dx, dz.
Df3Slices df3_position_slices();
/// Returns the channels that write_df3 needs.
ChannelSet df3_channels(Df3Slices slices);
/// Returns the size of a file [bytes].
std::uint64_t df3_bytes(int resolution, std::size_t slices);
std::uint64_t df3_bytes(const Domain& domain, std::size_t slices);

/// The codes of a height slice: height [m] = base + scale * code / (2^32 - 1).
struct Df3Heights {
    double base, scale;

    double quantum() const { return scale / 4294967295.0; }
};
/// Returns the base and scale for a slice of Df3Code::range. Throws Error invalid_value for a
/// height that is not finite.
Df3Heights df3_heights(const Surface& surface);

/// Writes the slices of a surface: lengths with an error of at most 2.4e-7 m, heights in a range
/// with half a Df3Heights::quantum, offsets with half a step of the patch mesh's grid, which keeps
/// the seam between copies free of cracks. Throws Error output, and invalid_value for a channel
/// that is missing or a length that is not finite or beyond 1024 m.
void write_df3(const Surface& surface, const std::string& path, Df3Slices slices = df3_slices());
/// Returns the bytes of the file that write_df3 writes. Throws as write_df3.
std::string df3_text(const Surface& surface, Df3Slices slices = df3_slices());

/// Returns the size of a file of masks [bytes].
std::uint64_t masks_df3_bytes(const Domain& domain, std::size_t masks);
/// Writes a slice of bytes for each mask, in their order: a share 0 .. 1 is code / 255, a signed
/// value -1 .. 1 is (code - 127) / 127. Throws Error output, and invalid_value for a mask that the
/// surface does not have.
void write_masks_df3(const Surface& surface, std::span<const Channel> masks,
                     const std::string& path);
/// Returns the bytes of the file that write_masks_df3 writes. Throws as write_masks_df3.
std::string masks_df3_text(const Surface& surface, std::span<const Channel> masks);
/// Returns the masks of a land that a file of masks holds, in the order of their table: the masks
/// without a unit.
std::vector<Channel> df3_masks(ChannelSet available);

/// Returns the size of a file of slope tiles [bytes].
std::uint64_t slopes_df3_bytes(int samples, int bands);
/// Writes two slices for each band: the slopes along x and y. Throws Error output.
void write_slopes_df3(const Detail& detail, const std::string& path);

}  // namespace ocean::io
