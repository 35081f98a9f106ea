// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How a material reads the slope tiles of the waves too short for its mesh (ocean/detail.hpp) so
// that neither their repetition nor their end is visible. Needs copies.glsl.
//
// A tile is read at three random positions, one for each corner of a grid of triangles, as the
// distant sea reads its copies [Heitz and Neyret 2018]. Slopes are Gaussian, with mean 0 and
// variance v anywhere in the tile, and those at three positions are practically independent: with
// the weights w_i / sqrt(sum w^2) their sum is Gaussian with variance v too [Deliot and Heitz
// 2019], and the histogram needs no correction. A reader computes:
//     slope = sum over bands of fade sum over corners of weight slope_map(x, y)
//     alpha^2 = residual + lost + sum over bands of slope_tile_left
// with alpha of Beckmann's distribution, the residual of DetailBudget, and `lost`, the part of the
// map (at which the bands begin) that a coarser mesh far away lacks. Displayed slope and roughness
// add up to the sea's mean square slope at every distance if the map is read bilinearly: its waves
// are amplified by the factor that this loses. Tests: SlopeTiles in tests/unit/detail_test.cpp.

// Edges of triangles per tile. A corner's copy is visible up to one edge from it: with two edges
// per tile, a point and its repetition are never in the same copy. Measured at Beaufort 4: a
// correlation of 0.05 at most, at lags from 1.5 to 32 m, for a tile of 7.5 m, whose own is 1.
#define slope_tile_triangles real(2.0)

struct SlopeTileRead {
    real x;  // where to read, in tiles
    real y;
    real weight;
};

// Corner 0, 1 or 2 at a label in units of the tile. Derivatives for mipmaps are the label's: the
// places jump between triangles.
formula SlopeTileRead slope_tile_read(real x, real y, int corner) {
    real scale = slope_tile_triangles / copy_triangles;
    GridPoint grid = copy_grid(scale * x, scale * y);
    real square_x = floor(grid.x);
    real square_y = floor(grid.y);
    real fraction_x = grid.x - square_x;
    real fraction_y = grid.y - square_y;
    CopyCorner own = copy_corner(fraction_x, fraction_y, corner);
    real a = copy_corner(fraction_x, fraction_y, 0).weight;
    real b = copy_corner(fraction_x, fraction_y, 1).weight;
    real c = copy_corner(fraction_x, fraction_y, 2).weight;
    GridPoint offset = copy_offset(int(square_x) + own.x, int(square_y) + own.y);
    SlopeTileRead result;
    result.x = x + offset.x;
    result.y = y + offset.y;
    result.weight = own.weight * inversesqrt(a * a + b * b + c * c);
    return result;
}

// Side of the water that a pixel sees [m]: of one that is pixel_angle [rad] wide at a distance [m],
// in the mean of across and along the view, whose direction's vertical part is view_z.
formula real slope_footprint(real distance, real pixel_angle, real view_z) {
    return distance * pixel_angle * inversesqrt(max(abs(view_z), real(0.01)));
}

// Share of a band's slopes that is shown: all where a pixel is a quarter of its middle wave,
// nothing from 1.2 of them on.
formula real slope_tile_fade(real footprint, real shortest_wave, real longest_wave) {
    real middle = sqrt(shortest_wave * longest_wave);
    real t = (footprint / middle - real(0.25)) / real(0.95);
    t = min(max(t, real(0.0)), real(1.0));
    return real(1.0) - t * t * (real(3.0) - real(2.0) * t);
}

// Returns the part of a band's variance that its faded slopes do not show: roughness.
formula real slope_tile_left(real fade, real variance) {
    return variance * (real(1.0) - fade * fade);
}
