// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One period of the sea as a mesh file whose header says by comments what it is: what the formats
// of such files share.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "formats/formats.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/io/product_image.hpp"

namespace ocean {

/// --products and --axes of a mesh.
struct PlainMesh {
    std::vector<const Product*> products;
    bool usual = false;  // nobody asked for products
    io::Axes axes = io::Axes::zup;

    /// Numbers of a vertex beside uv.
    std::uint64_t floats() const;
    /// All of its numbers.
    std::uint64_t floats_with_uv() const { return floats() + 2; }
};

/// `products` are those that the format can hold, its default if `all`, else normals alone.
std::vector<FormatOption> plain_mesh_options(std::string_view products, bool all);
ProductChoice plain_mesh_products(const Catalogue& catalogue, std::string_view products, bool all);
PlainMesh read_plain_mesh(const BakeOptions& options, const ChosenProducts& chosen);
const PlainMesh& plain_mesh_of(const BakePlan& plan);

FormatPlan settle_plain_mesh(const BakePlan& begun);
std::vector<BakeFile> list_plain_mesh(const BakePlan& plan, int frame);
std::vector<io::HeaderString> plain_mesh_strings(const BakePlan& plan, int frame);
std::string plain_mesh_recipe(const BakePlan& plan, const BakeFile& file);
bool is_plain_mesh(const BakeFile& file);
std::uint64_t plain_mesh_vertices(const BakePlan& plan);
std::uint64_t plain_mesh_triangles(const BakePlan& plan);
/// Return the bytes of a frame in memory: its vertices; their uv; both and the triangles.
std::uint64_t plain_mesh_vertex_bytes(const BakePlan& plan);
std::uint64_t plain_mesh_uv_bytes(const BakePlan& plan);
std::uint64_t plain_mesh_bytes(const BakePlan& plan);
io::Mesh make_plain_mesh(const FrameWork& work, io::Faces faces = io::Faces::triangles);
void adopt_plain_mesh(const BakedHeader& header, const Catalogue& catalogue, BakeOptions& options);

}  // namespace ocean
