// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean bake`: writes frames of a sea as files for other programs. make_bake_plan resolves its
// options; the options of a format come from the format.
#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "bake_options.hpp"
#include "commands.hpp"
#include "format_help.hpp"
#include "input_files.hpp"
#include "ocean/bake/catalogue.hpp"
#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bake/existing_frames.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/seafile.hpp"
#if OCEAN_HAS_GL
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/text.hpp"
#include "stage_images.hpp"
#else
#include "ocean/backend.hpp"
#include "ocean/domain.hpp"
#endif
#include "region_argument.hpp"
#include "sea_argument.hpp"

namespace ocean::app {
namespace {

struct Typed {
    BakeOptions bake;
    SeaArgument sea;
    RegionArgument region;
    FormatFlags format_options;
    std::string egl_device, stage;
    bool dry_run = false;
};

std::vector<OptionGroup> common_options(Typed& typed, const Catalogue& catalogue) {
    BakeOptions& bake = typed.bake;
    return {
        // Either SEA or --from is required, which the plan checks.
        sea_options(typed.sea, kOptional),
        {"Sea",
         {{"--from", &bake.from, "FRAME.exr",
           "Take the sea and all options below that are not given from a baked file, in place of "
           "SEA"},
          {"--fps", &bake.fps, "RATE", "Frames per second, in place of the sea's time.fps"}}},
        {"Sea over a bed", region_options(typed.region)},
        {"Output",
         {
             {"-o,--output", &bake.output, "FILE",
              "Path with the frame number as ####, such as out/sea.####.exr; the extension names "
              "the format",
              kRequired},
             {"--frames", &bake.frames, "RANGES",
              "FIRST-LAST[xSTEP] in comma lists, such as 1-250x2; default: the sea's first frame"},
             {"--shard", &bake.shard, "I/N", "Only the I-th of N parts of the frames, such as 2/5"},
             {"--skip-existing", &bake.skip_existing, "",
              "Keep complete files of the same sea and options, after reading them"},
             {"--keep-going", &bake.keep_going, "",
              "Continue with the other frames when one fails"},
             {"-n,--dry-run", &typed.dry_run, "",
              "Print the files and the disk space that they need; write nothing"},
             {"--resolution", &bake.resolution, "R",
              "Samples along a side, a power of two; default: the sea's grid, four times that with "
              "cascades"},
             {"--backend", &bake.backend, "NAME",
              catalogue.backend_names() + "; default cpu. auto: gl on a GPU, else cpu"},
             {"--egl-device", &typed.egl_device, "N",
              "Index of the GPU for gl in the list of EGL, from 0; default: the first one"},
             {"--stage", &typed.stage, "STAGE",
              "Write a stage of the transform as EXR, by the backend thesis: h0, spectrum, "
              "butterfly, horizontal-1 .. and vertical-1 .."},
         }},
    };
}

/// Returns the part of the sea that is shown: that of --region, that of the file of --from, or all.
std::unique_ptr<Subject> shown_part(Sea sea, const std::optional<Region>& region,
                                    const std::string& from) {
    if (region) return make_region_subject(std::move(sea), *region);
    const SeaBed* const bed = sea.parameters.water.bed.get();
    const auto provenance =
        from.empty() || bed == nullptr ? std::nullopt : io::read_provenance(from);
    const bool is_part = provenance && provenance->domain && *provenance->domain != bed->domain;
    if (!is_part) return make_subject(std::move(sea));
    const Domain& shown = *provenance->domain;
    return make_region_subject(std::move(sea), {shown.origin, shown.size, shown.step(0)});
}

std::vector<OptionGroup> bake_options(Typed& typed, const Catalogue& catalogue) {
    std::vector<OptionGroup> groups = common_options(typed, catalogue);
    add_format_options(typed.format_options, typed.bake, catalogue, kSeaKind, groups);
    return groups;
}

void run(const Typed& typed, const Catalogue& catalogue, const Context& context) {
    BakeOptions options = typed.bake;
    add_given(typed.format_options, options);
    options.source = typed.sea.source;
    options.threads = context.options.threads;
    const std::optional<Region> region = parse_region(typed.region);
    if (region && !options.resolution.empty()) {
        throw Error(ErrorKind::invalid_value,
                    "--region: its samples are those of --cell; --resolution is for whole maps");
    }
    options.open_subject = [&](const std::string& source) {
        return shown_part(open_sea({source, typed.sea.assignments}), region, options.from);
    };
#if OCEAN_HAS_GL
    if (!typed.egl_device.empty()) {
        gl::use_egl_device(parse_whole_number(typed.egl_device, "--egl-device", 0, 63));
    }
    if (!typed.stage.empty()) {
        const bool has_format_option = std::ranges::any_of(
            options.format_options, [](const auto& option) { return !option.second.empty(); });
        if (has_format_option || !options.backend.empty() || options.skip_existing ||
            typed.dry_run) {
            throw Error(ErrorKind::invalid_value,
                        "--stage can be combined with SEA, -o, --frames, --resolution and "
                        "--egl-device only");
        }
        options.backend = "thesis";
        options.format_options["products"] = "height";
    }
#else
    if (!typed.egl_device.empty() || !typed.stage.empty()) find_backend("gl");  // throws the reason
#endif
    const BakePlan plan = make_bake_plan(options, catalogue);
    InputFiles inputs(typed.sea.source, plan.subject->named_files());
    inputs.add(options.from);
    for (const std::string& path : paths_that_may_exist(plan)) inputs.spare(path);
#if OCEAN_HAS_GL
    if (!typed.stage.empty()) return bake_stage(plan, typed.stage, context);
#endif
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

}  // namespace

Command bake_command(const Catalogue& catalogue) {
    auto typed = std::make_shared<Typed>();
    std::vector<OptionGroup> groups = bake_options(*typed, catalogue);
    groups.push_back(run_options("Progress, warnings and errors as JSON lines"));
    return {
        .name = "bake",
        .summary = "Write frames of a sea: " + catalogue.format_labels(true),
        .options = std::move(groups),
        .footer = kBakeFooter,
        .page_noun = "format",
        .pages_title = "Formats (`ocean bake --help NAME` has all about one)",
        .pages = format_pages(catalogue),
        .run = [typed, &catalogue](const Context& context) { run(*typed, catalogue, context); },
    };
}

}  // namespace ocean::app
