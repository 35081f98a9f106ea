// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean bake` and `ocean terrain`: write frames of a sea, or the map of a terrain, as files for
// other programs. make_bake_plan resolves the options; the options of a format come from the
// format.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "bake_options.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "format_help.hpp"
#include "input_files.hpp"
#include "ocean/bake/catalogue.hpp"
#include "ocean/channel.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/bake/existing_frames.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrainfile.hpp"
#if OCEAN_HAS_GL
#include "ocean/internal/gl/context.hpp"
#include "stage_images.hpp"
#else
#include "ocean/backend.hpp"
#endif
#include "region_argument.hpp"
#include "subject_argument.hpp"

namespace ocean::app {
namespace {

/// Returns the numbers of "2x3".
TerrainTiles parse_tiles(const std::string& text) {
    if (text.empty()) return {};
    const std::vector<std::string> counts = split(text, 'x');
    if (counts.size() != 2) {
        refuse("--tiles " + text + ": two numbers are needed, such as 2x3");
    }
    return {parse_whole_number(counts[0], "--tiles", 1, kMaxTerrainTiles),
            parse_whole_number(counts[1], "--tiles", 1, kMaxTerrainTiles)};
}

/// Returns the region that is typed, if one is. Throws Error invalid_value.
std::optional<Region> region_of(const BakeArguments& typed) {
    const std::optional<Region> region = parse_region(typed.region);
    if (!region) return std::nullopt;
    const bool is_sea = typed.kind == kSeaKind;
    const bool has_step = !is_sea && !typed.stage.empty();
    if (!typed.tiles.empty() || !typed.bake.resolution.empty() || has_step) {
        refuse(std::string("--region: its samples are those of --cell; ") +
               (is_sea ? "--resolution is for whole maps"
                       : "--tiles, --resolution and --stage are for whole tiles"));
    }
    return region;
}

/// Throws Error invalid_value for --lod beside options of maps: its vertices are not theirs.
void refuse_lod_of_maps(const BakeArguments& typed, const BakeOptions& options) {
    if (options.format_option("lod").empty()) return;
    const std::pair<const char*, const std::string*> of_maps[] = {
        {"--tiles", &typed.tiles},
        {"--region", &typed.region.region},
        {"--cell", &typed.region.cell},
        {"--resolution", &typed.bake.resolution},
        {"--stage", &typed.stage}};
    for (const auto& [option, text] : of_maps) {
        if (text->empty()) continue;
        refuse("--lod: its vertices follow from the eye; " + std::string(option) + " is for maps");
    }
}

/// Returns the part of a sea that is shown: a region, the part that the file of --from shows, or
/// all.
std::unique_ptr<Subject> shown_part(Sea sea, const BakeArguments& typed,
                                    const std::optional<Region>& region) {
    if (region) return make_region_subject(std::move(sea), *region);
    const SeaBed* const bed = sea.parameters.water.bed.get();
    const bool from_file = !repeats(sea.parameters) && !typed.bake.from.empty();
    const auto provenance = from_file ? io::read_provenance(typed.bake.from) : std::nullopt;
    const bool is_part = provenance && provenance->domain && !provenance->domain->wraps &&
                         (bed == nullptr || *provenance->domain != bed->domain);
    if (!is_part) return make_subject(std::move(sea));
    const Domain& shown = *provenance->domain;
    return make_region_subject(std::move(sea), {shown.origin, shown.size, shown.step(0)});
}

/// Returns the part of a terrain that is shown: a region, tiles, the part that the file of --from
/// shows, or all.
std::unique_ptr<Subject> shown_part(TerrainModel terrain, const BakeArguments& typed,
                                    const std::optional<Region>& region) {
    if (region) return make_region_subject(std::move(terrain), *region);
    if (terrain.is_placed() && !typed.tiles.empty()) {
        refuse("--tiles " + typed.tiles + ": this land exists once; a tile repeats");
    }
    const bool from_file = !typed.bake.from.empty() && typed.tiles.empty();
    const auto provenance = from_file ? io::read_provenance(typed.bake.from) : std::nullopt;
    if (!provenance || !provenance->domain) {
        return make_subject(std::move(terrain), parse_tiles(typed.tiles));
    }
    const Domain& shown = *provenance->domain;
    if (shown.wraps) {
        const auto count = [&](double size) {
            return static_cast<int>(std::lround(size / terrain.patch_size));
        };
        const TerrainTiles tiles{count(shown.size[0]), count(shown.size[1])};
        return make_subject(std::move(terrain), tiles);
    }
    const int longer = std::max(shown.samples[0], shown.samples[1]);
    const bool is_whole = terrain.is_placed() && terrain_domain(terrain, longer) == shown;
    if (is_whole) return make_subject(std::move(terrain));
    return make_region_subject(std::move(terrain), {shown.origin, shown.size, shown.step(0)});
}

/// Sets the options of a bake that writes a stage of a sea's transform or of a terrain's synthesis.
void request_stage(const BakeArguments& typed, BakeOptions& options) {
#if OCEAN_HAS_GL
    if (!typed.egl_device.empty()) {
        gl::use_egl_device(parse_whole_number(typed.egl_device, "--egl-device", 0, 63));
    }
#else
    const bool needs_gl = typed.kind == kSeaKind && !typed.stage.empty();
    if (!typed.egl_device.empty() || needs_gl) find_backend("gl");  // throws the reason
#endif
    if (typed.stage.empty()) return;
    if (typed.kind == kTerrainKind) {
        if (!options.format_option("products").empty()) {
            refuse("--stage " + typed.stage + ": give it or --products");
        }
        options.format_options["products"] = typed.stage;  // a product of its own
        return;
    }
    const bool has_format_option = std::ranges::any_of(
        options.format_options, [](const auto& option) { return !option.second.empty(); });
    if (has_format_option || !options.backend.empty() || options.skip_existing || typed.dry_run) {
        refuse(
            "--stage can be combined with SEA, -o, --frames, --resolution and "
            "--egl-device only");
    }
    options.backend = "thesis";
    options.format_options["products"] = "height";
}

void run(const BakeArguments& typed, const Catalogue& catalogue, const Context& context) {
    if (typed.summary && !typed.dry_run) {
        refuse("--summary: it is of the plan that -n prints; give -n");
    }
    const BakePlan plan = plan_bake(typed, catalogue, context);
    InputFiles inputs(typed.subject.source, plan.subject->named_files());
    inputs.add(typed.bake.from);
    for (const std::string& path : paths_that_may_exist(plan)) inputs.spare(path);
#if OCEAN_HAS_GL
    if (typed.kind == kSeaKind && !typed.stage.empty()) {
        return bake_stage(plan, typed.stage, context);
    }
#endif
    if (typed.summary) return show_summary(plan, context);
    run_or_forecast(plan, typed.dry_run, context);
}

constexpr char kBakeFooter[] =
    R"(-o out/sea.####.exr writes out/sea.<product>.0001.exr for each product and
frame. So does -o out/sea.exr if it has several files to write; one product of
one frame is out/sea.exr itself. A lone # is four digits, two or more are one
digit each: sea.#.exr and sea.####.exr are the same names. %04d and $F4 are
equivalent to ####. Paths of finished files are printed on standard output in
the order of the frames, progress on standard error.

out/sea.manifest.json lists the files with the SHA-256 of their bytes and of
their pixels, which does not depend on the compression. Shards, chunks (--frames
1-10, then 11-20) and repeated runs merge into it, and into the frame list of a
USD stage, in any order and concurrently; the stage leaves out frames of another
sea or of other options, with a warning. A bake writes the same bytes if it is
split, interrupted or repeated; an interrupted bake leaves complete files only.

Events of --json: start, then for each frame one of frame, skipped, failed, with
the counts done, skipped, failed and total; last done or interrupted; error and
warning with a message; plan with -n. Exit codes: 0 done, 1 a frame failed
(disk, memory), 2 wrong usage or bad sea file, 130 interrupted, 141 standard
output was closed.)";

constexpr char kTerrainFooter[] =
    R"(The extension names the format: .exr, .png (a height field of 16 bits), .ply,
.obj, .usda, .vdb and others; `ocean bake --help FORMAT` has all about one.
Heights are metres; -o hills.exr is one channel Y of floats, and
--products height,normal,slope writes hills.<product>.0001.exr for each.
The same terrain file and options give the same bytes, on any number of threads.
A file says in its header what it was made of: `ocean info` and --from read it.)";

