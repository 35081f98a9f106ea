// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions of libocean.h for terrains: each one a call into core or seafile, with its
// arguments checked and its result copied out.
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "guard.hpp"
#include "handle_functions.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/terrain_stages.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/provenance.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"
#include "outputs.hpp"
#include "query_buffers.hpp"
#include "sea_handle.hpp"
#include "terrain_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

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
        require(request, "request");
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
    return in_handle(terrain, [&] {
        require(domain, "domain");
        require_struct_size(domain->struct_size, sizeof(ocean_domain), "struct_size",
                            "ocean_domain", sizeof(ocean_domain));
        const Domain own = terrain->land->domain();
        *domain = {.struct_size = sizeof(ocean_domain),
                   .x = own.origin[0],
                   .y = own.origin[1],
                   .cell = own.step(0),
                   .columns = own.samples[0],
                   .rows = own.samples[1],
                   .wraps = own.wraps ? 1 : 0,
                   .reserved = 0};
    });
}

ocean_result ocean_terrain_region(ocean_terrain* terrain, const ocean_region_request* request) {
    return in_handle(terrain, [&] {
        require(request, "request");
        std::vector<MapOutput>& maps = terrain->map_outputs;
        const Domain region = read_region(*request, maps);
        terrain->land->region_into(region, maps);
    });
}

ocean_result ocean_terrain_query_points(ocean_terrain* terrain,
                                        const ocean_query_request* request) {
    return in_handle(terrain, [&] {
        require(request, "request");
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
