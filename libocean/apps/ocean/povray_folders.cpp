// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The folders of seas, coasts and terrains; see povray_folders.hpp.
#include "povray_folders.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "ocean/bake/catalogue.hpp"
#include "ocean/domain.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/ocean.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrainfile.hpp"
#include "text.hpp"
#include "user_files.hpp"

namespace ocean::app {
namespace {

/// The max of samples along a side for which POV-Ray makes a mesh.
constexpr int kMaxPovrayResolution = 2048;

/// Returns the extension of a format of the catalogue.
std::string extension_of(std::string_view format) {
    const auto formats = standard_catalogue().formats;
    const auto name_of = [](const BakeFormat* known) { return known->name; };
    return std::string((*std::ranges::find(formats, format, name_of))->extension);
}

/// Returns the options of the bake of a map with these options of its format.
BakeOptions map_options(const PovrayRequest& request, const std::string& name,
                        std::string_view format, const std::vector<const char*>& flags,
                        const Context& context) {
    BakeOptions options = request.bake;
    options.source = request.subject.source;
    options.output = request.folder + "/" + name + extension_of(format);
    options.threads = context.options.threads;
    options.max_resolution = kMaxPovrayResolution;
    for (const char* flag : flags) options.format_options[flag] = "yes";
    return options;
}

template <typename Open>
BakePlan plan_map(BakeOptions options, const Open& open) {
    options.open_subject = [&open](const std::string&) { return open(); };
    return make_bake_plan(options, standard_catalogue());
}

void refuse_large_mesh(int resolution) {
    if (resolution <= kMaxPovrayResolution) return;
    refuse(
        format_text("--resolution = %d: allowed is at most %d, for which POV-Ray makes "
                    "a mesh of 2 GiB",
                    resolution, kMaxPovrayResolution));
}

SeaState state_of(const BakePlan& plan) {
    return Ocean(sea_of(*plan.subject).parameters, {.threads = plan.threads}).state();
}

/// POV-Ray's cost of a mesh, with 500 bytes for a vertex, measured.
struct MeshCost {
    double bytes;
    double seconds;

    MeshCost(double vertices, double vertex_seconds)
        : bytes(500.0 * vertices), seconds(vertex_seconds * vertices) {}

