// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Flamenco 3: the job type ocean_bake.js, a job of it, and a script that sends the job.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "job.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/json.hpp"

namespace ocean::farm {
namespace {

/// Returns the job for the manager's API. `folder` has a line of its own, which the script that
/// sends the job writes.
std::string job_text(const FarmJob& job) {
    const bool by_povray = !job.render.empty() && !renders_by_blender(job);
    JsonObject settings(JsonLines{4});
    settings.add("folder", ".")
        .add("sea", kSeaFile)
        .add("output", job.output)
        .add("frames", runs_text(frame_runs(job.frames, 1), ""))
        .add("chunk_size", job.frames_per_task)
        .add("options", shell_words(job.options))
        .add("render", job.render)
        .add("render_options", by_povray ? shell_words(povray_clock(job)) : "");
    return JsonObject(JsonLines{2})
               .add("name", job_name(job))
               .add("type", "ocean-bake")
               .add("priority", 50)
               .add("submitter_platform", "linux")
               .add("metadata", JsonObject().add("origin", kMark))
               .add("settings", settings)
               .text() +
           "\n";
}

std::string submit_script() {
    return "#!/bin/sh\n# " + std::string(kMark) +
           R"sh(: sends the job to a manager that has ocean_bake.js in its folder scripts.
# usage: sh submit.sh http://MANAGER:8080 [FOLDER]
# FOLDER: this folder as the workers see it, or a variable of the manager; default: its path here.
set -e
manager=${1:?the address of the manager, http://MANAGER:8080}
cd "$(dirname "$0")"
folder=$(printf %s "${2:-$PWD}" | sed 's/[\\"]/\\&/g')
FOLDER=$folder awk '/^    "folder": / { print "    \"folder\": \"" ENVIRON["FOLDER"] "\","; next } { print }' job.json |
    curl --fail-with-body -sS -H 'Content-Type: application/json' --data-binary @- "$manager/api/v3/jobs"
)sh";
}

std::vector<FarmFile> files(const FarmJob& job) {
    if (job.frames.front() < 0) {
        throw Error(ErrorKind::invalid_value, "--frames: Flamenco has no frames below 0");
    }
    return {{"ocean_bake.js", std::string(kOceanBakeScript)},
            {"job.json", job_text(job)},
            {"submit.sh", submit_script()}};
}

}  // namespace

const FarmEngine kFlamenco = {.name = "flamenco",
                              .summary = "Flamenco 3: the job type ocean_bake.js and a job of it",
                              .submit = "sh submit.sh http://MANAGER:8080",
                              .max_tasks = 1 << 30,
                              .files = files};

}  // namespace ocean::farm
