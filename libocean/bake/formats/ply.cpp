// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Binary PLY: normals, foam and velocity at each vertex of a mesh, or the points of spray.
#include <variant>

#include "formats/formats.hpp"
#include "formats/plain_mesh.hpp"
#include "formats/spray_points.hpp"
#include "ocean/bake/typed_format.hpp"
#include "ocean/io/mesh.hpp"

namespace ocean {
namespace {

constexpr std::string_view kPlyProducts = "normal,foam,velocity";
constexpr bool kPlyAll = true;  // the default without --products

using MeshOrSpray = std::variant<PlainMesh, SprayPoints>;

const SprayPoints* spray_of(const MeshOrSpray& settings) {
    return std::get_if<SprayPoints>(&settings);
}

const PlainMesh& mesh_of(const MeshOrSpray& settings) {
    return std::get<PlainMesh>(settings);
}

std::vector<FormatOption> list_options(const Catalogue&) {
    std::vector<FormatOption> options = plain_mesh_options(kPlyProducts, kPlyAll);
    options.front().help += "; spray is a file of its own";
    for (FormatOption& option : spray_options()) options.push_back(std::move(option));
    return options;
}

std::optional<ProductChoice> product_choice(const Catalogue& catalogue) {
    ProductChoice choice = plain_mesh_products(catalogue, kPlyProducts, kPlyAll);
    choice.alone = &kSprayProduct;
    return choice;
}

MeshOrSpray read_options(const BakeOptions& options, const Catalogue& catalogue) {
    const ChosenProducts chosen = choose_products(options, *product_choice(catalogue));
    if (chosen.has(kSprayProduct)) return read_spray(options);
    refuse_spray_options(options, kSprayProduct.name);
    return read_plain_mesh(options, chosen);
}

std::vector<const Product*> list_products(const BakePlan&, const MeshOrSpray& settings) {
    if (spray_of(settings)) return {&kSprayProduct};
    return mesh_of(settings).products;
}

FormatPlan<MeshOrSpray> resolve(const BakePlan& draft, const MeshOrSpray& requested) {
    if (spray_of(requested)) return {spray_maps(draft), requested};
    FormatPlan<PlainMesh> mesh = resolve_plain_mesh(draft, mesh_of(requested));
    return {.maps = std::move(mesh.maps),
            .settings = std::move(mesh.settings),
            .note = std::move(mesh.note)};
}

std::vector<BakeFile> list_files(const BakePlan& plan, const MeshOrSpray& settings, int frame) {
    if (spray_of(settings)) return list_spray(plan, frame);
    return list_plain_mesh(plan, mesh_of(settings), frame);
}

std::string recipe(const BakePlan& plan, const MeshOrSpray& settings, const BakeFile& file) {
    if (const auto* spray = spray_of(settings)) return spray_recipe(plan, *spray, file);
    return plain_mesh_recipe(plan, mesh_of(settings), file);
}

std::uint64_t frame_bytes(const BakePlan& plan, const MeshOrSpray& settings) {
    if (const auto* spray = spray_of(settings)) return spray_frame_bytes(plan, *spray);
    return plain_mesh_bytes(plan, mesh_of(settings));
}

std::uint64_t max_bytes(const BakePlan& plan, const MeshOrSpray& settings, const BakeFile&) {
    const std::uint64_t comments = 2 * plan.subject_text.size() + 4096;
    if (const auto* spray = spray_of(settings)) {
        return comments + io::points_ply_bytes(max_spray_points(plan, spray->settings));
    }
    return comments + io::ply_bytes(plain_mesh_vertices(plan, mesh_of(settings)),
                                    mesh_of(settings).floats_with_uv(),
                                    plain_mesh_triangles(plan, mesh_of(settings)));
}

void write(const FrameWork& work, const MeshOrSpray& settings, std::span<const BakeFile> files) {
    const std::string& path = files.front().path;
    if (const auto* spray = spray_of(settings)) {
        const io::Points points = make_spray_points(work, *spray);
        const auto strings = spray_strings(work.plan, *spray, work.frame);
        work.write_and_verify(files.front(), [&] { io::write_ply(points, strings, path); });
    } else {
        const io::Mesh mesh = make_plain_mesh(work, mesh_of(settings));
        const auto strings = plain_mesh_strings(work.plan, mesh_of(settings), work.frame);
        work.write_and_verify(files.front(), [&] { io::write_ply(mesh, strings, path); });
    }
}

void adopt(const BakedHeader& header, const Catalogue& catalogue, BakeOptions& options) {
    adopt_plain_mesh(header, catalogue, options);
    adopt_spray(header, options);
}

constexpr BakeFormatOf<MeshOrSpray> kOf = {
    .name = "ply",
    .extension = ".ply",
    .label = "PLY",
    .family = "Mesh files PLY",
    .summary = "Meshes of a period in PLY, or points of spray",
    .example = "--products normal,foam",
    .options = list_options,
    .product_choice = product_choice,
    .read_options = read_options,
    .products = list_products,
    .resolve = resolve,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_plain_mesh,
    .frame_bytes = frame_bytes,
    .max_bytes = max_bytes,
    .write = write,
    .read_header = io::read_ply_header,
    .adopt = adopt,
};

}  // namespace

const BakeFormat kPlyFormat = bake_format<kOf>();

}  // namespace ocean
