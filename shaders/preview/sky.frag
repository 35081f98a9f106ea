// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "preview/frame.glsl"
#include "preview/sky.glsl"
#include "preview/below.glsl"
#include "preview/tone.glsl"

in vec2 place;
layout(location = 0) out vec4 colour;

void main() {
    vec4 far = world_from_clip * vec4(place, 0.5, 1.0);
    vec3 direction = normalize(far.xyz / far.w);
    vec3 light = sky(direction, look.z) + sun_disc(direction);
    // Below still water the sky is seen through the surface alone, which ends a little above the
    // level.
    if (view.y == 1 && eye.z < 0.0 && direction.z < 0.02) light = water_glow(direction);
    colour = vec4(drawn_colour(light), 1.0);
}
