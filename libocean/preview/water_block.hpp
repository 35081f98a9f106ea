// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The uniform block of shaders/preview/water_block.glsl, which says what each value is: waves,
// foam and near detail of a picture, with places that are reckoned in double where the eye is far
// from the origin.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "ocean/internal/preview/renderer.hpp"

namespace ocean::preview {

/// Slope tiles of two seas.
inline constexpr std::size_t kMaxTiles = 2 * kMaxDetailBands;

struct WaterBlock {
    glm::vec4 waves{};
    glm::vec4 foam{};
    glm::vec4 crest{};
    glm::vec4 range{};
    glm::vec4 period{};
    glm::vec4 grid_place{};
    glm::ivec4 grid_cell{};
    std::array<glm::vec4, kMaxCascades> cascade{};
    std::array<glm::vec4, kMaxCascades> part{};
    std::array<glm::vec4, 2> cover{};
    glm::vec4 cover_share{};
    std::array<glm::vec4, 2> lace{};
    std::array<glm::vec4, 2> lace_net{};
    std::array<glm::vec4, 2> lace_more{};
    std::array<glm::vec4, kMaxTiles> tile{};
    std::array<glm::vec4, kMaxTiles> tile_grid{};
    std::array<glm::ivec4, kMaxTiles> tile_cell{};
    std::array<glm::vec4, kMaxTiles> tile_variance{};
    std::array<glm::vec4, 2 * kMaxTiles> tile_read{};
};
static_assert(sizeof(WaterBlock) == (7 + 2 * kMaxCascades + 9 + 6 * kMaxTiles) * 16,
              "std140 has no other padding");

WaterBlock make_water_block(const DrawnSea& sea, const Camera& camera, const Look& look,
                            const DrawOptions& options);

}  // namespace ocean::preview
