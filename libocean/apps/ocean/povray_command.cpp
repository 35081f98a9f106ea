// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean povray`: writes a folder that POV-Ray renders as it is. Its frames are baked like any
// others; the folder also has the macros, the sea's parameters, a scene and the settings of its
// animation. povray_folders.cpp plans the folder.
#include <memory>
#include <variant>

#include "commands.hpp"
#include "ocean/channel.hpp"
#include "povray_folders.hpp"

namespace ocean::app {
namespace {

void run(const PovrayRequest& typed, const Context& context) {
    PovrayRequest request = typed;
    if (request.folder.empty()) request.folder = ".";
    const OpenedSubject subject = open_subject(request.subject);
    if (std::holds_alternative<TerrainModel>(subject)) {
        refuse_options_of_others(context, kTerrainKind);
    }
    write_povray_folder(plan_povray_folder(request, subject, context), request, context);
}

std::vector<OptionGroup> povray_options(PovrayRequest& typed) {
    BakeOptions& bake = typed.bake;
    OptionGroup source = subject_options(typed.subject, kSeaKind);
    source.options.front().help =
        "A sea file or a terrain file, - for standard input (a sea), a file that was baked from "
        "one, or preset:NAME";
    return {
        source,
        {"Sea",
         {only_of(kSeaKind, {"--fps", &bake.fps, "RATE",
                             "Frames per second, in place of the sea's time.fps"})}},
        {"Terrain, or sea with a bed or hulls", region_options(typed.region)},
        {"Output",
         {{"-o,--output", &typed.folder, "DIR", "The folder, created if it is missing", kRequired},
          only_of(kSeaKind, {"--frames", &bake.frames, "RANGES",
                             "FIRST-LAST[xSTEP] in comma lists, such as 1-250x2; default: the "
                             "sea's first frame"}),
          {"--format", &typed.format, "FORMAT",
           "df3 (exact, all macros; default), mesh2 (text) or height_field (16-bit PNG, no "
           "overhangs). A terrain has all macros in each, a sea over a bed df3 alone",
           kOptional, OneOf{{"df3", "mesh2", "height_field"}}},
          {"--resolution", &bake.resolution, "R",
           "Samples along a side, a power of two up to 2048; default: the sea's grid, four times "
           "that with cascades"},
          only_of(kSeaKind, {"--near-only", &typed.near_only, "",
                             "Leave out the coarser maps, which show the sea up to the horizon"}),
          only_of(kSeaKind,
                  {"--shard", &bake.shard, "I/N", "Only the I-th of N parts of the frames"}),
          {"--skip-existing", &bake.skip_existing, "", "Keep complete frames of the same sea"},
          {"--overwrite", &bake.overwrite, "", "Replace frames of another subject"},
          only_of(kSeaKind, {"--keep-going", &bake.keep_going, "",
                             "Continue with the other frames when one fails"}),
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
With --region and --cell a sea with hulls shows their wakes there, and its
folder has coast.inc and coast_0001.df3.

SEA may be a terrain: a terrain file, preset:tujunga or a baked file of one. Its
folder has terrain.inc, terrain_parameters.inc, terrain.toml and one map, and is
rendered by povray terrain.ini.)";

}  // namespace

Command povray_command() {
    auto typed = std::make_shared<PovrayRequest>();
    return {
        .name = "povray",
        .summary = "Write a sea or a terrain as a folder that POV-Ray renders",
        .options = povray_options(*typed),
        .footer = kPovrayFooter,
        .run = [typed](const Context& context) { run(*typed, context); },
    };
}

}  // namespace ocean::app
