// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The uniform block of shaders/preview/land_block.glsl, which says what each value is: map, colours
// and cover noise of a picture of land, with places that are reckoned in double where the eye is
// far from the origin.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "ocean/preview/renderer.hpp"

namespace ocean::preview {

inline constexpr std::size_t kCoverSizes = 4;

struct LandBlock {
    glm::vec4 tile{};
    glm::vec4 texel{};
    glm::ivec4 eye_texel{};
    glm::vec4 heights{};
    glm::vec4 range{};
    glm::vec4 snow{};
    glm::vec4 shadow{};
    glm::ivec4 colours{};
    std::array<glm::vec4, kCoverSizes> cover{};
    std::array<glm::ivec4, kCoverSizes> cover_cell{};
};
static_assert(sizeof(LandBlock) == (8 + 2 * kCoverSizes) * 16, "std140 has no other padding");

/// shadow_steps: RendererOptions::shadow_steps.
LandBlock make_land_block(const ShownLand& land, const Camera& camera, const Look& look,
                          const DrawOptions& options, int shadow_steps);

}  // namespace ocean::preview
