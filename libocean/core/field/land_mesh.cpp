// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The patches of a view as one mesh. Equal vertices of neighbouring patches are found by the bits
// of their positions: a border that is not closed stays open instead of being hidden.
#include "ocean/internal/land_mesh.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "ocean/error.hpp"

namespace ocean {
namespace {

using Position = std::array<double, 3>;

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

/// The vertices of a patch by their indices.
struct PatchLattice {
    std::int64_t i0, j0;
    int quads;

    PatchLattice(const QuadtreeSettings& settings, const LandPatch& patch)
        : i0(patch.i * patch.quads(settings)),
          j0(patch.j * patch.quads(settings)),
          quads(patch.quads(settings)) {}

    std::size_t side() const { return static_cast<std::size_t>(quads) + 1; }
    std::size_t count() const { return side() * side(); }
    LandIndex index(int i, int j) const { return {i0 + i, j0 + j}; }
    /// Returns the index, in the patch, of a vertex of the next level that is given by an index of
    /// this level.
    std::size_t parent(LandIndex v) const {
        const auto i = static_cast<std::size_t>((v.i - i0) / 2);
        const auto j = static_cast<std::size_t>((v.j - j0) / 2);
        return j * (side() / 2 + 1) + i;
    }
};

/// Makes vertices of equal positions one.
class Welder {
  public:
    Welder(std::uint64_t max_vertices, std::vector<Position>& positions)
        : slots_(std::bit_ceil(max_vertices + max_vertices / 2 + 1), kNoVertex),
          positions_(positions) {}

    static std::uint64_t bytes(std::uint64_t max_vertices) {
        return std::bit_ceil(max_vertices + max_vertices / 2 + 1) * sizeof(std::uint32_t);
    }

    std::uint32_t weld(const Position& position) {
        std::uint32_t& slot = slot_of(position);
        if (slot == kNoVertex) {
            slot = static_cast<std::uint32_t>(positions_.size());
            positions_.push_back(position);
        }
        return slot;
    }
    /// Returns the vertex of a position; kNoVertex if there is none.
    std::uint32_t find(const Position& position) { return slot_of(position); }

  private:
    /// Returns the slot of a position, or the free slot where it belongs.
    std::uint32_t& slot_of(const Position& position) {
        for (std::uint64_t at = hash(position);; ++at) {
            std::uint32_t& slot = slots_[at & (slots_.size() - 1)];
            if (slot == kNoVertex || positions_[slot] == position) return slot;
        }
    }
    /// Returns a mixed number of the bits [Steele 2014].
    static std::uint64_t hash(const Position& position) {
        std::uint64_t h = 0;
        for (const double value : position) {
            h = (h ^ std::bit_cast<std::uint64_t>(value)) + 0x9e3779b97f4a7c15ull;
            h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
            h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
            h ^= h >> 31;
        }
        return h;
    }

    std::vector<std::uint32_t> slots_;
    std::vector<Position>& positions_;
};

std::uint64_t vertices_of(const QuadtreeSettings& settings, std::span<const LandPatch> patches) {
    std::uint64_t vertices = 0;
    for (const LandPatch& patch : patches) vertices += PatchLattice(settings, patch).count();
    return vertices;
}

/// The vertices of a patch as a view shows them.
struct PlacedPatch {
    std::vector<Position> positions;
    std::vector<bool> is_at_label;  // a vertex stands at its own label
    std::vector<float> values;      // further values
};

PlacedPatch placed(const QuadtreeSettings& settings, const LandView& view, const LandPatch& patch,
                   const HeightSampler& sampler, std::size_t further_values) {
    const PatchLattice lattice(settings, patch);
    const std::size_t width = 1 + further_values;
    std::vector<LandVertex> vertices;
    std::vector<WorldPoint> labels, coarse_labels;
    bool has_fine = false, has_coarse = false;
    for (int j = 0; j <= lattice.quads; ++j) {
        for (int i = 0; i <= lattice.quads; ++i) {
            const LandVertex vertex = land_vertex(settings, view, patch.level, lattice.index(i, j));
            has_fine |= vertex.share < 1.0;
            has_coarse |= vertex.share > 0.0;
            vertices.push_back(vertex);
            labels.push_back(vertex.label);
            // Even vertices share their labels with vertices of the next level.
            if (i % 2 == 0 && j % 2 == 0) coarse_labels.push_back(vertex.label);
        }
    }
    std::vector<float> own(width * labels.size()), coarse(width * coarse_labels.size());
    const double spacing = settings.spacing_of(patch.level);
    if (has_fine) sampler(labels, spacing, own);
    if (has_coarse) sampler(coarse_labels, 2.0 * spacing, coarse);
    PlacedPatch result;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const LandVertex& vertex = vertices[v];
        const float* const here = &own[width * v];
        const float* const first = &coarse[width * lattice.parent(vertex.parents[0])];
        const float* const second = &coarse[width * lattice.parent(vertex.parents[1])];
        const double z = vertex.height(*here, *first, *second);
        result.positions.push_back({vertex.shown.x + 0.0, vertex.shown.y + 0.0, z + 0.0});  // no -0
        result.is_at_label.push_back(vertex.shown.x == vertex.label.x &&
                                     vertex.shown.y == vertex.label.y);
        const auto share = static_cast<float>(vertex.share);
        for (std::size_t c = 1; c < width; ++c) {
            const float ends = first[c] + second[c];
            result.values.push_back((1.0f - share) * here[c] + 0.5f * share * ends + 0.0f);
        }
    }
    return result;
}

}  // namespace

