// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/plain_mesh.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_mask.hpp"
#include "refuse.hpp"
#include "source.hpp"

namespace ocean {
namespace {

constexpr std::string_view kNormalAlone = "normal";
constexpr std::string_view kNothing = "position";
constexpr const char* kCutHulls = "cut-hulls";
constexpr Channel kDry = channel_of(LandMask::dry);

/// The openings of our PLY and OBJ, and the text before the name of their first comment.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kOpenings = {
    {{"ply\nformat binary_little_endian 1.0\n", "1.0\ncomment ocean:"},
     {"# The surface of ", ", by libocean\n# ocean:"}}};

std::string names_of(const PlainMesh& mesh) {
    return mesh.products.empty() ? std::string(kNothing)
                                 : joined(mesh.products, ",", &Product::name);
}

}  // namespace

std::uint64_t PlainMesh::floats() const {
    std::uint64_t count = 3;
    for (const Product* product : products) count += static_cast<std::uint64_t>(product->count);
    return count;
}

std::vector<FormatOption> plain_mesh_options(std::string_view products, bool all) {
    std::vector<FormatOption> options = {
        {"products", "LIST",
         "Comma list of " + std::string(products) +
             " and the masks of a land, or position; default " +
             std::string(all ? products : kNormalAlone)},
        {"axes", "AXES", "zup (x, y, z) or yup (x, z, -y); default zup"},
        {kCutHulls, "", "Leave out the faces inside of hulls; with --region", "", kSeaKind}};
    for (FormatOption& option : land_lod_options()) options.push_back(std::move(option));
    return options;
}

ProductChoice plain_mesh_products(const Catalogue& catalogue, std::string_view products, bool all) {
    return {.known = catalogue.products,
            .default_list = all ? products : kNormalAlone,
            .nothing = kNothing,
            .holder = "a mesh",
            .allowed = products,
            .also_allowed = kMaskProducts};
}

PlainMesh read_plain_mesh(const BakeOptions& options, const ChosenProducts& chosen) {
    return {chosen.products, chosen.is_default, read_up_axes(options, "a mesh"),
            !options.format_option(kCutHulls).empty(), read_land_lod(options)};
}

FormatPlan<PlainMesh> resolve_plain_mesh(const BakePlan& draft, const PlainMesh& requested) {
    using enum Channel;
    PlainMesh mesh = requested;
    if (mesh.is_default) mesh.products = available_products(*draft.subject, mesh.products);
    FrameMaps maps{{height}, {draft.resolution}};
    if (is_displaced(*draft.subject)) maps.channels = {dx, dy, height};
    for (const Product* product : mesh.products) maps.channels = maps.channels | product->set();
    if (mesh.cut) {
        if (draft.domain().wraps) {
            refuse("--cut-hulls: maps of one period have no hulls; it needs --region");
        }
        maps.channels = maps.channels | ChannelSet(kDry);
    }
    if (!mesh.lod) return {maps, mesh};
    mesh.lod = resolve_land_lod(draft, *mesh.lod);
    maps.resolutions = {kMinResolution};  // the mesh reads the land itself
    std::string note = land_lod_note(*mesh.lod);
    return {.maps = maps, .settings = std::move(mesh), .note = std::move(note)};
}

std::vector<BakeFile> list_plain_mesh(const BakePlan& plan, const PlainMesh&, int frame) {
    return {{plan.pattern.file(frame), frame, 0, "mesh"}};
}

std::vector<io::HeaderString> plain_mesh_strings(const BakePlan& plan, const PlainMesh& mesh,
                                                 int frame) {
    std::vector<io::HeaderString> strings = io::provenance_strings(provenance_of(plan, frame));
    strings.push_back({"ocean:resolution", std::to_string(plan.resolution)});
    strings.push_back({"ocean:axes", std::string(io::axes_name(mesh.axes))});
    strings.push_back({"ocean:field", names_of(mesh)});
    if (mesh.cut) strings.push_back({"ocean:cut_hulls", "yes"});
    if (!mesh.lod) return strings;
    for (io::HeaderString& string : land_lod_strings(*mesh.lod))
        strings.push_back(std::move(string));
    return strings;
}

