// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures of foam that tile. A sea says how much of the water is white, its cover; a texture says
// where, in details that no map holds: white is where it is below the cover. Its values are uniform
// in [0, 1], so that a cover of 0.2 is white on 0.2 of the area, whatever the texture; what is low
// is the last to vanish. Formulas that combine and soften them: shaders/wave/foam_lace.glsl.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ocean {

class ThreadPool;

enum class FoamTextureKind {
    lace,     // walls of cells of several sizes: what a raft of bubbles leaves when it opens
    bubbles,  // single bubbles, for cameras that are within some 5 m
    streaks   // patches along +x, the wind: windrows
};

struct FoamTextureInfo {
    FoamTextureKind kind;
    std::string_view name;
    double period;          // m, of the tile that it is made for; another one scales its cells
    double widest_cell;     // m, across: the `cell` of foam_faded in foam_lace.glsl
    std::string_view help;  // what is in it
};
/// In the order of FoamTextureKind.
inline constexpr std::array<FoamTextureInfo, 3> kFoamTextures{{
    {FoamTextureKind::lace, "lace", 12.0, 0.86, "nets of cells of 0.86, 0.32 and 0.12 m"},
    {FoamTextureKind::bubbles, "bubbles", 1.3, 0.041, "bubbles of 4.1, 1.6 and 0.8 cm"},
    {FoamTextureKind::streaks, "streaks", 97.0, 14.0,
     "patches 1 to 14 m wide, 8 times as long along +x, the wind"},
}};
const FoamTextureInfo& foam_texture_info(FoamTextureKind kind);
/// Throws Error invalid_value, with the nearest name.
FoamTextureKind find_foam_texture(std::string_view name);

inline constexpr int kLeastFoamTexture = 64;  // texels a side
inline constexpr int kMostFoamTexture = 4096;

struct FoamTextureSettings {
    FoamTextureKind kind = FoamTextureKind::lace;
    int size = 1024;         // texels a side, a power of two
    std::uint32_t seed = 1;  // textures of different kinds are independent, also of one seed
};

/// Throws Error invalid_value for a size that is not allowed.
void require_foam_texture_size(int size);

/// size^2 values [j][i] in [0, 1], texel (i, j) at ((i + 1/2), (j + 1/2)) period / size; periodic.
/// What is uniform is the bilinear reads: their share below c is c to 5e-4, for every c, and to 1 %
/// for c = 0.02; bubbles of 128 texels a side, four a bubble, keep 1e-3, of 64 texels 6e-3. A finer
/// texture of the same seed is the same foam with more detail. Equal bits for any number of
/// threads. Throws Error invalid_value for a size that is not allowed.
std::vector<float> make_foam_texture(const FoamTextureSettings& settings, ThreadPool& pool);

/// Memory that make_foam_texture takes, at most, with what it returns.
std::uint64_t foam_texture_bytes(int size);

}  // namespace ocean
