// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One period of the sea as a mesh file whose header describes it in comments: the part that all
// such formats share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/formats.hpp"
#include "formats/land_lod.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "ocean/io/mesh.hpp"

namespace ocean {

/// The settings --products, --axes, --cut-hulls and --lod of a mesh.
struct PlainMesh {
    std::vector<const Product*> products;
    bool is_default = false;  // --products was not given
    io::Axes axes = io::Axes::zup;
    bool cut = false;                 // without the faces inside of hulls
    std::optional<LandLod> lod = {};  // a mesh around an eye instead of one period

    /// Returns the number of floats of a vertex, without its uv.
    std::uint64_t floats() const;
    /// Returns the number of floats of a vertex, with its uv.
    std::uint64_t floats_with_uv() const { return floats() + 2; }
};

/// Return the options of a mesh and its choice of products. `products` lists the products that the
/// format can hold beside the masks of a land. The default is this whole list if `all`, else
/// normals alone.
std::vector<FormatOption> plain_mesh_options(std::string_view products, bool all);
ProductChoice plain_mesh_products(const Catalogue& catalogue, std::string_view products, bool all);
PlainMesh read_plain_mesh(const BakeOptions& options, const ChosenProducts& chosen);

FormatPlan<PlainMesh> resolve_plain_mesh(const BakePlan& draft, const PlainMesh& requested);
std::vector<BakeFile> list_plain_mesh(const BakePlan& plan, const PlainMesh& mesh, int frame);
std::vector<io::HeaderString> plain_mesh_strings(const BakePlan& plan, const PlainMesh& mesh,
                                                 int frame);
std::string plain_mesh_recipe(const BakePlan& plan, const PlainMesh& mesh, const BakeFile& file);
bool is_plain_mesh(const BakeFile& file);
/// Return the vertices and triangles of a mesh; upper bounds with --lod.
std::uint64_t plain_mesh_vertices(const BakePlan& plan, const PlainMesh& mesh);
std::uint64_t plain_mesh_triangles(const BakePlan& plan, const PlainMesh& mesh);
/// Return the bytes of a frame in memory: its vertices; their uv; both and the triangles, including
/// the work space that makes them.
std::uint64_t plain_mesh_vertex_bytes(const BakePlan& plan, const PlainMesh& mesh);
std::uint64_t plain_mesh_uv_bytes(const BakePlan& plan, const PlainMesh& mesh);
std::uint64_t plain_mesh_bytes(const BakePlan& plan, const PlainMesh& mesh);
io::Mesh make_plain_mesh(const FrameWork& work, const PlainMesh& settings,
                         io::Faces faces = io::Faces::triangles);
void adopt_plain_mesh(const BakedHeader& header, const Catalogue& catalogue, BakeOptions& options);

}  // namespace ocean
