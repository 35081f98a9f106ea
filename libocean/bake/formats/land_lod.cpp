// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See land_lod.hpp. The mesh has no levels any more; normals and masks go through its patches once
// more, in the same order, and find its vertices by their positions.
#include "formats/land_lod.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <unordered_map>
#include <utility>

#include "ocean/bake/typed_format.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/land.hpp"
#include "ocean/land_field.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/land_mesh.hpp"
#include "ocean/terrain_subject.hpp"
#include "ocean/text.hpp"

namespace ocean {
namespace {

using Position = std::array<double, 3>;

constexpr const char* kEye = "lod EX,EY,EZ";
constexpr double kMaxEye = 1e7;  // [m]

struct PositionHash {
    std::size_t operator()(const Position& position) const {
        std::uint64_t h = 0;  // mixed as [Steele 2014]
        for (const double value : position) {
            h = (h ^ std::bit_cast<std::uint64_t>(value)) + 0x9e3779b97f4a7c15ull;
            h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
            h ^= h >> 27;
        }
        return static_cast<std::size_t>(h);
    }
};

/// Heights and normals of one call of the sampler.
struct Samples {
    std::vector<float> heights;
    std::vector<std::array<float, 3>> normals;
};

/// Samples a land and keeps what it returned, in the order of the calls.
class RecordingSampler {
  public:
    RecordingSampler(const LandField& field, ThreadPool& pool) : field_(field), pool_(pool) {}

    void operator()(std::span<const WorldPoint> points, double spacing, std::span<float> heights) {
        samples_.resize(points.size());
        field_.query(points, samples_, spacing, pool_);
        Samples kept;
        for (std::size_t i = 0; i < points.size(); ++i) {
            heights[i] = static_cast<float>(samples_[i].height);
            kept.heights.push_back(heights[i]);
            const auto& normal = samples_[i].normal;
            kept.normals.push_back({static_cast<float>(normal[0]), static_cast<float>(normal[1]),
                                    static_cast<float>(normal[2])});
        }
        calls_.push_back(std::move(kept));
    }

    /// Returns the next call, from the first one on.
    const Samples& replay() { return calls_[next_++]; }

  private:
    const LandField& field_;
    ThreadPool& pool_;
    std::vector<QuerySample> samples_;
    std::vector<Samples> calls_;
    std::size_t next_ = 0;
};

/// The vertices of a patch, as place_patch of ocean/land_mesh.hpp goes through them.
struct PatchVertices {
    std::vector<LandVertex> vertices;
    std::vector<LandIndex> indices;
    bool has_fine = false, has_coarse = false;
    int side = 0;

    PatchVertices(const LandLod& lod, const LandPatch& patch)
        : side(patch.quads(lod.quadtree) + 1) {
        const std::int64_t quads = side - 1;
        for (std::int64_t j = patch.j * quads; j <= patch.j * quads + quads; ++j) {
            for (std::int64_t i = patch.i * quads; i <= patch.i * quads + quads; ++i) {
                indices.push_back({i, j});
                vertices.push_back(land_vertex(lod.quadtree, lod.view(), patch.level, {i, j}));
                has_fine |= vertices.back().share < 1.0;
                has_coarse |= vertices.back().share > 0.0;
            }
        }
    }
    /// Returns the place of a parent among the samples of the next level.
    std::size_t parent(LandIndex index) const {
        const LandIndex first = indices.front();
        const std::int64_t coarse_side = (side + 1) / 2;
        return static_cast<std::size_t>((index.j - first.j) / 2 * coarse_side +
                                        (index.i - first.i) / 2);
    }
};

/// The values of a mesh's vertices, each set by the patch that shows it where its level has it.
class VertexValues {
  public:
    explicit VertexValues(const LandMesh& mesh) : mesh_(mesh), is_set_(mesh.positions.size()) {
        index_.reserve(mesh.positions.size());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) index_[mesh.positions[v]] = v;
    }
    /// Returns the vertex of a position that still wants a value; `exact`: at its own label.
    /// Returns the count of vertices if there is none.
    std::size_t wanting(const Position& position, bool exact) {
        const auto found = index_.find(position);
        if (found == index_.end()) return mesh_.positions.size();
        const int rank = exact ? 2 : 1;
        if (is_set_[found->second] >= rank) return mesh_.positions.size();
        is_set_[found->second] = rank;
        return found->second;
    }

