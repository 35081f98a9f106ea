// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Means over a footprint of the windows of a coast.
#include "preview/coast.glsl"
#include "preview/footprint.glsl"

// Cover of breaking waves' foam, its bubbles, wetness, and the greatest depth of the water that
// left it [m]; without a bed that is the cover of the whitecaps of a sea with hulls.
uniform sampler2DArray coast_traces;

// Returns the sum of the means of an image of the windows, by their shares.
vec4 coast_mean(sampler2DArray images, CoastReads reads, Footprint footprint) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < reads.count; ++i) {
        vec4 window = coast_window[reads.window[i]];
        sum += reads.share[i] * filtered(images, float(reads.window[i]),
                                         (reads.place[i] + 0.5) / window.w, footprint,
                                         window.z / window.w, window.z);
    }
    return sum;
}

// Returns the same over a circle of that diameter [m], for which one read a window is enough.
vec4 coast_mean(sampler2DArray images, CoastReads reads, float width) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < reads.count; ++i) {
        vec4 window = coast_window[reads.window[i]];
        vec2 place = (reads.place[i] + 0.5) / window.w;
        float level = log2(max(width * window.z, 1.0));
        sum += reads.share[i] * textureLod(images, vec3(place, float(reads.window[i])), level);
    }
    return sum;
}
