// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean terrain`: writes a terrain as files for other programs. It is a bake of one frame;
// make_bake_plan resolves its options, and the options of a format come from the format.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "bake_options.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "input_files.hpp"
#include "ocean/bake/catalogue.hpp"
#include "ocean/channel.hpp"
#include "ocean/domain.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bake/existing_frames.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrainfile.hpp"
#include "region_argument.hpp"
#include "terrain_argument.hpp"

namespace ocean::app {
namespace {

struct Typed {
    BakeOptions bake;
    TerrainArgument terrain;
    FormatFlags format_options;
    std::string stage, tiles;
    RegionArgument region;
    bool dry_run = false;
};

std::vector<OptionGroup> terrain_bake_options(Typed& typed, const Catalogue& catalogue) {
    BakeOptions& bake = typed.bake;
    std::vector<OptionGroup> groups = {
        // Either TERRAIN or --from is required, which the plan checks.
        terrain_options(typed.terrain, kOptional),
        {"Terrain",
         {{"--from", &bake.from, "FILE",
           "Take the terrain and all options below that are not given from a baked file, in place "
           "of TERRAIN"},
          {"--tiles", &typed.tiles, "NxM",
           "Repeat the tile N times to the east and M times to the north; default 1x1"}}},
        {"Output",
         {
             {"-o,--output", &bake.output, "FILE",
              "Path, such as hills.exr; the extension names the format", kRequired},
             {"--skip-existing", &bake.skip_existing, "",
              "Keep complete files of the same terrain and options, after reading them"},
             {"-n,--dry-run", &typed.dry_run, "",
              "Print the files and the disk space that they need; write nothing"},
             {"--resolution", &bake.resolution, "R",
              "Samples along a side of the tile, a power of two: the same waves on a finer or "
              "coarser map. `--set resolution=R` adds waves"},
             {"--backend", &bake.backend, "NAME",
              catalogue.backend_names() + "; default cpu. auto: gl on a GPU, else cpu"},
             {"--stage", &typed.stage, "STAGE",
              "Write a step of the synthesis instead: noise, transform, filter, filtered or "
              "height"},
         }},
    };
    for (Option& option : region_options(typed.region)) {
        groups[1].options.push_back(std::move(option));
    }
    add_format_options(typed.format_options, bake, catalogue, kTerrainKind, groups);
    return groups;
}

/// Returns the numbers of "2x3".
TerrainTiles parse_tiles(const std::string& text) {
    if (text.empty()) return {};
    const std::vector<std::string> counts = split(text, 'x');
    if (counts.size() != 2) {
        throw Error(ErrorKind::invalid_value,
                    "--tiles " + text + ": two numbers are needed, such as 2x3");
    }
    return {parse_whole_number(counts[0], "--tiles", 1, kMaxTerrainTiles),
            parse_whole_number(counts[1], "--tiles", 1, kMaxTerrainTiles)};
}

/// Returns the region that is typed, if one is. Throws Error invalid_value.
std::optional<Region> region_of(const Typed& typed) {
    const std::optional<Region> region = parse_region(typed.region);
    if (!region) return std::nullopt;
    if (!typed.tiles.empty() || !typed.bake.resolution.empty() || !typed.stage.empty()) {
        throw Error(ErrorKind::invalid_value,
                    "--region: its samples are those of --cell; --tiles, --resolution and --stage "
                    "are for whole tiles");
    }
    return region;
}

/// Throws Error invalid_value for --lod beside options of maps: its vertices are not theirs.
void refuse_lod_of_maps(const Typed& typed, const BakeOptions& options) {
    if (options.format_option("lod").empty()) return;
    const std::pair<const char*, const std::string*> of_maps[] = {
        {"--tiles", &typed.tiles},
        {"--region", &typed.region.region},
        {"--cell", &typed.region.cell},
        {"--resolution", &typed.bake.resolution},
        {"--stage", &typed.stage}};
    for (const auto& [option, text] : of_maps) {
        if (text->empty()) continue;
        throw Error(ErrorKind::invalid_value, "--lod: its vertices follow from the eye; " +
                                                  std::string(option) + " is for maps");
    }
}

/// Returns the part of the terrain that a baked file shows: tiles, a whole placed land or a region.
std::unique_ptr<Subject> subject_of_file(const std::string& path, TerrainModel terrain) {
    const auto provenance = io::read_provenance(path);
    if (!provenance || !provenance->domain) return make_subject(std::move(terrain));
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

/// A stage is a product of its own; the height is the terrain's.
void request_stage(const std::string& stage, BakeOptions& options) {
    if (stage.empty()) return;
    if (!options.format_option("products").empty()) {
        throw Error(ErrorKind::invalid_value, "--stage " + stage + ": give it or --products");
    }
    options.format_options["products"] = stage;
}

void run(const Typed& typed, const Catalogue& catalogue, const Context& context) {
    BakeOptions options = typed.bake;
    add_given(typed.format_options, options);
    request_stage(typed.stage, options);
    refuse_lod_of_maps(typed, options);
    options.source = typed.terrain.source;
    options.threads = context.options.threads;
    options.build_progress = build_progress_on(context.console);
    const TerrainTiles tiles = parse_tiles(typed.tiles);
    const std::optional<Region> region = region_of(typed);
    options.open_subject = [&](const std::string& source) {
        TerrainModel terrain = open_terrain({source, typed.terrain.assignments});
        if (region) return make_region_subject(std::move(terrain), *region);
        const bool from_file = !options.from.empty() && typed.tiles.empty();
        if (from_file) return subject_of_file(source, std::move(terrain));
        if (terrain.is_placed() && !typed.tiles.empty()) {
            throw Error(ErrorKind::invalid_value,
                        "--tiles " + typed.tiles + ": this land exists once; a tile repeats");
        }
        return make_subject(std::move(terrain), tiles);
    };
    const BakePlan plan = make_bake_plan(options, catalogue);
    InputFiles inputs(typed.terrain.source, plan.subject->named_files());
    inputs.add(options.from);
    for (const std::string& path : paths_that_may_exist(plan)) inputs.spare(path);
    run_or_forecast(plan, typed.dry_run, context);
}

constexpr char kTerrainFooter[] =
    R"(The extension names the format: .exr, .png (a height field of 16 bits), .ply,
.obj, .usda, .vdb and others; `ocean bake --help FORMAT` has all about one.
Heights are metres; -o hills.exr is one channel Y of floats, and
--products height,normal,slope writes hills.<product>.0001.exr for each.
The same terrain file and options give the same bytes, on any number of threads.
A file says in its header what it was made of: `ocean info` and --from read it.)";

}  // namespace

Command terrain_command(const Catalogue& catalogue) {
    auto typed = std::make_shared<Typed>();
    std::vector<OptionGroup> groups = terrain_bake_options(*typed, catalogue);
    groups.push_back(run_options("Progress, warnings and errors as JSON lines"));
    return {
        .name = "terrain",
        .summary = "Write a fractional terrain: " + catalogue.format_labels(false),
        .options = std::move(groups),
        .footer = kTerrainFooter,
        .run = [typed, &catalogue](const Context& context) { run(*typed, catalogue, context); },
    };
}

}  // namespace ocean::app
