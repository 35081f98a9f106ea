// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See land_lod.hpp. The mesher mixes normals in the same way as heights; masks are maps of its
// patches, read at the places of the mesh's vertices.
#include "formats/land_lod.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/land_mesh.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_function.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrainfile.hpp"
#include "refuse.hpp"

namespace ocean {
namespace {

using Position = std::array<double, 3>;

constexpr const char* kEye = "lod EX,EY,EZ";
constexpr double kMaxEye = 1e7;  // [m]
constexpr int kNormalValues = 3;

/// Returns the maps of a patch's masks, at its vertices.
Surface masks_of(const LandFunction& function, const LandLod& lod, const LandPatch& patch,
                 ChannelSet masks, ThreadPool& pool) {
    const double spacing = lod.quadtree.spacing_of(patch.level);
    const int quads = patch.quads(lod.quadtree);
    const double side = quads * spacing;
    const Domain region{{static_cast<double>(patch.i) * side, static_cast<double>(patch.j) * side},
                        {side, side},
                        {quads + 1, quads + 1},
                        false};
    return function.surface(region, masks, pool);
}

/// Returns the sampler of a land's heights, with the normal after each height if `has_normals`.
HeightSampler sampler_of(const LandFunction& function, ThreadPool& pool, bool has_normals) {
    return
        [&function, &pool, has_normals, samples = std::vector<QuerySample>()](
            std::span<const WorldPoint> points, double spacing, std::span<float> values) mutable {
            samples.resize(points.size());
            function.query(points, samples, spacing, pool);
            float* to = values.data();
            for (const QuerySample& sample : samples) {
                *to++ = static_cast<float>(sample.height);
                if (!has_normals) continue;
                for (const double component : sample.normal) *to++ = static_cast<float>(component);
            }
        };
}

/// Returns means of normals, three numbers each, as unit vectors.
std::vector<float> unit_normals(std::vector<float> normals) {
    for (std::size_t v = 0; v < normals.size(); v += kNormalValues) {
        const float x = normals[v], y = normals[v + 1], z = normals[v + 2];
        const float length = std::sqrt(x * x + y * y + z * z);
        for (std::size_t c = 0; c < kNormalValues; ++c) normals[v + c] /= length;
    }
    return normals;
}

/// Adds the products that are masks; each vertex has the mask of its level.
void add_masks(const LandFunction& function, const LandLod& lod, std::span<const LandPatch> patches,
               const LandMesh& land, std::span<const Product* const> products, ThreadPool& pool,
               io::Mesh& mesh) {
    ChannelSet masks;
    std::vector<std::pair<Channel, std::size_t>> columns;  // a mask, and the index of its attribute
    for (const Product* product : products) {
        if (product->name == "normal") continue;
        masks = masks | product->set();
        columns.emplace_back(product->channels[0], mesh.attributes.size());
        mesh.attributes.push_back(
            {std::string(product->name), 1, std::vector<float>(land.places.size())});
    }
    if (columns.empty()) return;
    std::vector<std::size_t> by_patch(land.places.size());
    std::iota(by_patch.begin(), by_patch.end(), std::size_t{0});
    std::ranges::sort(by_patch, {}, [&](std::size_t v) { return land.places[v].patch; });
    std::optional<std::uint32_t> shown;  // the patch of the maps
    Surface maps;
    for (const std::size_t v : by_patch) {
        const LandPlace place = land.places[v];
        if (shown != place.patch) maps = masks_of(function, lod, patches[place.patch], masks, pool);
        shown = place.patch;
        for (const auto& [channel, column] : columns) {
            mesh.attributes[column].values[v] = maps.channel(channel)[place.vertex];
        }
    }
}

/// Returns the min spacing of vertices that files can resolve around an eye, since they hold
/// positions as floats in [m]: 0.5, and more beyond 1e6 m from the origin.
double finest_spacing(const std::array<double, 3>& eye) {
    const double reach = std::max({std::abs(eye[0]), std::abs(eye[1]), 1.0});
    const double rounding = std::ldexp(1.0, std::ilogb(reach) - 23);
    double spacing = QuadtreeSettings{}.spacing;
    while (spacing < 8.0 * rounding) spacing *= 2.0;
    return spacing;
}

LandEdge edge_of(const Domain& domain) {
    return {domain.origin, {domain.origin[0] + domain.size[0], domain.origin[1] + domain.size[1]}};
}

/// Returns the distance from the eye to the farthest corner, on the ground [m].
double farthest_corner(const std::array<double, 3>& eye, const LandEdge& edge) {
    std::array<double, 2> reach{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        reach[axis] =
            std::max(std::abs(eye[axis] - edge.low[axis]), std::abs(eye[axis] - edge.high[axis]));
    }
    return std::hypot(reach[0], reach[1]);
}

}  // namespace

std::vector<FormatOption> land_lod_options() {
    return {{"lod", "EX,EY,EZ",
             "The land around this eye, in metres with z up, as one mesh without cracks: vertices "
             "0.5 m apart near it, as far as the eye tells them apart everywhere",
             "", kTerrainKind},
            {"farthest", "M",
             "Distance from the eye up to which there is land; default 150000, or the whole of a "
             "land that exists once",
             kEye, kTerrainKind}};
}

std::optional<LandLod> read_land_lod(const BakeOptions& options) {
    const std::string& typed = options.format_option("lod");
    if (typed.empty()) return std::nullopt;
    const std::vector<std::string> numbers = split(typed, ',');
    if (numbers.size() != 3) {
        refuse("--lod " + typed + ": allowed is EX,EY,EZ in metres");
    }
    LandLod lod;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        lod.eye[axis] = parse_number(numbers[axis], "--lod", -kMaxEye, kMaxEye);
    }
    const std::string& farthest = options.format_option("farthest");
    if (!farthest.empty()) lod.farthest = parse_number(farthest, "--farthest", 1.0, 1e6);
    return lod;
}