  private:
    const LandMesh& mesh_;
    std::unordered_map<Position, std::size_t, PositionHash> index_;
    std::vector<int> is_set_;
};

/// Returns the maps of a patch's masks, at its vertices.
Surface masks_of(const LandField& field, const LandLod& lod, const LandPatch& patch,
                 ChannelSet masks, ThreadPool& pool) {
    const double spacing = lod.quadtree.spacing_of(patch.level);
    const int quads = patch.quads(lod.quadtree);
    const double side = quads * spacing;
    const Domain region{{static_cast<double>(patch.i) * side, static_cast<double>(patch.j) * side},
                        {side, side},
                        {quads + 1, quads + 1},
                        false};
    return field.surface(region, masks, pool);
}

std::array<float, 3> mixed_normal(const PatchVertices& patch, const LandVertex& vertex,
                                  std::size_t v, const Samples* own, const Samples* coarse) {
    std::array<float, 3> mean{};
    const auto share = static_cast<float>(vertex.share);
    for (std::size_t c = 0; c < 3; ++c) {
        if (own != nullptr) mean[c] += (1.0f - share) * own->normals[v][c];
        if (coarse == nullptr) continue;
        mean[c] += 0.5f * share *
                   (coarse->normals[patch.parent(vertex.parents[0])][c] +
                    coarse->normals[patch.parent(vertex.parents[1])][c]);
    }
    const float length = std::sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
    for (float& component : mean) component /= length;
    return mean;
}

/// Returns the least spacing of vertices that floats tell apart around an eye, which files hold
/// positions as [m]: 0.5, more from 1e6 m from the origin on.
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
        throw Error(ErrorKind::invalid_value, "--lod " + typed + ": allowed is EX,EY,EZ in metres");
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
    const Terrain* const terrain = find_terrain(*draft.subject);
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
    constexpr double kCalm = 16.0;  // [m]: shorter waves do not count in the eye's height
    const std::array<WorldPoint, 1> below = {{{lod.eye[0], lod.eye[1]}}};
    std::array<QuerySample, 1> ground{};
    land_of(*maps).field()->query(below, ground, kCalm, maps->pool());
    lod.ground = ground[0].height;
    const std::vector<LandPatch> patches = select(quadtree, lod.view(), {});
    if (patches.empty()) {
        throw Error(ErrorKind::invalid_value, "--lod: no land lies within --farthest of the eye");
    }
    for (const LandPatch& patch : patches) {
        const auto side = static_cast<std::uint64_t>(patch.quads(quadtree)) + 1;
        lod.max_vertices += side * side;
    }
    lod.max_triangles = triangles_of(quadtree, patches);
    // Samples of the field, and the index of the vertices.
    lod.work_bytes = land_mesh_bytes(quadtree, patches) + lod.max_vertices * (2 * 16 + 64);
    return lod;
}

std::string land_lod_note(const LandLod& lod) {
    return "at most " + std::to_string(lod.max_triangles) + " triangles, up to " +
           fixed_text(lod.quadtree.farthest, 0) + " m from the eye";
}

std::vector<io::HeaderString> land_lod_strings(const LandLod& lod) {
    std::string eye;
    for (const double value : lod.eye) eye += (eye.empty() ? "" : ",") + shortest_text(value);
    std::vector<io::HeaderString> strings = {{"ocean:lod", eye}};
    if (lod.farthest) strings.push_back({"ocean:farthest", shortest_text(*lod.farthest)});
    return strings;
}

io::Mesh make_land_lod_mesh(SubjectMaps& source, const LandLod& lod,
                            std::span<const Product* const> products, io::Faces faces) {
    const std::shared_ptr<const LandField> field = land_of(source).field();
    ThreadPool& pool = source.pool();
    const std::vector<LandPatch> patches = select(lod.quadtree, lod.view(), {});
    RecordingSampler sampler(*field, pool);
    const LandMesh land =
        make_land_mesh(lod.quadtree, patches, lod.view(),
                       [&](std::span<const WorldPoint> points, double spacing,
                           std::span<float> heights) { sampler(points, spacing, heights); });
    const std::size_t count = land.positions.size();
    io::Mesh mesh;
    for (const Position& position : land.positions) {
        for (const double value : position) mesh.positions.push_back(static_cast<float>(value));
    }
    if (faces == io::Faces::triangles) {
        for (const auto& triangle : land.triangles) {
            for (const std::uint32_t v : triangle) mesh.triangles.push_back(static_cast<int>(v));
        }
        io::Attribute uv{.name = std::string(io::kUv), .components = 2};
        const Domain& domain = field->domain();
        for (const Position& position : land.positions) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
                uv.values.push_back(
                    static_cast<float>((position[axis] - domain.origin[axis]) / domain.size[axis]));
            }
        }
        mesh.attributes.push_back(std::move(uv));
    }
    if (products.empty()) return mesh;
    ChannelSet masks;
    std::vector<std::pair<Channel, std::size_t>> columns;  // a mask, its attribute
    for (const Product* product : products) {
        if (product->name == "normal") {
            mesh.normals.resize(3 * count);
            continue;
        }
        masks = masks | product->set();
        columns.emplace_back(product->channels[0], mesh.attributes.size());
        mesh.attributes.push_back({std::string(product->name), 1, std::vector<float>(count)});
    }
    VertexValues values(land);
    std::vector<Position> positions;
    for (const LandPatch& patch : patches) {
        const PatchVertices lattice(lod, patch);
        const Samples* const own = lattice.has_fine ? &sampler.replay() : nullptr;
        const Samples* const coarse = lattice.has_coarse ? &sampler.replay() : nullptr;
        Surface maps;
        if (masks.size() > 0) maps = masks_of(*field, lod, patch, masks, pool);
        for (std::size_t v = 0; v < lattice.vertices.size(); ++v) {
            const LandVertex& vertex = lattice.vertices[v];
            const double z = vertex.height(
                own != nullptr ? own->heights[v] : 0.0f,
                coarse != nullptr ? coarse->heights[lattice.parent(vertex.parents[0])] : 0.0f,
                coarse != nullptr ? coarse->heights[lattice.parent(vertex.parents[1])] : 0.0f);
            const bool exact = vertex.shown.x == vertex.label.x && vertex.shown.y == vertex.label.y;
            const std::size_t at =
                values.wanting({vertex.shown.x + 0.0, vertex.shown.y + 0.0, z + 0.0}, exact);
            if (at == count) continue;
            if (!mesh.normals.empty()) {
                const auto normal = mixed_normal(lattice, vertex, v, own, coarse);
                std::ranges::copy(normal,
                                  mesh.normals.begin() + static_cast<std::ptrdiff_t>(3 * at));
            }
            for (const auto& [channel, column] : columns) {
                mesh.attributes[column].values[at] = maps.channel(channel)[v];
            }
        }
    }
    return mesh;
}

}  // namespace ocean
