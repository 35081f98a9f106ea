// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Means over a footprint of the windows of a coast.
#include "preview/coast.glsl"
#include "preview/footprint.glsl"

uniform sampler2DArray coast_traces;  // cover of breaking waves' foam, its bubbles, wetness

// Adds the means of an image of the windows at a label to `sum`. Returns their share.
float add_coast(inout vec4 sum, sampler2DArray images, vec2 at, Footprint footprint) {
    float left = coast_share(at), whole = 0.0;
    for (int i = 0; i < coast_count.x && left > 0.0; ++i) {
        vec2 place = window_place(i, at);
        float share = left * window_share(i, place);
        if (share <= 0.0) continue;
        float side = coast_window[i].w;
        sum += share * filtered(images, float(i), (place + 0.5) / side, footprint,
                                coast_window[i].z / side, coast_window[i].z);
        whole += share;
        left -= share;
    }
    return whole;
}