std::uint64_t land_mesh_bytes(const QuadtreeSettings& settings, std::span<const LandPatch> patches,
                              int further_values) {
    const std::uint64_t vertices = vertices_of(settings, patches);
    const std::uint64_t triangles = triangles_of(settings, patches);
    const std::uint64_t vertex = sizeof(Position) + sizeof(LandPlace) + 1 +
                                 static_cast<std::uint64_t>(further_values) * sizeof(float);
    // Vectors that grow hold up to three times their elements while they are copied.
    return 3 * (vertices * vertex + triangles * sizeof(std::array<std::uint32_t, 3>)) +
           Welder::bytes(vertices);
}

LandMesh make_land_mesh(const QuadtreeSettings& settings, std::span<const LandPatch> patches,
                        const LandView& view, const HeightSampler& sampler, int further_values) {
    validate(settings);
    const std::uint64_t max_vertices = vertices_of(settings, patches);
    if (max_vertices >= kNoVertex) {
        throw Error(ErrorKind::invalid_value,
                    ErrorFields{.what = "have too many vertices", .parameter = "patches"});
    }
    const auto further = static_cast<std::size_t>(further_values);
    LandMesh mesh;
    Welder welder(max_vertices, mesh.positions);
    PlacedPatch shown;
    std::vector<std::uint32_t> welded;  // vertex of the mesh for each of the patch
    std::vector<bool> is_at_label;      // for each of `places`
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        const Position &p = shown.positions[a], &q = shown.positions[b], &r = shown.positions[c];
        if (p == q || q == r || r == p) return;
        for (const std::size_t v : {a, b, c}) {
            if (welded[v] == kNoVertex) welded[v] = welder.weld(shown.positions[v]);
        }
        mesh.triangles.push_back({welded[a], welded[b], welded[c]});
    };
    // A vertex to which others have snapped may itself be in no triangle.
    const auto enter = [&](std::uint32_t patch, std::size_t v) {
        const std::uint32_t at =
            welded[v] != kNoVertex ? welded[v] : welder.find(shown.positions[v]);
        if (at == kNoVertex) return;
        const bool is_new = mesh.places[at].patch == kNoVertex;
        if (!is_new && (is_at_label[at] || !shown.is_at_label[v])) return;
        mesh.places[at] = {patch, static_cast<std::uint32_t>(v)};
        is_at_label[at] = shown.is_at_label[v];
        std::copy_n(shown.values.data() + further * v, further, mesh.values.data() + further * at);
    };
    for (std::uint32_t patch = 0; patch < patches.size(); ++patch) {
        const PatchLattice lattice(settings, patches[patch]);
        shown = placed(settings, view, patches[patch], sampler, further);
        welded.assign(lattice.count(), kNoVertex);
        for (int j = 0; j < lattice.quads; ++j) {
            for (int i = 0; i < lattice.quads; ++i) {
                const std::size_t low =
                    static_cast<std::size_t>(j) * lattice.side() + static_cast<std::size_t>(i);
                const std::size_t high = low + lattice.side();
                add(low, low + 1, high + 1);
                add(low, high + 1, high);
            }
        }
        mesh.places.resize(mesh.positions.size(), {kNoVertex, kNoVertex});
        mesh.values.resize(further * mesh.positions.size());
        is_at_label.resize(mesh.positions.size());
        for (std::size_t v = 0; v < welded.size(); ++v) enter(patch, v);
    }
    return mesh;
}

}  // namespace ocean