std::string plain_mesh_recipe(const BakePlan& plan, const PlainMesh& mesh, const BakeFile& file) {
    std::string lines =
        "mesh " + names_of(mesh) + " " + std::string(io::axes_name(mesh.axes)) + " uv extent\n";
    if (mesh.cut) lines += "cut hulls\n";
    if (mesh.lod) {
        for (const io::HeaderString& string : land_lod_strings(*mesh.lod)) {
            lines += string.name + " " + string.text + "\n";
        }
    }
    return bake_recipe(plan, file.frame, lines);
}

bool is_plain_mesh(const BakeFile& file) {
    // The first comment names the subject: "ocean:sea".
    const std::string head = text::first_bytes(file.path, 1000);
    for (const auto& [opening, key] : kOpenings) {
        const std::size_t at = head.find(key);
        if (!head.starts_with(opening) || at == std::string::npos) continue;
        const std::size_t kind = at + key.size();
        return kind < head.size() && std::isalpha(static_cast<unsigned char>(head[kind])) != 0;
    }
    return false;
}

std::uint64_t plain_mesh_vertices(const BakePlan& plan, const PlainMesh& mesh) {
    if (mesh.lod) return mesh.lod->max_vertices;
    const Domain domain = plan.domain();
    const int seam = domain.wraps ? 1 : 0;
    return static_cast<std::uint64_t>(domain.samples[0] + seam) *
           static_cast<std::uint64_t>(domain.samples[1] + seam);
}

std::uint64_t plain_mesh_triangles(const BakePlan& plan, const PlainMesh& mesh) {
    if (mesh.lod) return mesh.lod->max_triangles;
    const Domain domain = plan.domain();
    const int seam = domain.wraps ? 0 : 1;
    return 2 * static_cast<std::uint64_t>(domain.samples[0] - seam) *
           static_cast<std::uint64_t>(domain.samples[1] - seam);
}

std::uint64_t plain_mesh_vertex_bytes(const BakePlan& plan, const PlainMesh& mesh) {
    return plain_mesh_vertices(plan, mesh) * mesh.floats() * sizeof(float);
}

std::uint64_t plain_mesh_uv_bytes(const BakePlan& plan, const PlainMesh& mesh) {
    return plain_mesh_vertices(plan, mesh) * 2 * sizeof(float);
}

std::uint64_t plain_mesh_bytes(const BakePlan& plan, const PlainMesh& mesh) {
    return plain_mesh_vertex_bytes(plan, mesh) + plain_mesh_uv_bytes(plan, mesh) +
           plain_mesh_triangles(plan, mesh) * 3 * sizeof(int) +
           (mesh.lod ? mesh.lod->work_bytes : 0);
}

io::Mesh make_plain_mesh(const FrameWork& work, const PlainMesh& settings, io::Faces faces) {
    io::Mesh mesh = settings.lod
                        ? make_land_lod_mesh(work.source, *settings.lod, settings.products, faces)
                        : io::make_patch_mesh(work.maps.front(), faces);
    if (settings.cut) {
        const Surface& map = work.maps.front();
        if (mesh.triangles.empty()) mesh.triangles = io::patch_triangles(map.domain());
        io::cut_dry_squares(map.domain(), map.channel(kDry), mesh.triangles);
        const auto is_dry = [](const auto* product) { return product->set() == ChannelSet(kDry); };
        if (std::ranges::none_of(settings.products, is_dry)) {
            std::erase_if(mesh.attributes,
                          [](const auto& one) { return one.name == word_of(LandMask::dry); });
        }
    }
    if (settings.axes == io::Axes::yup) io::turn_y_up(mesh);
    return mesh;
}

void adopt_plain_mesh(const BakedHeader& header, const Catalogue&, BakeOptions& options) {
    options.set_default("products", header.text("field"));
    options.set_default("axes", header.text("axes"));
    if (header.has("cut_hulls")) options.set_default(kCutHulls, header.text("cut_hulls"));
    if (header.has("lod")) options.set_default("lod", header.text("lod"));
    if (header.has("farthest")) options.set_default("farthest", header.text("farthest"));
}

}  // namespace ocean
