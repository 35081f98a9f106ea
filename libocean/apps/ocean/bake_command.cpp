// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean bake`: frames of a sea into files for other programs.
#include <memory>
#include <utility>

#include "bake_run.hpp"
#include "commands.hpp"
#include "console.hpp"

namespace ocean::app {
namespace {

constexpr char kFooter[] =
    R"(With -o out/sea.####.exr a product goes into out/sea.<product>.0001.exr. A run of # is
as many digits; %04d and $F4 are understood too. Finished paths are printed on standard
output in the order of the frames, progress on standard error.

out/sea.manifest.json lists the files with their SHA-256, and with that of their pixels
whatever the compression. Shards and repeated runs merge into it. However a bake is
split, cut off or repeated, the same bytes come out; an interrupted one leaves only
whole files.

Events of --json: start, then for each frame one of frame, skipped, failed, with the
counts done, skipped, failed and total; last done or interrupted; error and warning
with a message; plan with -n. Exit codes: 0 done, 1 a frame failed (disk, memory),
2 wrong usage or bad sea file, 130 interrupted.)";

}  // namespace

Command bake_command() {
    auto options = std::make_shared<BakeOptions>();
    std::vector<OptionGroup> groups = bake_options(*options);
    groups.push_back(run_options("Progress, warnings and errors as JSON lines"));
    return {
        .name = "bake",
        .summary = "Write frames of a sea: EXR, DF3, PNG, POV-Ray mesh",
        .options = std::move(groups),
        .footer = kFooter,
        .run =
            [options](const Context& context) {
                BakePlan plan = make_bake_plan(*options);
                run_bake(plan, options->dry_run, context);
            },
    };
}

}  // namespace ocean::app
