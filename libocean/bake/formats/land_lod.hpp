// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// --lod: the land around an eye as one mesh, fine near the eye and coarse far from it. Its squares
// come from the quadtree of land (ocean/internal/land_quadtree.hpp), all round the eye.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/internal/land_quadtree.hpp"
#include "ocean/io/mesh.hpp"

namespace ocean {

/// The settings --lod and --farthest of a mesh. The other members are absent until
/// resolve_land_lod().
struct LandLod {
    std::array<double, 3> eye{};          // [m], z up
    std::optional<double> farthest = {};  // [m]
    double ground = 0.0;                  // ground of the view [m]
    QuadtreeSettings quadtree = {};
    std::uint64_t max_vertices = 0;   // before welding
    std::uint64_t max_triangles = 0;  // before degenerate ones are dropped
    std::uint64_t work_bytes = 0;     // memory for making the mesh

    LandView view() const { return {eye, ground}; }
};

/// Returns the options --lod and --farthest.
std::vector<FormatOption> land_lod_options();
/// Returns the settings, if --lod is given. Throws Error invalid_value.
std::optional<LandLod> read_land_lod(const BakeOptions& options);
/// Returns the settings with the quadtree of the draft's land. Computes the land, for the ground
/// below the eye. Throws Error unsupported for a subject that is not a terrain.
LandLod resolve_land_lod(const BakePlan& draft, const LandLod& requested);
/// Returns a sentence with the numbers of triangles and vertices, for people.
std::string land_lod_note(const LandLod& lod);
/// Returns the header strings from which --from makes the mesh again.
std::vector<io::HeaderString> land_lod_strings(const LandLod& lod);

/// Returns the mesh, with normals, the products and, with its triangles, the uv, positions in units
/// of the land's sides, so that maps of the whole land fit the mesh; beyond 0 .. 1 where a tile
/// repeats. Heights and normals come from LandFunction at the vertex for the spacing of its level,
/// averaged between levels. A mask has the value of the vertex's level.
io::Mesh make_land_lod_mesh(SubjectMaps& source, const LandLod& lod,
                            std::span<const Product* const> products, io::Faces faces);

}  // namespace ocean
