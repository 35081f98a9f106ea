// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The handle of a terrain and the functions of libocean.h for it: each one a call into core or
// seafile, with its arguments checked and its result copied out.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "guard.hpp"
#include "handle_functions.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/land_mesh.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/terrain_stages.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_function.hpp"
#include "ocean/provenance.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"
#include "outputs.hpp"
#include "query_buffers.hpp"
#include "sea_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

/// A mesh whose counts the host knows.
struct CountedMesh {
    QuadtreeSettings settings;
    std::array<double, 3> eye{};
    double ground = 0.0;
    LandMesh mesh;
};

}  // namespace

struct ocean_terrain : ocean::capi::Handle {
    static constexpr const char* kName = "terrain";
    ocean_terrain(ocean::TerrainModel terrain, ocean::TerrainOptions opened_with,
                  std::string folder)
        : options(std::move(opened_with)),
          base_dir(std::move(folder)),
          land(std::make_unique<ocean::Terrain>(std::move(terrain), options)) {}
    ocean_terrain(const ocean_terrain& built, ocean::TerrainOptions opened_with)
        : options(std::move(opened_with)),
          base_dir(built.base_dir),
          land(std::make_unique<ocean::Terrain>(*built.land, options)) {}

    ocean::TerrainOptions options;
    std::string base_dir;                  // where a relative `measured` starts
    std::unique_ptr<ocean::Terrain> land;  // readers may make it build what they ask for
    std::vector<ocean::MapOutput> map_outputs;
    /// That of the last call for counts, until it is copied.
    std::optional<CountedMesh> mesh;
};

