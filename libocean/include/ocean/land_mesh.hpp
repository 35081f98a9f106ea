// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The patches of a view as one closed mesh, for files. The argument why it is closed stands in
// ocean/land_quadtree.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ocean/land_quadtree.hpp"

namespace ocean {

/// Writes the height of land at each point [m], with the waves that vertices `spacing` [m] apart
/// show. A pure function of point and spacing, whatever the other points are; finite.
using HeightSampler =
    std::function<void(std::span<const WorldPoint> points, double spacing, std::span<float>)>;

/// Triangles that share their vertices.
struct LandMesh {
    std::vector<std::array<double, 3>> positions;         // x, y, z of the world [m]
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from above
};

/// Writes the (quads + 1)^2 vertices of a patch as the view shows them, row by row from its lower
/// left corner [m].
void place_patch(const QuadtreeSettings& settings, const LandView& view, const LandPatch& patch,
                 const HeightSampler& sampler, std::vector<std::array<double, 3>>& positions);

/// Returns an upper bound of the bytes that make_land_mesh needs, its result included.
std::uint64_t land_mesh_bytes(const QuadtreeSettings& settings, std::span<const LandPatch> patches);

/// Returns the mesh of patches that `select` chose for the same settings and view. Each edge
/// inside has two triangles, in opposite directions; only the outer border of the patches is open.
/// No two vertices are equal, none is unused, and no triangle has two equal vertices. Throws as
/// validate, and Error invalid_value for patches of more than 2^32 - 2 vertices.
LandMesh make_land_mesh(const QuadtreeSettings& settings, std::span<const LandPatch> patches,
                        const LandView& view, const HeightSampler& sampler);

}  // namespace ocean
