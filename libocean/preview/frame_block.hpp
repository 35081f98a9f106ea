// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The uniform block of shaders/preview/frame.glsl, which says what each value is: camera, sky, air
// and water body of a picture, for every drawable.
#pragma once

#include <glm/glm.hpp>

#include "ocean/internal/preview/renderer.hpp"
#include "projection.hpp"

namespace ocean::preview {

/// The fog behind and in front of the water of the look `seed`, as a screen takes it.
inline const glm::vec3 kSeedFog(0.86f, 0.88f, 0.90f);

struct FrameBlock {
    glm::mat4 clip_from_world{1.0f};
    glm::mat4 world_from_clip{1.0f};
    glm::vec4 eye{};
    glm::vec4 depth{};
    glm::vec4 look{};
    glm::ivec4 view{};
    glm::vec4 sun{};
    glm::vec4 sun_colour{};
    glm::vec4 sky_low{};
    glm::vec4 sky_middle{};
    glm::vec4 sky_high{};
    glm::vec4 sky_shadow{};
    glm::vec4 sky_light{};
    glm::vec4 water{};
    glm::vec4 loss{};
};
static_assert(sizeof(FrameBlock) == (8 + 13) * 16, "std140 has no other padding");

/// Returns whether the water is drawn as the teaching programs drew it; views of its fields look
/// the same whatever the look.
bool is_seed(const Look& look, const DrawOptions& options);

/// farthest: distance from the eye beyond which no drawable of the picture draws anything [m].
FrameBlock make_frame_block(const Camera& camera, const Look& look, const DrawOptions& options,
                            const Projection& projection, double farthest);

}  // namespace ocean::preview
