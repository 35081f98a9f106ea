// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The share of each texel of the sea's period that foam covers, as the finest level of mipmaps: a
// mean of the foam does not give its cover, and a mean cover not the thickness of its foam.
#include "preview/foam_look.glsl"
#include "wave/foam_cover.glsl"
#include "wave/foam_lace.glsl"

uniform sampler2D foam_map;
uniform float fade;
uniform float cover_power;

in vec2 place;
layout(location = 0) out vec4 covered;

void main() {
    float foam = fade * texelFetch(foam_map, ivec2(gl_FragCoord.xy), 0).r;
    float cover = foam_cover(foam, cover_power);
    float thick = cover * foam_mean_thickness(cover, foam_span);
    covered = vec4(cover, thick, foam * foam * foam, 0.0);
}
