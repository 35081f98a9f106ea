// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The uniform block of shaders/preview/land_block.glsl, which says what each value is: map,
// colours, cover noise and lattice of vertices of a picture of land, with places that are reckoned
// in double where the eye is far from the origin.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "drawable.hpp"
#include "land_patches.hpp"

namespace ocean::preview {

inline constexpr std::size_t kCoverSizes = 4;
/// Wavelengths of the relief of covers [m], of shaders/preview/ground_relief.glsl.
inline constexpr std::array<double, 5> kReliefWaves = {16.0, 4.0, 1.0, 0.25, 0.0625};
inline constexpr std::size_t kNoiseSizes = kCoverSizes + kReliefWaves.size();

struct LandBlock {
    glm::vec4 tile{};
    glm::vec4 texel{};
    glm::ivec4 eye_texel{};
    glm::vec4 heights{};
    glm::vec4 range{};
    glm::vec4 snow{};
    glm::vec4 shadow{};
    glm::ivec4 colours{};
    glm::vec4 lattice{};
    glm::vec4 morph{};
    glm::vec4 edge{};
    glm::vec4 water{};
    std::array<glm::vec4, kNoiseSizes> cover{};
    std::array<glm::ivec4, kNoiseSizes> cover_cell{};
};
static_assert(sizeof(LandBlock) == (12 + 2 * kNoiseSizes) * 16, "std140 has no other padding");

/// shadow_steps: RendererOptions::shadow_steps.
LandBlock make_land_block(const DrawnLand& land, const DrawnLattice& lattice,
                          const PictureFrame& frame, int shadow_steps);

}  // namespace ocean::preview
