// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Slopes of the waves too short for the cascades' maps, by tiles; see ocean/detail.hpp. A sea has
// one array of tiles; two seas have two (TILE_MAPS), and the tiles before TILE_SPLIT lie in the
// first one.
#include "preview/water_state.glsl"

uniform sampler2DArray tile_maps[TILE_MAPS];

// The slope of a tile, as slope_tile_read has it, at a label relative to the eye.
vec2 tile_slope(sampler2DArray maps, int d, vec2 at, int level) {
    vec2 place = at * tile[d].z;
    float scale = slope_tile_triangles / copy_triangles;
    GridPoint skewed = copy_grid(scale * place.x, scale * place.y);
    vec2 grid = tile_grid[d].xy + vec2(skewed.x, skewed.y);
    vec2 cell = floor(grid);
    vec2 inside = grid - cell;
    vec2 sum = vec2(0.0);
    float squares = 0.0;
    for (int i = 0; i < 3; ++i) {
        CopyCorner corner = copy_corner(inside.x, inside.y, i);
        GridPoint moved = copy_offset(tile_cell[d].x + int(cell.x) + corner.x,
                                      tile_cell[d].y + int(cell.y) + corner.y);
        vec2 from = tile[d].xy + place + vec2(moved.x, moved.y);
        sum += corner.weight * textureLod(maps, vec3(from, float(tile_cell[d].z)), float(level)).xy;
        squares += corner.weight * corner.weight;
    }
    return sum * inversesqrt(squares);
}

// Adds the tiles from `first` up to `end`, which lie in one array: their slopes times `scale`, and
// to the variance the part of them that a pixel cannot show.
void add_tiles(inout Water water, sampler2DArray maps, int first, int end, vec2 at, float scale) {
    for (int d = first; d < end; ++d) {
        float weight = scale * tile[d].w;
        float fade = slope_tile_fade(water.footprint, tile_grid[d].z, tile_grid[d].w);
        // Texels of two thirds of a pixel: waves that are shorter would be a grain.
        float texels = water.footprint * tile[d].z * float(tile_cell[d].w);
        int level = clamp(int(floor(log2(max(texels, 1.0)))), 0, 7);
        float left = 1.0 - fade * fade * tile_read[2 * d + level / 4][level % 4];
        if (fade > 0.0) water.detail += fade * weight * tile_slope(maps, d, at, level);
        water.variance += weight * weight * left * tile_variance[d].xyz;
    }
}

// Adds all tiles. lacking: mean square slope of the sea that the maps do not have. Returns the mean
// square slope of the tiles, which is scaled down to that where it is more: theirs varies with
// time.
float add_detail(inout Water water, vec2 at, float lacking) {
    float whole = 0.0;
    for (int d = 0; d < DETAIL; ++d) {
        whole += tile[d].w * tile[d].w * (tile_variance[d].x + tile_variance[d].y);
    }
    float scale = min(1.0, sqrt(lacking / max(whole, 1e-12)));
    add_tiles(water, tile_maps[0], 0, TILE_SPLIT, at, scale);
#if TILE_MAPS > 1
    add_tiles(water, tile_maps[1], TILE_SPLIT, DETAIL, at, scale);
#endif
    return scale * scale * whole;
}
