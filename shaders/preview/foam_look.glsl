// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Colours and sizes of foam near the eye, those of POV-Ray's Ocean_Material.

// Foam lets no more water through where its cover is above the texture by this.
const float foam_span = 0.35;
// From water to foam, as a share of the cover.
const float foam_edge = 0.1;
const vec3 thin_foam = vec3(0.22, 0.29, 0.31);
const vec3 thick_foam = vec3(0.80, 0.80, 0.80);
// What bubbles below the surface send back.
const vec3 foam_plume = vec3(0.012, 0.060, 0.066);
// m over the water, where the cover is above the net by 1: 15 mm for foam that is just thick.
const float foam_height = 0.043;
// m: tiles of ocean/foam_texture.hpp, in those of the net, and their widest cells.
const float lace_tile = 12.0;
const float lace_cell = 0.86;
const float bubble_tile = 1.3;
const float bubble_cell = 0.041;
const float streak_tile = 97.0;
