// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The uniform block of shaders/preview/coast_block.glsl, which says what each value is.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "ocean/internal/preview/coast_maps.hpp"
#include "ocean/internal/preview/picture.hpp"

namespace ocean::preview {

struct CoastBlock {
    std::array<glm::vec4, kMaxWindows> window{};
    glm::vec4 edge{};
    glm::ivec4 count{};
};
static_assert(sizeof(CoastBlock) == (kMaxWindows + 2) * 16, "std140 has no other padding");

CoastBlock make_coast_block(const DrawnCoast& coast, const Camera& camera);

}  // namespace ocean::preview
