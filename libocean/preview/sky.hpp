// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The colours of the sky and its sun: those of povray_macros/ocean/sky.inc, where a white surface
// under a sun at the zenith has radiance 2.2 before the loss in the air, or those of an
// environment.
#pragma once

#include <glm/glm.hpp>

#include "ocean/internal/preview/picture.hpp"

namespace ocean::preview {

struct Sky {
    glm::vec3 sun_direction;
    glm::vec3 sun_colour;
    float sun_shown;      // share of the disc above the horizon
    float mapped = 0.0f;  // 1: the map of an environment is the sky; else 0
    float turn = 0.0f;    // of that map [turns]
    glm::vec3 low, middle, high;
    glm::vec3 shadow;
    float dusk;       // share of the Earth's shadow on the side away from the sun
    glm::vec3 light;  // radiance of a level white surface under the whole sky
};

/// Returns the sky of a look. The colours of an environment's sky are in its map.
Sky make_sky(const Look& look);

}  // namespace ocean::preview