LandLod resolve_land_lod(const BakePlan& draft, const LandLod& requested) {
    const TerrainModel* const terrain = find_terrain(*draft.subject);
    if (terrain == nullptr) throw Error(ErrorKind::unsupported, "--lod: only a terrain has it");
    LandLod lod = requested;
    QuadtreeSettings& quadtree = lod.quadtree;
    quadtree.spacing = finest_spacing(lod.eye);
    if (terrain->is_placed()) {
        quadtree.edge = edge_of(terrain_domain(*terrain));
        quadtree.farthest = farthest_corner(lod.eye, *quadtree.edge) + quadtree.spacing;
    }
    if (lod.farthest) quadtree.farthest = *lod.farthest;
    const auto maps = draft.subject->open(draft.maps_options());
    constexpr double kCalm = 16.0;  // [m]; shorter waves are ignored in the eye's height
    const std::array<WorldPoint, 1> below = {{{lod.eye[0], lod.eye[1]}}};
    std::array<QuerySample, 1> ground{};
    terrain_of(*maps).function()->query(below, ground, kCalm, maps->pool());
    lod.ground = ground[0].height;
    const std::vector<LandPatch> patches = select(quadtree, lod.view(), {});
    if (patches.empty()) {
        refuse("--lod: no land lies within --farthest of the eye");
    }
    for (const LandPatch& patch : patches) {
        const auto side = static_cast<std::uint64_t>(patch.quads(quadtree)) + 1;
        lod.max_vertices += side * side;
    }
    lod.max_triangles = triangles_of(quadtree, patches);
    // The estimate includes the vertices in the order of their patches.
    lod.work_bytes =
        land_mesh_bytes(quadtree, patches, kNormalValues) + lod.max_vertices * sizeof(std::size_t);
    return lod;
}

std::string land_lod_note(const LandLod& lod) {
    return "at most " + std::to_string(lod.max_triangles) + " triangles, up to " +
           fixed_text(lod.quadtree.farthest, 0) + " m from the eye";
}

std::vector<io::HeaderString> land_lod_strings(const LandLod& lod) {
    const auto number = [](double value) { return shortest_text(value); };
    std::vector<io::HeaderString> strings = {{"ocean:lod", joined(lod.eye, ",", number)}};
    if (lod.farthest) strings.push_back({"ocean:farthest", shortest_text(*lod.farthest)});
    return strings;
}

io::Mesh make_land_lod_mesh(SubjectMaps& source, const LandLod& lod,
                            std::span<const Product* const> products, io::Faces faces) {
    const std::shared_ptr<const LandFunction> function = terrain_of(source).function();
    ThreadPool& pool = source.pool();
    const std::vector<LandPatch> patches = select(lod.quadtree, lod.view(), {});
    const bool has_normals =
        std::ranges::find(products, "normal", &Product::name) != products.end();
    const LandMesh land =
        make_land_mesh(lod.quadtree, patches, lod.view(), sampler_of(*function, pool, has_normals),
                       has_normals ? kNormalValues : 0);
    io::Mesh mesh;
    for (const Position& position : land.positions) {
        for (const double value : position) mesh.positions.push_back(static_cast<float>(value));
    }
    if (faces == io::Faces::triangles) {
        for (const auto& triangle : land.triangles) {
            for (const std::uint32_t v : triangle) mesh.triangles.push_back(static_cast<int>(v));
        }
        io::Attribute uv{.name = std::string(io::kUv), .components = 2};
        const Domain& domain = function->domain();
        for (const Position& position : land.positions) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
                uv.values.push_back(
                    static_cast<float>((position[axis] - domain.origin[axis]) / domain.size[axis]));
            }
        }
        mesh.attributes.push_back(std::move(uv));
    }
    if (has_normals) mesh.normals = unit_normals(land.values);
    add_masks(*function, lod, patches, land, products, pool, mesh);
    return mesh;
}

}  // namespace ocean