/// Returns the command for subjects of a kind, without its name, texts and pages.
Command command_for(std::string_view kind, const Catalogue& catalogue) {
    auto typed = std::make_shared<BakeArguments>();
    typed->kind = kind;
    std::vector<OptionGroup> groups = bake_options(*typed, catalogue);
    groups.push_back(run_options("Progress, warnings and errors as JSON lines"));
    groups.push_back(progress_option());
    return {.options = groups, .run = [typed, &catalogue](const Context& context) {
                run(*typed, catalogue, context);
            }};
}

}  // namespace

std::vector<OptionGroup> bake_options(BakeArguments& typed, const Catalogue& catalogue) {
    BakeOptions& bake = typed.bake;
    const bool is_sea = typed.kind == kSeaKind;
    // Either SEA or --from is required, which the plan checks.
    const OptionGroup subject = subject_options(typed.subject, typed.kind, kOptional);
    const std::string noun(typed.kind);
    std::vector<OptionGroup> groups = options_for(
        typed.kind,
        {subject,
         {subject.name,
          {{"--from", &bake.from, is_sea ? "FRAME.exr" : "FILE",
            "Take the " + noun +
                " and all options below that are not given from a baked file, in place of " +
                subject.options.front().names},
           only_of(kSeaKind, {"--fps", &bake.fps, "RATE",
                              "Frames per second, in place of the sea's time.fps"}),
           only_of(kTerrainKind,
                   {"--tiles", &typed.tiles, "NxM",
                    "Repeat the tile N times to the east and M times to the north; default 1x1"})}},
         {is_sea ? "Sea over a bed" : subject.name, region_options(typed.region)},
         {"Output",
          {{"-o,--output", &bake.output, "FILE",
            is_sea ? "Path with the frame number as ####, such as out/sea.####.exr; the extension "
                     "names the format"
                   : "Path, such as hills.exr; the extension names the format",
            kRequired},
           only_of(kSeaKind, {"--frames", &bake.frames, "RANGES",
                              "FIRST-LAST[xSTEP] in comma lists, such as 1-250x2; default: the "
                              "sea's first frame"}),
           only_of(kSeaKind, {"--shard", &bake.shard, "I/N",
                              "Only the I-th of N parts of the frames, such as 2/5"}),
           {"--skip-existing", &bake.skip_existing, "",
            "Keep complete files of the same " + noun + " and options, after reading them"},
           {"--overwrite", &bake.overwrite, "",
            "Replace frames of another " + noun + ", which is refused without it"},
           only_of(kSeaKind, {"--keep-going", &bake.keep_going, "",
                              "Continue with the other frames when one fails"}),
           {"-n,--dry-run", &typed.dry_run, "",
            "Print the files and the disk space that they need; write nothing"},
           {"--summary", &typed.summary, "",
            "With -n: print the number of files, bytes and seconds alone"},
           {"--resolution", &bake.resolution, "R",
            is_sea ? "Samples along a side, a power of two; default: the sea's grid, four times "
                     "that with cascades"
                   : "Samples along a side of the tile, a power of two: the same waves on a finer "
                     "or coarser map. `--set resolution=R` adds waves"},
           {"--backend", &bake.backend, "NAME",
            catalogue.backend_names() + "; default cpu. auto: gl on a GPU, else cpu"},
           only_of(kSeaKind, {"--egl-device", &typed.egl_device, "N",
                              "Index of the GPU for gl in the list of EGL, from 0; default: the "
                              "first one"}),
           {"--stage", &typed.stage, "STAGE",
            is_sea ? "Write a stage of the transform as EXR, by the backend thesis: h0, spectrum, "
                     "butterfly, horizontal-1 .. and vertical-1 .."
                   : "Write a step of the synthesis instead: noise, transform, filter, filtered or "
                     "height"}}}});
    add_format_options(typed.format_options, bake, catalogue, typed.kind, groups);
    return groups;
}

