// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From positions relative to the eye to clip coordinates. Options give angles in degrees; formulas
// use radians.
#pragma once

#include <glm/glm.hpp>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/preview/picture.hpp"

namespace ocean::preview {

inline constexpr double kRadians = kPi / 180.0;  // [rad] of a degree

struct Projection {
    glm::mat4 clip_from_world;  // of positions relative to the eye
    double pixel_angle;         // between the middle pixels [rad]
    bool flat = false;          // orthographic: the matrix gives the depth too
};

/// Returns the view of a camera with perspective. Its depth is not used: see
/// shaders/preview/on_screen.glsl.
Projection perspective(const Camera& camera, int width, int height);

/// Returns the view from straight above on a square of `metres` a side with its middle at (x, y),
/// with room for waves of that height [m] around the still water.
Projection from_above(const Camera& camera, double x, double y, double metres, double wave_height);

}  // namespace ocean::preview
