// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How much of each texel of the sea's period foam covers, for mipmaps to be made of: foam is how
// white water can be, and the share that is white its cube, as in all hosts.

uniform sampler2D foam_map;
uniform float fade;

in vec2 place;
layout(location = 0) out float cover;

void main() {
    float foam = fade * texelFetch(foam_map, ivec2(gl_FragCoord.xy), 0).r;
    cover = foam * foam * foam;
}
