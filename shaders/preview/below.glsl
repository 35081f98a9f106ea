// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Below the surface: the light of the water body, and its absorption of other light.
#include "preview/sky.glsl"

// Returns the light from above that reaches the eye's depth.
vec3 light_at_eye() {
    return light_from_above() * exp(loss.rgb * min(eye.z, 0.0));
}

// Returns the light of endless water in a direction: it scatters ahead rather than back, so that it
// is brighter towards the surface.
vec3 water_glow(vec3 direction) {
    return water.rgb * light_at_eye() * (4.0 + 6.0 * max(direction.z, 0.0));
}

// Returns the light that arrives from a direction through so many metres of water.
vec3 through_water(vec3 light, vec3 direction, float distance) {
    return mix(water_glow(direction), light, exp(-loss.rgb * distance));
}
