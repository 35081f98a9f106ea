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
// Cover of the line where the sheet of a swash ends, of waves of half a metre and more, and the
// depth of the sheet where the line ends [m].
const float swash_cover = 0.5;
const float swash_sheet = 0.15;
