// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean povray`: writes a folder that POV-Ray renders as it is. Its frames are baked like any
// others; the folder also has the macros, the sea's parameters, a scene and the settings of its
// animation. povray_terrain.cpp writes the folder of a terrain.
#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "commands.hpp"
#include "console.hpp"
#include "console_host.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bake/povray_folder.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"
#include "povray_files.hpp"
#include "region_argument.hpp"
#include "subject_argument.hpp"
#include "text.hpp"
#include "user_files.hpp"

namespace ocean::app {
namespace {

struct Typed {
    BakeOptions bake;
    SubjectArgument sea;
    std::string folder;
    std::string format = "df3";
    RegionArgument region;  // of a terrain or a coast
    bool near_only = false;
    bool dry_run = false;
};

BakePlan make_povray_plan(const Typed& typed, const Sea& sea, const std::string& folder,
                          const Context& context) {
    const bool df3 = typed.format == "df3";
    if (typed.near_only && !df3) {
        throw Error(ErrorKind::invalid_value,
                    "--near-only: only --format df3 has coarser maps to leave out");
    }
    BakeOptions options = typed.bake;
    options.source = typed.sea.source;
    options.output = folder + "/sea_####" + povray_extension(typed.format);
    options.threads = context.options.threads;
    options.max_resolution = kMaxPovrayResolution;
    if (df3) options.format_options["fine-map"] = "yes";
    if (df3) options.format_options["detail-map"] = "yes";
    if (df3 && !typed.near_only) options.format_options["far-maps"] = "yes";
    if (typed.format == "mesh2") options.format_options["mesh-foam"] = "yes";
    options.open_subject = [&sea](const std::string&) { return make_subject(sea); };
    BakePlan plan = make_bake_plan(options, standard_catalogue());
    refuse_large_mesh(plan.resolution);
    return plan;
}

/// Reports the cost of POV-Ray's mesh of a frame's map: 500 bytes and 12 us for each vertex,
/// measured.
void warn_of_cost(const BakePlan& plan, Console& console) {
    if (plan.format->name == "height_field") return;
    const double vertices = std::pow(plan.resolution + 1.0, 2.0);
    console.report("povray",
                   "POV-Ray will need about " +
                       bytes_text(static_cast<std::uint64_t>(500.0 * vertices)) +
                       format_text(" and %.0f s to read a mesh of it", std::ceil(12e-6 * vertices)),
                   {{"povray_memory_bytes", Json(500.0 * vertices, decimals<0>)},
                    {"povray_parse_seconds", Json(12e-6 * vertices, decimals<1>)}});
}

/// Throws Error unsupported for options that only a sea has.
void refuse_options_of_seas(const Typed& typed) {
    const std::pair<const char*, bool> given[] = {{"--frames", !typed.bake.frames.empty()},
                                                  {"--fps", !typed.bake.fps.empty()},
                                                  {"--near-only", typed.near_only},
                                                  {"--shard", !typed.bake.shard.empty()},
                                                  {"--keep-going", typed.bake.keep_going}};
    for (const auto& [option, is_given] : given) {
        if (!is_given) continue;
        throw Error(ErrorKind::unsupported,
                    std::string(option) + ": only a sea has it, and this is a terrain");
    }
}

void run(const Typed& typed, const Context& context) {
    const std::string folder = typed.folder.empty() ? "." : typed.folder;
    const OpenedSubject subject = open_subject(typed.sea);
    if (std::holds_alternative<TerrainModel>(subject)) {
        refuse_options_of_seas(typed);
        BakeOptions options = typed.bake;
        options.source = typed.sea.source;
        return write_povray_terrain(
            {options, typed.sea.assignments, folder, typed.format, typed.region, typed.dry_run},
            context);
    }
    const Sea& given = std::get<Sea>(subject);
    refuse_folder_of(folder, "terrain.ini", "a terrain", "a sea");
    if (given.parameters.water.bed) {
        return write_povray_coast({typed.bake, given, typed.sea.source, folder, typed.format,
                                   typed.region, typed.near_only, typed.dry_run},
                                  context);
    }
    if (!typed.region.region.empty() || !typed.region.cell.empty()) {
        throw Error(ErrorKind::unsupported,
                    "--region and --cell: only a terrain and a sea over a bed (water.seabed) have "
                    "them, and this is an open sea");
    }
    const BakePlan plan = make_povray_plan(typed, given, folder, context);
    const Sea& sea = sea_of(*plan.subject);
    const SeaState state = Ocean(sea.parameters, {.threads = plan.threads}).state();
    const ExistingFrames existing = povray_existing_frames(plan);
    std::vector<FolderFile> files = povray_folder_files(
        plan, state, united(plan.all_frames, existing.of_plan), {folder, cache_file("povray")});
    const InputFiles inputs(typed.sea.source, named_files(sea));
    refuse_to_replace_others(files, folder, inputs);
    for (const std::string& path : paths_that_may_exist(plan)) inputs.spare(path);
    io::require_folder(folder);
    warn_of_cost(plan, context.console);
    warn_of_foreign_frames(existing, plan, folder, context);
    if (!write_folder({folder, files, plan, {&plan}}, typed.dry_run, context)) return;
    const auto lists_of = [&](const std::vector<int>& frames) {
        return povray_frame_lists(plan, state, frames);
    };
    update_frame_lists(plan, folder, lists_of, context);
}

std::vector<OptionGroup> povray_options(Typed& typed) {
    BakeOptions& bake = typed.bake;
    OptionGroup source = subject_options(typed.sea, kSeaKind);
    source.options.front().help =
        "A sea file or a terrain file, - for standard input (a sea), a file that was baked from "
        "one, or preset:NAME";
    return {
        source,
        {"Sea",
         {{"--fps", &bake.fps, "RATE", "Frames per second, in place of the sea's time.fps"}}},
        {"Terrain, or sea over a bed", region_options(typed.region)},
        {"Output",
         {{"-o,--output", &typed.folder, "DIR", "The folder, created if it is missing", kRequired},
          {"--frames", &bake.frames, "RANGES",
           "FIRST-LAST[xSTEP] in comma lists, such as 1-250x2; default: the sea's first frame"},
          {"--format", &typed.format, "FORMAT",
           "df3 (exact, all macros; default), mesh2 (text) or height_field (16-bit PNG, no "
           "overhangs). A terrain has all macros in each, a sea over a bed df3 alone",
           kOptional, OneOf{{"df3", "mesh2", "height_field"}}},
          {"--resolution", &bake.resolution, "R",
           "Samples along a side, a power of two up to 2048; default: the sea's grid, four times "
           "that with cascades"},
          {"--near-only", &typed.near_only, "",
           "Leave out the coarser maps, which show the sea up to the horizon"},
          {"--shard", &bake.shard, "I/N", "Only the I-th of N parts of the frames"},
          {"--skip-existing", &bake.skip_existing, "", "Keep complete frames of the same sea"},
          {"--keep-going", &bake.keep_going, "", "Continue with the other frames when one fails"},
          {"-n,--dry-run", &typed.dry_run, "",
           "Print the files and the disk space that they need; write nothing"}}},
        run_options("Progress, warnings and errors as JSON lines"),
    };
}

constexpr char kPovrayFooter[] =
    R"(Then, in the folder: povray ocean.ini. Its scene.pov is yours to change and is
never overwritten; ocean.inc has the macros, ocean_parameters.inc the parameters
of the sea, and sea.toml is the sea file. The folder is complete: it needs
neither libocean nor other files.

Frame n of POV-Ray, its frame_number, always shows frame n of the sea, and clock
is its time in seconds; at a frame that was not written POV-Ray stops with an
error that lists the existing frames. Chunks (--frames 1-10, then 11-20) and
shards merge into ocean.ini and ocean_parameters.inc, in any order and
concurrently; frames of another sea, format or resolution are left out, with a
warning.

A sea over a bed (water.seabed) gets land too: its folder has also coast.inc,
coast_0001.df3 and land.df3. --region and --cell choose the part of the bed that
the map shows and how finely: waves at the feet of a viewer need 1 m or less. By
default it is all of the bed, at the bed's cell. Around it lies the open sea.

SEA may be a terrain: a terrain file, preset:tujunga or a baked file of one. Its
folder has terrain.inc, terrain_parameters.inc, terrain.toml and one map, and is
rendered by povray terrain.ini.)";

}  // namespace

Command povray_command() {
    auto typed = std::make_shared<Typed>();
    return {
        .name = "povray",
        .summary = "Write a sea or a terrain as a folder that POV-Ray renders",
        .options = povray_options(*typed),
        .footer = kPovrayFooter,
        .run = [typed](const Context& context) { run(*typed, context); },
    };
}

}  // namespace ocean::app
