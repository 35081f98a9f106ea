// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean povray`: a folder that POV-Ray renders as it is. Its frames are baked like any others;
// around them lie the macros, the sea's parameters, a scene and the settings of its animation.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "bake_run.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/error.hpp"
#include "ocean/ocean.hpp"
#include "ocean/platform.hpp"
#include "ocean/seafile.hpp"
#include "povray_files.hpp"
#include "text.hpp"
#include "write_output.hpp"

namespace ocean::app {
namespace {

constexpr int kLargestMap = 2048;

struct PovrayOptions {
    BakeOptions bake;
    std::string folder;
    std::string format = "df3";
    bool near_only = false;
};

std::string extension_of(const std::string& format) {
    if (format == "df3") return ".df3";
    if (format == "mesh2") return ".inc";
    return ".png";
}

BakePlan make_povray_plan(PovrayOptions& options) {
    if (options.folder.empty()) options.folder = ".";
    options.bake.output = options.folder + "/sea_####" + extension_of(options.format);
    if (options.near_only && options.format != "df3") {
        throw Error(ErrorKind::invalid_value,
                    "--near-only: only --format df3 has coarser maps to leave out");
    }
    BakePlan plan = make_bake_plan(options.bake);
    if (options.bake.resolution.empty()) plan.resolution = std::min(plan.resolution, kLargestMap);
    if (plan.resolution > kLargestMap) {
        throw Error(ErrorKind::invalid_value,
                    format_text("--resolution = %d: allowed is at most %d, of which POV-Ray makes "
                                "a mesh of 2 GiB",
                                plan.resolution, kLargestMap));
    }
    plan.far_maps = plan.format == BakeFormat::df3 && !options.near_only;
    if (plan.format == BakeFormat::mesh2) plan.channels = plan.channels | ChannelSet{Channel::foam};
    return plan;
}

/// What POV-Ray needs to make a mesh of a frame's map: measured, 500 bytes and 12 us a vertex.
void warn_of_cost(const BakePlan& plan, Console& console) {
    if (plan.format == BakeFormat::height_field) return;
    const double vertices = static_cast<double>(plan.mesh_vertices());
    console.report("povray",
                   "POV-Ray will need about " +
                       bytes_text(static_cast<std::uint64_t>(500.0 * vertices)) +
                       format_text(" and %.0f s to read a mesh of it", std::ceil(12e-6 * vertices)),
                   format_text("\"povray_memory_bytes\": %.0f, \"povray_parse_seconds\": %.1f",
                               500.0 * vertices, 12e-6 * vertices));
}

std::string animation_settings(const io::PovrayFolder& folder, int fps) {
    const bool own_numbers = folder.frames_are_consecutive();
    const int first = own_numbers ? folder.frames.front() : 1;
    const int last = own_numbers ? folder.frames.back() : static_cast<int>(folder.frames.size());
    std::string text =
        "; All frames of this folder: povray ocean.ini\n"
        "; One of them: povray ocean.ini +SF2 +EF2; another size: povray ocean.ini +W640 +H360\n"
        "Input_File_Name=scene.pov\n"
        "Library_Path=.\n"
        "Width=960\nHeight=540\n"
        "Antialias=on\nAntialias_Threshold=0.1\nAntialias_Depth=2\n"
        "Display=off\n";
    text += format_text("Initial_Frame=%d\nFinal_Frame=%d\n", first, last);
    text += format_text("; clock is in seconds, at %d frames a second\n", fps);
    const Sea& sea = folder.sea;
    text += format_text("Initial_Clock=%.9g\nFinal_Clock=%.9g\n",
                        sea.time_of(folder.frames.front()), sea.time_of(folder.frames.back()));
    return text;
}

struct FolderFile {
    std::string name;
    std::string text;
    bool users = false;  // theirs to change: kept where it is
};

std::vector<FolderFile> folder_files(const BakePlan& plan, const PovrayOptions& options,
                                     const Context& context) {
    const Sea& sea = plan.sea;
    const SeaState state = Ocean(sea.parameters, {.threads = context.options.threads}).state();
    io::PovrayFolder folder{sea, state, options.format, plan.resolutions(), {}};
    // Those of all shards: their folders are one.
    folder.frames = options.bake.frames.empty() ? std::vector<int>{sea.parameters.time.first_frame}
                                                : parse_frames(options.bake.frames);
    const int fps = static_cast<int>(std::lround(sea.parameters.time.fps));
    std::vector<FolderFile> files = {
        {"ocean.inc", std::string(kOceanInc)},
        {"ocean_parameters.inc", io::povray_declarations(folder)},
        {"ocean.ini", animation_settings(folder, fps)},
        {"sea.toml", plan.sea_text},
        {"scene.pov", std::string(kScenePov), true},
    };
    // Of larger maps the macros make them: the text would be 220 MB at 2048.
    if (plan.format == BakeFormat::df3 && plan.resolution <= 1024) {
        files.push_back({"faces.inc", io::povray_faces(io::patch_triangles(plan.resolution))});
    }
    return files;
}

bool is_kept(const FolderFile& file, const std::string& folder) {
    std::error_code error;
    return file.users && std::filesystem::exists(utf8_path(folder + "/" + file.name), error);
}

FileCount show_folder(const std::vector<FolderFile>& files, const std::string& folder,
                      Console& console) {
    FileCount count;
    for (const FolderFile& file : files) {
        const bool kept = is_kept(file, folder);
        console.data(folder + "/" + file.name + (kept ? "\tkept\n" : "\n"));
        ++count.files;
        count.kept += kept ? 1 : 0;
        if (!kept) count.bytes += file.text.size();
    }
    return count;
}

void write_folder(const std::vector<FolderFile>& files, const std::string& folder,
                  const Context& context) {
    make_folder(folder);
    for (const FolderFile& file : files) {
        const std::string path = folder + "/" + file.name;
        if (is_kept(file, folder)) {
            context.console.note(path + " is there already: kept as it is");
            continue;
        }
        const InterruptWatch::Hold whole = context.interrupts.hold();
        write_output(path, file.text);
        context.console.data(path + "\n");
    }
}

void run(PovrayOptions& options, const Context& context) {
    BakePlan plan = make_povray_plan(options);
    warn_of_cost(plan, context.console);
    const std::vector<FolderFile> files = folder_files(plan, options, context);
    if (options.bake.dry_run) {
        plan.beside = show_folder(files, options.folder, context.console);
    } else {
        write_folder(files, options.folder, context);
    }
    run_bake(plan, options.bake.dry_run, context);
}

std::vector<OptionGroup> povray_options(PovrayOptions& options) {
    BakeOptions& bake = options.bake;
    return {
        sea_options(bake.sea),
        {"Sea",
         {{"--fps", &bake.fps, "RATE", "Frames per second, in place of the sea's time.fps"}}},
        {"Output",
         {{"-o,--output", &options.folder, "DIR", "The folder, made where it is missing",
           kRequired},
          {"--frames", &bake.frames, "RANGES",
           "FIRST-LAST[xSTEP] in comma lists, such as 1-250x2; default: the sea's first frame"},
          {"--format", &options.format, "FORMAT",
           "df3 (exact, small, all macros), mesh2 (text) or height_field (16-bit PNG, no "
           "overhangs); default df3",
           kOptional, OneOf{{"df3", "mesh2", "height_field"}}},
          {"--resolution", &bake.resolution, "R",
           "Samples along a side, a power of two up to 2048; default: the sea's grid"},
          {"--near-only", &options.near_only, "",
           "Leave out the coarser maps, a third more data, that draw the sea to the horizon"},
          {"--shard", &bake.shard, "I/N", "Only the I-th of N parts of the frames"},
          {"--skip-existing", &bake.skip_existing, "", "Keep complete frames of the same sea"},
          {"--keep-going", &bake.keep_going, "", "Go on with the other frames when one fails"},
          {"-n,--dry-run", &bake.dry_run, "",
           "Print the files and how much room they need; write nothing"}}},
        run_options("Progress, warnings and errors as JSON lines"),
    };
}

constexpr char kFooter[] =
    R"(Then, in the folder: povray ocean.ini. Its scene.pov is yours to change and is never
written over; ocean.inc holds the macros, ocean_parameters.inc what the sea is, and
sea.toml is the sea itself. The folder needs nothing of libocean, and no other file.)";

}  // namespace

Command povray_command() {
    auto options = std::make_shared<PovrayOptions>();
    return {
        .name = "povray",
        .summary = "Write a folder that POV-Ray renders as it is",
        .options = povray_options(*options),
        .footer = kFooter,
        .run = [options](const Context& context) { run(*options, context); },
    };
}

}  // namespace ocean::app
