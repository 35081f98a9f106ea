// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// --lod: the land around an eye as one mesh, fine near the eye and coarse far from it. Its squares
// are those of the quadtree of land (ocean/land_quadtree.hpp), all round the eye.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/land_quadtree.hpp"

namespace ocean {

/// The settings --lod and --farthest of a mesh. The other members are absent until
/// resolve_land_lod().
struct LandLod {
    std::array<double, 3> eye{};          // [m], z up
    std::optional<double> farthest = {};  // [m]
    double ground = 0.0;                  // of the view [m]
    QuadtreeSettings quadtree = {};
    std::uint64_t max_vertices = 0;   // before any are welded
    std::uint64_t max_triangles = 0;  // before any are dropped
    std::uint64_t work_bytes = 0;     // of making the mesh

    LandView view() const { return {eye, ground}; }
};

/// Returns the options --lod and --farthest.
std::vector<FormatOption> land_lod_options();
/// Returns the settings, if --lod is given. Throws Error invalid_value.
std::optional<LandLod> read_land_lod(const BakeOptions& options);
/// Returns them with the quadtree of the draft's land. Computes the land, for the ground below the
/// eye. Throws Error unsupported for a subject that is not a terrain.
LandLod resolve_land_lod(const BakePlan& draft, const LandLod& requested);
/// Returns a sentence with the numbers of triangles and vertices, for people.
std::string land_lod_note(const LandLod& lod);
/// Returns the header strings by which --from makes the mesh again.
std::vector<io::HeaderString> land_lod_strings(const LandLod& lod);

/// Returns the mesh, with normals, the products and, with its triangles, the uv: a place in sides
/// of the land, so that maps of the whole land lie on the mesh; beyond 0 .. 1 where a tile repeats.
/// A height is that of LandFunction at the vertex for the spacing of its level, and between levels
/// a mean of both; its normal too. A mask is that of the vertex's level.
io::Mesh make_land_lod_mesh(SubjectMaps& source, const LandLod& lod,
                            std::span<const Product* const> products, io::Faces faces);

}  // namespace ocean
