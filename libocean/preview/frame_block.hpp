// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The uniform block of shaders/preview/frame.glsl, which says what each is.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "ocean/preview/sea_maps.hpp"

namespace ocean::preview {

/// Of two seas.
inline constexpr std::size_t kMostTiles = 2 * kMaxDetailBands;

struct FrameBlock {
    glm::mat4 clip_from_world{1.0f};
    glm::mat4 world_from_clip{1.0f};
    glm::vec4 eye{};
    glm::vec4 sun{};
    glm::vec4 sun_colour{};
    glm::vec4 sky_low{};
    glm::vec4 sky_middle{};
    glm::vec4 sky_high{};
    glm::vec4 sky_shadow{};
    glm::vec4 sky_light{};
    glm::vec4 water{};
    glm::vec4 crest{};
    glm::vec4 loss{};
    glm::vec4 waves{};
    glm::vec4 foam{};
    glm::vec4 period{};
    glm::vec4 grid_place{};
    glm::ivec4 grid_cell{};
    glm::vec4 look{};
    glm::ivec4 view{};
    glm::vec4 range{};
    std::array<glm::vec4, kMostCascades> cascade{};
    std::array<glm::vec4, kMostCascades> part{};
    std::array<glm::vec4, 2> cover{};
    glm::vec4 cover_share{};
    std::array<glm::vec4, 2> lace{};
    std::array<glm::vec4, 2> lace_net{};
    std::array<glm::vec4, 2> lace_more{};
    std::array<glm::vec4, kMostTiles> tile{};
    std::array<glm::vec4, kMostTiles> tile_grid{};
    std::array<glm::ivec4, kMostTiles> tile_cell{};
    std::array<glm::vec4, kMostTiles> tile_variance{};
    std::array<glm::vec4, 2 * kMostTiles> tile_read{};
};
static_assert(sizeof(FrameBlock) == (8 + 19 + 2 * kMostCascades + 9 + 6 * kMostTiles) * 16,
              "std140 has no other padding");

}  // namespace ocean::preview
