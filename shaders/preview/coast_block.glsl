// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The windows of a coast in one picture; libocean/preview/coast_ground.hpp is its twin.

layout(std140) uniform CoastBlock {
    // For each window, the finest first: place of the eye in its samples, 1/cell [1/m], samples
    // along a side.
    vec4 coast_window[4];
    vec4 coast_edge;    // lowest and highest place of the bed relative to the eye [m]
    ivec4 coast_count;  // windows, 1 over a bed
};
