// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The colours of the sky and its sun: those of povray_macros/ocean.inc, where a white surface that
// a sun at the zenith lights sends 2.2 before the air takes its part, or those of an environment.
#pragma once

#include <glm/glm.hpp>

#include "ocean/preview/picture.hpp"

namespace ocean::preview {

struct Sky {
    glm::vec3 sun_direction;
    glm::vec3 sun_colour;
    float sun_shown;      // 1 above the horizon, 0 when it has set
    float mapped = 0.0f;  // 1: by the map of an environment
    float turn = 0.0f;    // of it, in turns
    glm::vec3 low, middle, high;
    glm::vec3 shadow;
    float dusk;       // share of the shadow on the side away from the sun
    glm::vec3 light;  // of the sky as a whole
};

/// Of that look. With an environment its map has the colours of the sky itself.
Sky make_sky(const Look& look);

}  // namespace ocean::preview