    std::string text() const {
        return bytes_text(static_cast<std::uint64_t>(bytes)) +
               format_text(" and %.0f s to read a ", std::ceil(seconds));
    }
    Console::Members members() const {
        return {{"povray_memory_bytes", Json(bytes, decimals<0>)},
                {"povray_parse_seconds", Json(seconds, decimals<1>)}};
    }
};

/// Returns the whole subject or a region of it.
template <typename Model>
std::unique_ptr<Subject> part_of(const Model& model, const std::optional<Region>& region) {
    return region ? make_region_subject(model, *region) : make_subject(model);
}

PovrayFolder sea_folder(const PovrayRequest& request, const Sea& sea, const Context& context) {
    if (!request.region.region.empty() || !request.region.cell.empty()) {
        throw Error(
            ErrorKind::unsupported,
            "--region and --cell: only a terrain, a sea over a bed (water.seabed) and a sea "
            "with hulls have them, and this is an open sea");
    }
    const bool df3 = request.format == "df3";
    if (request.near_only && !df3) {
        refuse("--near-only: only --format df3 has coarser maps to leave out");
    }
    std::vector<const char*> flags;
    if (df3) flags = {"fine-map", "detail-map"};
    if (df3 && !request.near_only) flags.push_back("far-maps");
    if (request.format == "mesh2") flags = {"mesh-foam"};
    PovrayFolder folder;
    const BakePlan& plan = folder.plans.emplace_back(
        plan_map(map_options(request, "sea_####", request.format, flags, context),
                 [&] { return make_subject(sea); }));
    refuse_large_mesh(plan.resolution);
    const SeaState state = state_of(plan);
    folder.files = [state, path = request.folder](const auto& plans, const auto& frames) {
        return povray_folder_files(plans[0], state, frames, {path, cache_file("povray")});
    };
    folder.frame_lists = [state](const auto& plans, const auto& frames) {
        return povray_frame_lists(plans[0], state, frames);
    };
    if (request.format != "height_field") {
        const MeshCost mesh(std::pow(plan.resolution + 1.0, 2.0), 12e-6);
        folder.cost = {"POV-Ray will need about " + mesh.text() + "mesh of it", mesh.members()};
    }
    return folder;
}

/// Returns the sea without its bed and its hulls: what lies beside a region.
Sea open_sea_of(const Sea& sea) {
    Sea open = sea;
    open.parameters.hulls.clear();
    Water& water = open.parameters.water;
    const Water none;
    water.bed.reset();
    water.seabed.clear();
    water.seabed_origin.clear();
    water.seabed_unit = none.seabed_unit;
    water.seabed_sign = none.seabed_sign;
    water.level = none.level;
    water.shore = none.shore;
    return open;
}

/// Returns for each frame a map of a region, by default of the whole bed, and the maps of the open
/// sea beside it. A frame counts once its open sea is there: the region comes first.
PovrayFolder region_folder(const PovrayRequest& request, const Sea& sea, const Context& context) {
    if (request.format != "df3") {
        throw Error(
            ErrorKind::unsupported,
            "--format " + request.format + ": a sea " +
                (sea.parameters.water.bed ? "over a bed (water.seabed)" : "with hulls") +
                " has df3 alone, from which its water, its foam and its masks are read; `ocean "
                "bake --region` writes a mesh2");
    }
    std::vector<const char*> flags = {"detail-map"};
    if (!request.near_only) flags.push_back("far-maps");
    BakePlan open = plan_map(map_options(request, "sea_####", "df3", flags, context),
                             [&] { return make_subject(open_sea_of(sea)); });
    refuse_large_mesh(open.resolution);
    const std::optional<Region> part = parse_region(request.region);
    BakeOptions options = map_options(request, "coast_####", "df3", {"mask-map"}, context);
    options.resolution.clear();  // that of the open sea
    options.max_resolution = 0;
    BakePlan region = plan_map(options, [&] { return part_of(sea, part); });
    if (region.resolution > kMaxPovrayResolution) {
        refuse(format_text(
            "%s has %d samples along its longer side; allowed are at most %d: "
            "choose a part of it with --region and --cell",
            part ? "--region: it" : "the bed", region.resolution, kMaxPovrayResolution));
    }
    const SeaState state = state_of(open);
    PovrayFolder folder;
    folder.plans.push_back(std::move(region));
    folder.plans.push_back(std::move(open));
    folder.counted = 1;
    folder.files = [state, path = request.folder](const auto& plans, const auto& frames) {
        return povray_region_files({plans[1], plans[0]}, state, frames,
                                   {path, cache_file("povray")});
    };
    folder.frame_lists = [state](const auto& plans, const auto& frames) {
        return povray_region_frame_lists({plans[1], plans[0]}, state, frames);
    };
    return folder;
}

/// Returns the costs of POV-Ray's forms of a land, measured at 1024^2 samples.
PovrayCost land_cost(const std::string& format, const BakePlan& plan) {
    const auto [columns, rows] = io::patch_vertices(plan.domain());
    const double vertices = static_cast<double>(columns) * rows;
    const bool is_image = format == "height_field";
    const MeshCost mesh(vertices, is_image ? 14e-6 : format == "mesh2" ? 6.5e-6 : 10e-6);
    const double field_bytes = 10.0 * vertices;
    PovrayCost cost{"POV-Ray will need about " +
                        bytes_text(static_cast<std::uint64_t>(field_bytes)) +
                        " for Terrain_Height_Field",
                    mesh.members()};
    if (!is_image || plan.resolution <= kMaxPovrayResolution) {
        cost.text += ", and " + mesh.text() + "Terrain_Mesh";
    }
    cost.members.push_back({"height_field_memory_bytes", Json(field_bytes, decimals<0>)});
    return cost;
}

/// Returns the map that the macros read, and for mesh2 the text of the mesh.
PovrayFolder terrain_folder(const PovrayRequest& request, const TerrainModel& terrain,
                            const Context& context) {
    const bool is_image = request.format == "height_field";
    const std::optional<Region> region = parse_region(request.region);
    if (region && !request.bake.resolution.empty()) {
        refuse(
            "--region: its samples are those of --cell, and "
            "--resolution is for a whole land");
    }
    PovrayFolder folder;
    const auto add = [&](const std::string& format, const std::vector<const char*>& flags) {
        BakeOptions options = map_options(request, "land", format, flags, context);
        // An image may have any size, and a region has the samples of its cell.
        if (is_image || region) options.max_resolution = 0;
        const BakePlan& plan =
            folder.plans.emplace_back(plan_map(options, [&] { return part_of(terrain, region); }));
        if (is_image) return;
        if (region && plan.resolution > kMaxPovrayResolution) {
            refuse(
                format_text("--region: it has %d samples along its longer side; allowed "
                            "are at most %d, for which POV-Ray makes a mesh of 2 GiB",
                            plan.resolution, kMaxPovrayResolution));
        }
        refuse_large_mesh(plan.resolution);
    };
    if (is_image) {
        add(request.format, {});
    } else {
        add("df3", {"far-maps", "mask-map"});
    }
    if (request.format == "mesh2") add(request.format, {});
    const BakePlan& map = folder.plans[0];
    const TerrainState state =
        Terrain(*find_terrain(*map.subject), {.threads = map.threads}).state();
    folder.files = [state, format = request.format](const auto& plans, const auto&) {
        return povray_terrain_files(plans[0], state, format);
    };
    folder.cost = land_cost(request.format, map);
    return folder;
}

/// Throws Error invalid_value for a folder of another kind of subject: two scenes would have one
/// name.
void refuse_folder_of(const std::string& folder, const std::string& file, const std::string& other,
                      const std::string& own) {
    std::error_code error;
    if (!std::filesystem::exists(utf8_path(folder + "/" + file), error)) return;
    refuse("-o " + folder + ": the folder holds " + other + ", " + file + "; " + own +
           " needs its own");
}

}  // namespace

PovrayFolder plan_povray_folder(const PovrayRequest& request, const OpenedSubject& subject,
                                const Context& context) {
    if (const auto* const terrain = std::get_if<TerrainModel>(&subject)) {
        refuse_folder_of(request.folder, "ocean.ini", "a sea", "a terrain");
        return terrain_folder(request, *terrain, context);
    }
    const Sea& sea = std::get<Sea>(subject);
    refuse_folder_of(request.folder, "terrain.ini", "a terrain", "a sea");
    const bool shows_region =
        sea.parameters.water.bed || (!repeats(sea.parameters) && !request.region.region.empty());
    return shows_region ? region_folder(request, sea, context) : sea_folder(request, sea, context);
}

}  // namespace ocean::app
