// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A surface as triangles, for renderers without displacement.
#pragma once

#include <vector>

#include "ocean/surface.hpp"

namespace ocean::io {

/// Triangles with a normal at each vertex, z up, metres.
struct Mesh {
    std::vector<float> positions;  // x, y, z of each vertex
    std::vector<float> normals;
    std::vector<float> foam;        // of each vertex, 0 .. 1; empty where there is none
    std::vector<float> cover;       // likewise
    std::vector<float> velocities;  // of each vertex, m/s; empty where there are none
    std::vector<int> triangles;     // three vertex numbers each, counter-clockwise from above
};

/// none: vertices alone, for files that have the faces elsewhere.
enum class Faces { none, triangles };

/// One period of the displaced surface, (N+1)^2 vertices with the seam closed. Vertices lie on a
/// grid of a power of two (2^-16 m, coarser for large patches), which keeps the seam of copies that
/// lie a period apart free of cracks when the period lies on it too, as every whole number does.
/// Needs dx, dy, height; takes the normal, foam, cover and velocity too, if it was evaluated with
/// them.
Mesh make_patch_mesh(const Surface& surface, Faces faces = Faces::triangles);
/// y up instead of z: (x, z, -y).
void turn_y_up(Mesh& mesh);
/// Its triangles alone, which are the same for all maps of so many samples a side.
std::vector<int> patch_triangles(int resolution);

}  // namespace ocean::io
