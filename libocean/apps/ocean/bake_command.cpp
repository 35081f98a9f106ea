// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean bake`: frames of a sea into files for other programs.
#include <CLI/CLI.hpp>
#include <memory>

#include "bake_run.hpp"
#include "console.hpp"

namespace ocean::app {

void add_bake_command(CLI::App& app, Context& context) {
    CLI::App* command =
        app.add_subcommand("bake", "Write frames of a sea: EXR, DF3, PNG, POV-Ray mesh");
    auto options = std::make_shared<BakeOptions>();
    add_bake_options(*command, *options);
    add_run_options(*command, context.options, "Progress, warnings and errors as JSON lines");
    command->footer(
        "With -o out/sea.####.exr a product goes into out/sea.<product>.0001.exr. A run of # is\n"
        "as many digits; %04d and $F4 are understood too. Finished paths are printed on standard\n"
        "output in the order of the frames, progress on standard error.\n"
        "\n"
        "out/sea.manifest.json lists the files with their SHA-256, and with that of their pixels\n"
        "whatever the compression. Shards and repeated runs merge into it. However a bake is\n"
        "split, cut off or repeated, the same bytes come out; an interrupted one leaves only\n"
        "whole files.\n"
        "\n"
        "Events of --json: start, then for each frame one of frame, skipped, failed, with the\n"
        "counts done, skipped, failed and total; last done or interrupted; error and warning\n"
        "with a message; plan with -n. Exit codes: 0 done, 1 a frame failed (disk, memory),\n"
        "2 wrong usage or bad sea file, 130 interrupted.");
    command->callback([options, &context] {
        BakePlan plan = make_bake_plan(*options);
        run_bake(plan, options->dry_run, context);
    });
}

}  // namespace ocean::app
