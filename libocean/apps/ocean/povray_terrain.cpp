// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean povray` for a terrain: a map, in the format mesh2 also the mesh as a text, and the files
// beside them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "console_host.hpp"
#include "ocean/domain.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrainfile.hpp"
#include "povray_files.hpp"
#include "subject_argument.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr std::string_view kMapName = "land";

/// Returns the plans of the folder's maps: the map that the macros read, then the text of the mesh.
std::vector<BakePlan> make_plans(const PovrayTerrainRequest& request, const Context& context) {
    BakeOptions options = request.bake;
    options.threads = context.options.threads;
    const bool is_image = request.format == "height_field";
    if (!is_image) {
        options.max_resolution = kMaxPovrayResolution;
        options.format_options["far-maps"] = "yes";
        options.format_options["mask-map"] = "yes";
    }
    const std::optional<Region> region = parse_region(request.region);
    if (region && !options.resolution.empty()) {
        throw Error(ErrorKind::invalid_value,
                    "--region: its samples are those of --cell, and "
                    "--resolution is for a whole land");
    }
    // A region has the samples of its cell.
    if (region) options.max_resolution = 0;
    options.open_subject = [&request, &region](const std::string& source) {
        TerrainModel terrain = open_terrain({source, request.assignments});
        if (region) return make_region_subject(std::move(terrain), *region);
        return make_subject(std::move(terrain));
    };
    std::vector<std::string> formats = {is_image ? request.format : "df3"};
    if (request.format == "mesh2") formats.push_back(request.format);
    std::vector<BakePlan> plans;
    for (const std::string& format : formats) {
        if (format != "df3") {
            options.format_options.erase("far-maps");
            options.format_options.erase("mask-map");
        }
        options.output = request.folder + "/" + std::string(kMapName) + povray_extension(format);
        plans.push_back(make_bake_plan(options, standard_catalogue()));
        if (is_image) continue;
        const int samples = plans.back().resolution;
        if (region && samples > kMaxPovrayResolution) {
            throw Error(ErrorKind::invalid_value,
                        format_text("--region: it has %d samples along its longer side; allowed "
                                    "are at most %d, for which POV-Ray makes a mesh of 2 GiB",
                                    samples, kMaxPovrayResolution));
        }
        refuse_large_mesh(samples);
    }
    return plans;
}

/// Reports the cost of POV-Ray's forms of the land, measured at 1024^2 samples.
void report_cost(const PovrayTerrainRequest& request, const BakePlan& plan, Console& console) {
    const auto [columns, rows] = io::patch_vertices(plan.domain());
    const double vertices = static_cast<double>(columns) * rows;
    double vertex_seconds = 10e-6;
    if (request.format == "mesh2") vertex_seconds = 6.5e-6;
    if (request.format == "height_field") vertex_seconds = 14e-6;
    const double mesh_bytes = 500.0 * vertices, mesh_seconds = vertex_seconds * vertices;
    const double field_bytes = 10.0 * vertices;
    std::string text = "POV-Ray will need about " +
                       bytes_text(static_cast<std::uint64_t>(field_bytes)) +
                       " for Terrain_Height_Field";
    if (request.format != "height_field" || plan.resolution <= kMaxPovrayResolution) {
        text += ", and " + bytes_text(static_cast<std::uint64_t>(mesh_bytes)) +
                format_text(" and %.0f s to read a Terrain_Mesh", std::ceil(mesh_seconds));
    }
    console.report("povray", text,
                   {{"povray_memory_bytes", Json(mesh_bytes, decimals<0>)},
                    {"povray_parse_seconds", Json(mesh_seconds, decimals<1>)},
                    {"height_field_memory_bytes", Json(field_bytes, decimals<0>)}});
}

}  // namespace

void write_povray_terrain(const PovrayTerrainRequest& request, const Context& context) {
    const std::vector<BakePlan> plans = make_plans(request, context);
    const BakePlan& plan = plans.front();
    const TerrainModel& terrain = *find_terrain(*plan.subject);
    Terrain land(terrain, {.threads = plan.threads});
    const std::vector<FolderFile> files = povray_terrain_files(plan, land.state(), request.format);
    const InputFiles inputs(request.bake.source, plan.subject->named_files());
    refuse_folder_of(request.folder, "ocean.ini", "a sea", "a terrain");
    refuse_to_replace_others(files, request.folder, inputs);
    for (const BakePlan& one : plans) {
        for (const std::string& path : paths_that_may_exist(one)) inputs.spare(path);
    }
    io::require_folder(request.folder);
    report_cost(request, plan, context.console);
    PovrayFolderWork work{request.folder, files, plan, {}};
    for (const BakePlan& one : plans) work.plans.push_back(&one);
    write_folder(work, request.dry_run, context);
}

}  // namespace ocean::app
