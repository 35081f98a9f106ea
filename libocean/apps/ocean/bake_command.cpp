// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean bake`: frames of a sea into files for other programs. What its options mean is settled by
// make_bake_plan; those of a format come from the format.
#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <utility>

#include "commands.hpp"
#include "console_host.hpp"
#include "input_files.hpp"
#include "ocean/bake/catalogue.hpp"
#if OCEAN_HAS_GL
#include "ocean/error.hpp"
#include "ocean/gl/context.hpp"
#include "ocean/sea_subject.hpp"
#include "ocean/text.hpp"
#include "stage_images.hpp"
#endif
#include "sea_argument.hpp"

namespace ocean::app {
namespace {

struct Typed {
    BakeOptions bake;
    SeaArgument sea;
    std::map<std::string, bool> flags;  // of formats
    std::string egl_device, stage;
    bool dry_run = false;
};

std::vector<OptionGroup> common_options(Typed& typed, const Catalogue& catalogue) {
    BakeOptions& bake = typed.bake;
    return {
        // SEA or --from, which is checked when both are known.
        sea_options(typed.sea, kOptional),
        {"Sea",
         {{"--from", &bake.from, "FRAME.exr",
           "A baked file in place of SEA: the sea, and all options below that are not given"},
          {"--fps", &bake.fps, "RATE", "Frames per second, in place of the sea's time.fps"}}},
        {"Output",
         {
             {"-o,--output", &bake.output, "FILE",
              "out/sea.####.exr, a lone # is four digits; " + catalogue.extensions("or"),
              kRequired},
             {"--frames", &bake.frames, "RANGES",
              "FIRST-LAST[xSTEP] in comma lists, such as 1-250x2; default: the sea's first frame"},
             {"--shard", &bake.shard, "I/N", "Only the I-th of N parts of the frames, such as 2/5"},
             {"--skip-existing", &bake.skip_existing, "",
              "Keep complete files of the same sea and options, which takes reading them"},
             {"--keep-going", &bake.keep_going, "", "Go on with the other frames when one fails"},
             {"-n,--dry-run", &typed.dry_run, "",
              "Print the files and how much room they need; write nothing"},
             {"--resolution", &bake.resolution, "R",
              "Samples along a side, a power of two; default: the sea's grid"},
             {"--backend", &bake.backend, "NAME",
              catalogue.backend_names() + "; default cpu. auto: gl on a GPU, else cpu"},
#if OCEAN_HAS_GL
             {"--egl-device", &typed.egl_device, "N",
              "The GPU for gl, of those that EGL lists, from 0; default: the first"},
             {"--stage", &typed.stage, "STAGE",
              "In place of products, what lies before a map, as EXR: h0, spectrum, butterfly, "
              "horizontal-1 .. and vertical-1 .., by the backend thesis"},
#endif
         }},
    };
}

/// The option of that name that another format has too.
Option* find_option(std::vector<OptionGroup>& groups, const std::string& name) {
    for (OptionGroup& group : groups) {
        const auto found = std::ranges::find(group.options, name, &Option::names);
        if (found != group.options.end()) return &*found;
    }
    return nullptr;
}

OptionGroup format_options(Typed& typed, const BakeFormat& format, const Catalogue& catalogue,
                           std::vector<OptionGroup>& before) {
    OptionGroup group{std::string(format.family), {}};
    if (format.options == nullptr) return group;
    for (const FormatOption& option : format.options(catalogue)) {
        const std::string name = "--" + option.name;
        if (Option* same = find_option(before, name)) {
            same->help += ". Of " + std::string(format.extension) + ": " + option.help;
        } else if (option.value.empty()) {
            group.options.push_back({name, &typed.flags[option.name], "", option.help});
        } else {
            std::string& value = typed.bake.of_format[option.name];
            group.options.push_back({name, &value, option.value, option.help});
        }
    }
    return group;
}

std::vector<OptionGroup> bake_options(Typed& typed, const Catalogue& catalogue) {
    std::vector<OptionGroup> groups = common_options(typed, catalogue);
    for (const BakeFormat* format : catalogue.formats) {
        OptionGroup group = format_options(typed, *format, catalogue, groups);
        if (!group.options.empty()) groups.push_back(std::move(group));
    }
    for (OptionGroup& group : std::span(groups).subspan(1)) {
        for (Option& option : group.options) {
            if (std::holds_alternative<std::string*>(option.target)) option.rule = NotEmpty{};
        }
    }
    return groups;
}

void run(const Typed& typed, const Catalogue& catalogue, const Context& context) {
    BakeOptions options = typed.bake;
    for (const auto& [name, given] : typed.flags) {
        if (given) options.of_format[name] = "yes";
    }
    options.source = typed.sea.source;
    options.threads = context.options.threads;
    options.open_subject = [&typed](const std::string& source) {
        return make_subject(open_sea({source, typed.sea.assignments}));
    };
#if OCEAN_HAS_GL
    if (!typed.egl_device.empty()) {
        gl::use_egl_device(parse_whole_number(typed.egl_device, "--egl-device", 0, 63));
    }
    if (!typed.stage.empty()) {
        const bool of_format = std::ranges::any_of(
            options.of_format, [](const auto& option) { return !option.second.empty(); });
        if (of_format || !options.backend.empty() || options.skip_existing || typed.dry_run) {
            throw Error(ErrorKind::invalid_value,
                        "--stage goes with SEA, -o, --frames, --resolution and --egl-device alone");
        }
        options.backend = "thesis";
        options.of_format["products"] = "height";
    }
#endif
    const BakePlan plan = make_bake_plan(options, catalogue);
    InputFiles inputs(typed.sea, plan.subject->named_files());
    inputs.add(options.from);
    for (const std::string& path : output_paths(plan)) inputs.spare(path);
#if OCEAN_HAS_GL
    if (!typed.stage.empty()) return bake_stage(plan, typed.stage, context);
#endif
    if (typed.dry_run) return show_forecast(forecast_bake(plan), {}, context.console);
    ConsoleHost host(context);
    run_bake(plan, host);
}

constexpr char kFooter[] =
    R"(With -o out/sea.####.exr a product goes into out/sea.<product>.0001.exr, and several
frames of -o out/sea.exr into the same; one product of one frame is out/sea.exr itself. A
lone # is four digits, ## and more are as many as they are: sea.#.exr and sea.####.exr are
the same names. %04d and $F4 are understood too. Finished paths are printed on standard
output in the order of the frames, progress on standard error.

out/sea.manifest.json lists the files with their SHA-256, and with that of their pixels
whatever the compression. Shards, chunks (--frames 1-10, then 11-20) and repeated runs
merge into it, and into the list of frames of a USD stage, in any order and at once; the
stage leaves out frames of another sea or other options, with a warning. However a bake
is split, cut off or repeated, the same bytes come out; an interrupted one leaves only
whole files.

Events of --json: start, then for each frame one of frame, skipped, failed, with the
counts done, skipped, failed and total; last done or interrupted; error and warning
with a message; plan with -n. Exit codes: 0 done, 1 a frame failed (disk, memory),
2 wrong usage or bad sea file, 130 interrupted, 141 nobody reads standard output any more.)";

}  // namespace

Command bake_command(const Catalogue& catalogue) {
    auto typed = std::make_shared<Typed>();
    std::vector<OptionGroup> groups = bake_options(*typed, catalogue);
    groups.push_back(run_options("Progress, warnings and errors as JSON lines"));
    return {
        .name = "bake",
        .summary = "Write frames of a sea: EXR, DF3, PNG, POV-Ray mesh, PLY, OBJ, USD, VDB",
        .options = std::move(groups),
        .footer = kFooter,
        .run = [typed, &catalogue](const Context& context) { run(*typed, catalogue, context); },
    };
}

}  // namespace ocean::app
