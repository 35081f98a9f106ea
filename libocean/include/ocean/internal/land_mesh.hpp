// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The patches of a view as one closed mesh, for files. ocean/internal/land_quadtree.hpp shows why
// the mesh is closed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ocean/internal/land_quadtree.hpp"

namespace ocean {

/// Writes the height of land at each point [m], with the waves that vertices `spacing` [m] apart
/// show, and behind each height the further values, if the mesh has some. Values are finite and
/// depend on point and spacing alone.
using HeightSampler =
    std::function<void(std::span<const WorldPoint> points, double spacing, std::span<float>)>;

/// The patch that shows a vertex of a mesh, and the number of the vertex in that patch's lattice.
struct LandPlace {
    std::uint32_t patch;   // among the patches of the mesh
    std::uint32_t vertex;  // row by row from the lower left corner

    bool operator==(const LandPlace&) const = default;
};

/// Triangles that share their vertices.
struct LandMesh {
    std::vector<std::array<double, 3>> positions;         // x, y, z of the world [m]
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from above
    /// For each vertex, one of the patches that show it: the first in which it stands at its own
    /// label, else the first.
    std::vector<LandPlace> places;
    /// The further values of each vertex, averaged between levels as its height is.
    std::vector<float> values;
};

/// Returns an upper bound of the bytes that make_land_mesh needs, its result included.
std::uint64_t land_mesh_bytes(const QuadtreeSettings& settings, std::span<const LandPatch> patches,
                              int further_values = 0);

/// Returns the mesh of patches that `select` chose for the same settings and view. Each edge inside
/// has two triangles, in opposite directions; only the outer border of the patches is open. All
/// vertices differ and are used, and no triangle has two equal vertices. The sampler writes 1 +
/// further_values numbers for each point. Throws as validate, and Error invalid_value for patches
/// of more than 2^32 - 2 vertices.
LandMesh make_land_mesh(const QuadtreeSettings& settings, std::span<const LandPatch> patches,
                        const LandView& view, const HeightSampler& sampler, int further_values = 0);

}  // namespace ocean