BakePlan plan_bake(const BakeArguments& typed, const Catalogue& catalogue, const Context& context) {
    BakeOptions options = typed.bake;
    add_given(typed.format_options, options);
    request_stage(typed, options);
    refuse_lod_of_maps(typed, options);
    options.source = typed.subject.source;
    options.threads = context.options.threads;
    options.build_progress = build_progress_on(context.console);
    const std::optional<Region> region = region_of(typed);
    options.open_subject = [&](const std::string& source) {
        const SubjectArgument argument{source, typed.subject.assignments};
        return typed.kind == kSeaKind ? shown_part(open_sea(argument), typed, region)
                                      : shown_part(open_terrain(argument), typed, region);
    };
    return make_bake_plan(options, catalogue);
}

Command bake_command(const Catalogue& catalogue) {
    Command command = command_for(kSeaKind, catalogue);
    command.name = "bake";
    command.summary = "Write frames of a sea: " + catalogue.format_labels(true);
    command.footer = kBakeFooter;
    command.page_noun = "format";
    command.pages_title = "Formats (`ocean bake --help NAME` has all about one)";
    command.pages = format_pages(catalogue);
    return command;
}

Command terrain_command(const Catalogue& catalogue) {
    Command command = command_for(kTerrainKind, catalogue);
    command.name = "terrain";
    command.summary = "Write a fractional terrain: " + catalogue.format_labels(false);
    command.footer = kTerrainFooter;
    return command;
}

}  // namespace ocean::app
