// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean_terrain_mesh: the quadtree of a land around a camera, as one mesh.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "guard.hpp"
#include "ocean/internal/land_mesh.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_function.hpp"
#include "terrain_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

QuadtreeSettings settings_of(const ocean_mesh_request& asked, const Domain& land) {
    QuadtreeSettings settings;
    if (asked.spacing != 0.0) settings.spacing = asked.spacing;
    if (asked.range != 0.0) settings.range = asked.range;
    settings.farthest = asked.farthest;
    if (!land.wraps) {
        settings.edge =
            LandEdge{land.origin, {land.origin[0] + land.size[0], land.origin[1] + land.size[1]}};
    }
    return settings;
}

bool has_counts(const std::optional<CountedMesh>& kept, const QuadtreeSettings& settings,
                const LandView& view) {
    if (!kept || kept->eye != view.eye || kept->ground != view.ground) return false;
    const QuadtreeSettings& of = kept->settings;
    return of.spacing == settings.spacing && of.range == settings.range &&
           of.farthest == settings.farthest && of.edge == settings.edge;
}

LandMesh make_mesh(Terrain& land, const QuadtreeSettings& settings, const LandView& view) {
    const std::vector<LandPatch> patches = select(settings, view, {});
    require_memory(land_mesh_bytes(settings, patches), "the mesh",
                   "choose a smaller distance or a larger spacing");
    const auto function = land.function();
    std::vector<QuerySample> answers;
    const auto sampler = [&](std::span<const WorldPoint> points, double spacing,
                             std::span<float> heights) {
        answers.resize(points.size());
        function->query(points, answers, spacing, land.pool());
        std::ranges::transform(answers, heights.begin(), [](const QuerySample& answer) {
            return static_cast<float>(answer.height);
        });
    };
    return make_land_mesh(settings, patches, view, sampler);
}

}  // namespace

ocean_result ocean_terrain_mesh(ocean_terrain* terrain, const ocean_mesh_request* request,
                                size_t* vertices, size_t* triangles) {
    return in_handle(terrain, [&] {
        require(request, "request");
        require(vertices, "vertices");
        require(triangles, "triangles");
        const auto asked = read_struct(request, sizeof(ocean_mesh_request), "ocean_mesh_request");
        if ((asked.positions == nullptr) != (asked.corners == nullptr)) {
            refuse("positions and corners: pass both, or NULL for both to get the counts");
        }
        const QuadtreeSettings settings = settings_of(asked, terrain->land->domain());
        const LandView view{{asked.x, asked.y, asked.z}, asked.ground, {}};
        if (!has_counts(terrain->mesh, settings, view)) {
            terrain->mesh.reset();
            LandMesh mesh = make_mesh(*terrain->land, settings, view);
            terrain->mesh = CountedMesh{settings, view.eye, view.ground, std::move(mesh)};
        }
        const LandMesh& mesh = terrain->mesh->mesh;
        if (asked.positions != nullptr) {
            const auto require_room = [](const char* name, std::size_t given, std::size_t needed) {
                require_capacity(name, given, needed, "this mesh needs " + std::to_string(needed));
            };
            require_room("vertex_capacity", asked.vertex_capacity, mesh.positions.size());
            require_room("triangle_capacity", asked.triangle_capacity, mesh.triangles.size());
        }
        *vertices = mesh.positions.size();
        *triangles = mesh.triangles.size();
        if (asked.positions == nullptr) return;
        double* to = asked.positions;
        for (const auto& position : mesh.positions) to = std::ranges::copy(position, to).out;
        uint32_t* corner = asked.corners;
        for (const auto& triangle : mesh.triangles) {
            corner = std::ranges::copy(triangle, corner).out;
        }
        terrain->mesh.reset();
    });
}
