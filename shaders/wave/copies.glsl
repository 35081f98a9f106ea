// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea that does not repeat, out of one period of it: copies moved about at random, three at each
// point, one for each corner of a grid of triangles, faded into each other so that their variance
// stays. The sum of Gaussian fields is one: nothing else changes [Heitz and Neyret 2018].

// Corners of triangles a period, along x.
#define copy_triangles real(1.6)

struct GridPoint {
    real x;
    real y;
};

// A point in units of the period, in those of the skewed grid whose squares are two triangles each.
formula GridPoint copy_grid(real x, real y) {
    GridPoint grid;
    grid.x = copy_triangles * (x - real(0.57735026918962576) * y);
    grid.y = copy_triangles * real(1.15470053837925153) * y;
    return grid;
}

// One corner of the triangle that holds a point of the grid, from the point's position in its
// square: the weight of corner 0, 1 or 2 (they add up to 1), and the corner's position, 0 or 1
// along each side.
struct CopyCorner {
    real weight;
    int x;
    int y;
};

formula CopyCorner copy_corner(real fraction_x, real fraction_y, int corner) {
    real rest = real(1.0) - fraction_x - fraction_y;
    int other = rest < real(0.0) ? 1 : 0;  // the triangle that lacks the square's corner (0, 0)
    CopyCorner result;
    if (corner == 0) {
        result.weight = abs(rest);
        result.x = other;
        result.y = other;
    } else if (corner == 1) {
        result.weight = other == 1 ? real(1.0) - fraction_y : fraction_y;
        result.x = other;
        result.y = 1 - other;
    } else {
        result.weight = other == 1 ? real(1.0) - fraction_x : fraction_x;
        result.x = 1 - other;
        result.y = other;
    }
    return result;
}

// Returns the position that the copy of a corner begins at, in periods, 0 .. 1 along each side: two
// hashed numbers of 16 bits [Wellons 2018].
formula GridPoint copy_offset(int corner_x, int corner_y) {
    uint h = uint(corner_x) * 0x9E3779B1u ^ (uint(corner_y) * 0x85EBCA77u + 0x165667B1u);
    h ^= h >> 16;
    h *= 0x7FEB352Du;
    h ^= h >> 15;
    h *= 0x846CA68Bu;
    h ^= h >> 16;
    GridPoint offset;
    offset.x = real(h & 0xFFFFu) / real(65536.0);
    offset.y = real(h >> 16) / real(65536.0);
    return offset;
}