namespace {

TerrainOptions terrain_options(const ocean_options* given) {
    OceanOptions options = read_options(given);
    return {.threads = options.threads,
            .run_jobs = std::move(options.run_jobs),
            .backend = options.backend,
            .interrupt = std::move(options.interrupt),
            .progress = std::move(options.build_progress)};
}

TerrainStep step_named(std::string_view word) {
    if (const auto found = enumerator_of<TerrainStep>(word)) return *found;
    refuse({.parameter = "step",
            .value = std::string(word),
            .allowed = "noise, transform, filter, filtered, height"});
}

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

/// The calls by which a terrain differs in the functions of handle_functions.hpp.
template <>
struct ocean::capi::Family<ocean_terrain> {
    static constexpr auto read_options = terrain_options;
    static constexpr auto read = read_terrain;
    static constexpr auto parse = parse_terrain;
    static constexpr auto text = write_terrain;
    static constexpr auto presets = terrain_presets;
    static constexpr auto find_preset = find_terrain_preset;
    static const TerrainModel& model(const ocean_terrain& handle) { return handle.land->model(); }
    static auto& parameters(auto& terrain) { return terrain; }
    static void replace(ocean_terrain& handle, TerrainModel terrain) {
        handle.land->set_model(std::move(terrain));
        handle.mesh.reset();
    }
    static std::string state(const ocean_terrain& handle) {
        return terrain_state_json(handle.land->state());
    }
};

ocean_result ocean_terrain_open(const char* path, const ocean_options* options,
                                ocean_terrain** out) {
    return open_handle(path, options, out);
}

ocean_result ocean_terrain_parse(const char* toml, size_t length, const char* base_dir,
                                 const ocean_options* options, ocean_terrain** out) {
    return parse_handle(toml, length, base_dir, options, out);
}

ocean_result ocean_terrain_clone(const ocean_terrain* terrain, const ocean_options* options,
                                 ocean_terrain** out) {
    return clone_handle(terrain, options, out);
}

void ocean_terrain_free(ocean_terrain* terrain) {
    free_handle(terrain);
}

ocean_result ocean_terrain_set(ocean_terrain* terrain, const char* name, const char* value) {
    return set_value(terrain, name, value);
}

ocean_result ocean_terrain_set_all(ocean_terrain* terrain, const char* const* names,
                                   const char* const* values, size_t count) {
    return set_values(terrain, names, values, count);
}

ocean_result ocean_terrain_get(const ocean_terrain* terrain, const char* name, char* out,
                               size_t size) {
    return get_value(terrain, name, out, size);
}

ocean_result ocean_terrain_text(const ocean_terrain* terrain, char* out, size_t* size) {
    return write_text(terrain, out, size);
}

ocean_result ocean_terrain_state_json(const ocean_terrain* terrain, char* out, size_t* size) {
    return write_state(terrain, out, size);
}

ocean_result ocean_terrain_parameters_json(char* out, size_t* size) {
    return guarded([&] { copy_text(parameters_json(listed(terrain_table())), out, size); });
}

ocean_result ocean_terrain_preset(const char* name, char* out, size_t* size) {
    return write_preset<ocean_terrain>(name, out, size);
}

ocean_result ocean_terrain_provenance_json(const ocean_terrain* terrain, const char* field,
                                           int32_t axes, char* out, size_t* size) {
    return in_handle(terrain, [&] {
        const TerrainModel& open = terrain->land->model();
        auto strings = provenance_strings({.kind = std::string(kTerrainKind),
                                           .text = write_terrain(open),
                                           .frame = 1,
                                           .time = 0.0,
                                           .domain = terrain->land->domain(),
                                           .backend = std::string(terrain->options.backend.name)});
        if (field != nullptr) {
            const Product* const product[] = {&find_product(field)};
            for (HeaderString& string : product_strings(product, axes_name(axes))) {
                strings.push_back(std::move(string));
            }
        }
        JsonObject json;
        for (const HeaderString& string : strings) json.add(string.name, string.text);
        copy_text(json.text(), out, size);
    });
}

ocean_result ocean_terrain_evaluate(ocean_terrain* terrain, const ocean_request* request) {
    return in_handle(terrain, [&] {
        const ocean_request asked =
            read_struct(request, offsetof(ocean_request, output_size), "ocean_request");
        require_reserved(asked.cascade, "cascade");
        require_reserved(asked.reserved, "reserved");
        const int resolution = map_resolution(asked.resolution, terrain->land->domain().samples[0]);
        std::vector<MapOutput>& maps = terrain->map_outputs;
        read_outputs(asked, request->struct_size, resolution, maps);
        terrain->land->surface_into(maps, resolution);
    });
}

ocean_result ocean_terrain_domain(const ocean_terrain* terrain, ocean_domain* domain) {
    return in_handle(terrain, [&] { write_domain(terrain->land->domain(), domain); });
}

ocean_result ocean_terrain_region(ocean_terrain* terrain, const ocean_region_request* request) {
    return in_handle(terrain, [&] {
        std::vector<MapOutput>& maps = terrain->map_outputs;
        const Domain region = read_region(request, maps);
        terrain->land->region_into(region, maps);
    });
}

ocean_result ocean_terrain_query_points(ocean_terrain* terrain,
                                        const ocean_query_request* request) {
    return in_handle(terrain, [&] {
        const ocean_query_request asked =
            read_struct(request, offsetof(ocean_query_request, resolution), "ocean_query_request");
        Terrain& land = *terrain->land;
        answer_points(
            asked, false,
            [&](auto points, auto answers, const QueryOptions& options) {
                land.query(points, answers, options);
            },
            [&](const QueryOptions& options) { return land.query_height_error(options); });
    });
}

ocean_result ocean_terrain_stage(ocean_terrain* terrain, const char* step, float* data,
                                 size_t count) {
    return in_handle(terrain, [&] {
        require(step, "step");
        require(data, "data");
        const TerrainStep wanted = step_named(step);
        const auto side = static_cast<std::size_t>(terrain->land->model().resolution);
        if (count < side * side) {
            refuse("count = " + std::to_string(count) + "; a step of " + std::to_string(side) +
                   " x " + std::to_string(side) + " samples needs " + std::to_string(side * side));
        }
        std::ranges::copy(plane_of(terrain_stages(*terrain->land), wanted), data);
    });
}

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
