// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The colours of the sky and its sun, those of povray_macros/ocean.inc: a white surface that a sun
// at the zenith lights sends 2.2 before the air takes its part.
#pragma once

#include <glm/glm.hpp>

namespace ocean::preview {

struct Sky {
    glm::vec3 sun_direction;
    glm::vec3 sun_colour;
    float sun_shown;  // 1 above the horizon, 0 when it has set
    glm::vec3 low, middle, high;
    glm::vec3 shadow;
    float dusk;       // share of the shadow on the side away from the sun
    glm::vec3 light;  // of the sky as a whole
};

/// Degrees; see Look.
Sky make_sky(double sun_altitude, double sun_bearing);

}  // namespace ocean::preview
