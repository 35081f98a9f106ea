// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Binary PLY: normals, foam and velocity at each vertex of a mesh, or the points of spray.
#include "formats/formats.hpp"
#include "formats/plain_mesh.hpp"
#include "formats/spray_points.hpp"
#include "ocean/io/mesh_files.hpp"

namespace ocean {
namespace {

constexpr std::string_view kProducts = "normal,foam,velocity";
constexpr bool kAll = true;  // unless some are asked for

std::vector<FormatOption> list_options(const Catalogue&) {
    std::vector<FormatOption> options = plain_mesh_options(kProducts, kAll);
    options.front().help += kSprayProductHelp;
    for (FormatOption& option : spray_options()) options.push_back(std::move(option));
    return options;
}

std::any read_options(const BakeOptions& options, const Catalogue& catalogue) {
    ProductChoice choice = plain_mesh_products(catalogue, kProducts, kAll);
    choice.alone = &kSprayProduct;
    const ChosenProducts chosen = choose_products(options, choice);
    if (chosen.has(kSprayProduct)) return read_spray(options);
    refuse_spray_options(options, kSprayProduct.name);
    return read_plain_mesh(options, chosen);
}

std::vector<const Product*> list_products(const BakePlan& begun) {
    return spray_of(begun) != nullptr ? std::vector{&kSprayProduct} : plain_mesh_of(begun).products;
}

FormatPlan settle(const BakePlan& begun) {
    return spray_of(begun) != nullptr ? settle_spray(begun) : settle_plain_mesh(begun);
}

std::vector<BakeFile> list_files(const BakePlan& plan, int frame) {
    return spray_of(plan) != nullptr ? list_spray(plan, frame) : list_plain_mesh(plan, frame);
}

std::string recipe(const BakePlan& plan, const BakeFile& file) {
    return spray_of(plan) != nullptr ? spray_recipe(plan, file) : plain_mesh_recipe(plan, file);
}

std::uint64_t frame_bytes(const BakePlan& plan) {
    return spray_of(plan) != nullptr ? spray_frame_bytes(plan) : plain_mesh_bytes(plan);
}

std::uint64_t most_bytes(const BakePlan& plan, const BakeFile&) {
    const std::uint64_t comments = 2 * plan.subject_text.size() + 4096;
    if (spray_of(plan) != nullptr) return comments + io::points_ply_bytes(most_spray_points(plan));
    return comments + io::ply_bytes(plain_mesh_vertices(plan), plain_mesh_of(plan).floats_with_uv(),
                                    plain_mesh_triangles(plan));
}

void write(const FrameWork& work, std::span<const BakeFile> files) {
    const std::string& path = files.front().path;
    if (spray_of(work.plan) != nullptr) {
        const io::Points points = make_spray_points(work);
        const auto strings = spray_strings(work.plan, work.frame);
        work.put(files.front(), [&] { io::write_ply(points, strings, path); });
    } else {
        const io::Mesh mesh = make_plain_mesh(work);
        const auto strings = plain_mesh_strings(work.plan, work.frame);
        work.put(files.front(), [&] { io::write_ply(mesh, strings, path); });
    }
}

void adopt(const BakedHeader& header, const Catalogue& catalogue, BakeOptions& options) {
    adopt_plain_mesh(header, catalogue, options);
    adopt_spray(header, options);
}

}  // namespace

const BakeFormat kPlyFormat = {
    .name = "ply",
    .extension = ".ply",
    .family = "Mesh files PLY",
    .options = list_options,
    .read_options = read_options,
    .products = list_products,
    .settle = settle,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_plain_mesh,
    .frame_bytes = frame_bytes,
    .most_bytes = most_bytes,
    .write = write,
    .read_header = io::read_ply_header,
    .adopt = adopt,
};

}  // namespace ocean
