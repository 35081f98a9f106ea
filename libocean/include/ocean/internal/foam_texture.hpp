// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures of foam that tile. A sea states how much of the water is white, its cover; a texture
// decides where, in details that no map holds: a point is white where the texture is below the
// cover. Its values are uniform in [0, 1], so that a cover of 0.2 is white on 0.2 of the area with
// any texture; low values vanish last. shaders/wave/foam_lace.glsl combines and softens textures.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ocean {

class ThreadPool;

enum class FoamTextureKind {
    lace,     // walls of cells of several sizes: a raft of bubbles that has opened
    bubbles,  // single bubbles, for cameras closer than about 5 m
    streaks   // patches along +x, the wind: windrows
};

struct FoamTextureInfo {
    FoamTextureKind kind;
    std::string_view name;
    double period;          // of the intended tile [m]; another period scales the cells
    double widest_cell;     // across [m]: the `cell` of foam_faded in foam_lace.glsl
    std::string_view help;  // its content
};
/// The textures in the order of FoamTextureKind.
inline constexpr std::array<FoamTextureInfo, 3> kFoamTextures{{
    {FoamTextureKind::lace, "lace", 12.0, 0.86, "nets of cells of 0.86, 0.32 and 0.12 m"},
    {FoamTextureKind::bubbles, "bubbles", 1.3, 0.041, "bubbles of 4.1, 1.6 and 0.8 cm"},
    {FoamTextureKind::streaks, "streaks", 97.0, 14.0,
     "patches 1 to 14 m wide, 8 times as long along +x, the wind"},
}};
/// Returns the row of a kind.
const FoamTextureInfo& foam_texture_info(FoamTextureKind kind);
/// Returns the kind of that name. Throws Error invalid_value naming the nearest.
FoamTextureKind find_foam_texture(std::string_view name);

/// Counts up when a texture of the same settings gets other values, so that files of an earlier
/// edition are recognised.
inline constexpr int kFoamTextureEdition = 1;

inline constexpr int kMinFoamTextureSize = 64;  // texels along a side
inline constexpr int kMaxFoamTextureSize = 4096;

struct FoamTextureSettings {
    FoamTextureKind kind = FoamTextureKind::lace;
    int size = 1024;         // texels along a side, a power of two
    std::uint32_t seed = 1;  // textures of different kinds are independent even with one seed
};

/// Throws Error invalid_value for a size that is not a power of two within the limits.
void require_foam_texture_size(int size);

/// Returns size^2 values [j][i] in [0, 1], texel (i, j) at (i + 1/2, j + 1/2) * period / size;
/// periodic. Bilinear reads are uniform: the share of reads below c is c to 5e-4 for every c, and
/// to 1 % for c = 0.02. With bubbles the share is c to 1e-3 at 128 texels along a side, which are
/// four per bubble, and to 6e-3 at 64 texels. A finer texture of the same seed is the same foam
/// with more detail. The bits are the same for any number of threads. Throws Error invalid_value
/// for a size that is not allowed.
std::vector<float> make_foam_texture(const FoamTextureSettings& settings, ThreadPool& pool);

/// Returns an upper bound of the bytes that make_foam_texture needs, its result included.
std::uint64_t foam_texture_bytes(int size);

}  // namespace ocean
