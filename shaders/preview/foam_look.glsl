// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Colours and sizes of foam near the eye, those of POV-Ray's Ocean_Material.

// Foam is opaque where its cover exceeds the texture by this.
const float foam_span = 0.35;
// Width of the edge from water to foam, as a share of the cover.
const float foam_edge = 0.1;
const vec3 thin_foam = vec3(0.22, 0.29, 0.31);
const vec3 thick_foam = vec3(0.80, 0.80, 0.80);
// Light of bubbles below the surface, as an albedo.
const vec3 foam_plume = vec3(0.012, 0.060, 0.066);
// Height over the water [m] where the cover exceeds the net by 1: 15 mm for foam that is just
// opaque.
const float foam_height = 0.043;
// Sides of the tiles of ocean/internal/foam_texture.hpp and of their widest cells [m].
const float lace_tile = 12.0;
const float lace_cell = 0.86;
const float bubble_tile = 1.3;
const float bubble_cell = 0.041;
const float streak_tile = 97.0;
// Their widest patches.
const float streak_cell = 14.0;
// The end of a swash, of waves of half a metre and more: cover of its line of foam, and of the foam
// behind; depths [m] below which foam opens, where the line ends, and where that behind it ends.
const float swash_cover = 0.8;
const float swash_behind = 0.3;
const float swash_tip = 0.012;
const float swash_line = 0.045;
const float swash_sheet = 0.15;

// Returns the cover of the foam at the end of a swash over that depth of water [m].
float swash_foam(float depth) {
    float line = 1.0 - smoothstep(swash_tip, swash_line, depth);
    return mix(swash_behind, swash_cover, line) * (1.0 - smoothstep(0.0, swash_sheet, depth));
}
