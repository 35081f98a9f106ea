// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Wavefront OBJ: normals, and the foam as the colour of each vertex.
#include "formats/formats.hpp"
#include "formats/plain_mesh.hpp"
#include "ocean/bake/typed_format.hpp"
#include "ocean/io/mesh.hpp"

namespace ocean {
namespace {

constexpr std::string_view kProducts = "normal,foam";
constexpr bool kAll = false;  // the default without --products

std::vector<FormatOption> list_options(const Catalogue&) {
    return plain_mesh_options(kProducts, kAll);
}

std::optional<ProductChoice> product_choice(const Catalogue& catalogue) {
    return plain_mesh_products(catalogue, kProducts, kAll);
}

PlainMesh read_options(const BakeOptions& options, const Catalogue& catalogue) {
    return read_plain_mesh(options, choose_products(options, *product_choice(catalogue)));
}

std::uint64_t max_bytes(const BakePlan& plan, const PlainMesh& mesh, const BakeFile&) {
    const std::uint64_t comments = 2 * plan.subject_text.size() + 4096;
    return comments + io::max_obj_bytes(plain_mesh_vertices(plan, mesh), mesh.floats_with_uv(),
                                        plain_mesh_triangles(plan, mesh));
}

void write(const FrameWork& work, const PlainMesh& settings, std::span<const BakeFile> files) {
    const io::Mesh mesh = make_plain_mesh(work, settings);
    const auto strings = plain_mesh_strings(work.plan, settings, work.frame);
    work.write_and_verify(files.front(), [&] { io::write_obj(mesh, strings, files.front().path); });
}

constexpr BakeFormatOf<PlainMesh> kOf = {
    .name = "obj",
    .extension = ".obj",
    .label = "OBJ",
    .family = "Mesh files OBJ",
    .summary = "Meshes of a period in Wavefront OBJ",
    .example = "--products normal,foam",
    .options = list_options,
    .product_choice = product_choice,
    .read_options = read_options,
    .resolve = resolve_plain_mesh,
    .files = list_plain_mesh,
    .recipe = plain_mesh_recipe,
    .is_baked = is_plain_mesh,
    .frame_bytes = plain_mesh_bytes,
    .max_bytes = max_bytes,
    .write = write,
    .read_header = io::read_obj_header,
    .adopt = adopt_plain_mesh,
};

}  // namespace

const BakeFormat kObjFormat = bake_format<kOf>();

}  // namespace ocean
