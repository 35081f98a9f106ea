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

/// Returns the type of a setting of ocean_bake.js; "" if there is none of this name.
std::string_view type_of_setting(const std::string& key) {
    const std::string head = "{ key: \"" + key + "\", type: \"";
    const std::size_t at = kOceanBakeScript.find(head);
    if (at == std::string_view::npos) return "";
    const std::string_view type = kOceanBakeScript.substr(at + head.size());
    return type.substr(0, type.find('"'));
}

/// Adds the options that are settings of their own; returns the other words.
Words add_options(JsonObject& settings, const Words& words) {
    Words others;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const std::size_t equals = word.find('=');
        std::string key = word.starts_with("--") ? word.substr(2, equals - 2) : "";
        std::ranges::replace(key, '-', '_');
        const std::string_view type = type_of_setting(key);
        if (type == "bool") {
            settings.add(key, true);
        } else if (!type.empty() && equals != std::string::npos) {
            settings.add(key, word.substr(equals + 1));
        } else if (!type.empty() && i + 1 < words.size()) {
            settings.add(key, words[++i]);
        } else {
            others.push_back(word);
        }
    }
    return others;
}

/// Returns the job for the manager's API. `folder` has a line of its own, which the script that
/// sends the job writes.
std::string job_text(const FarmJob& job) {
    const bool by_povray = !job.render.empty() && !renders_by_blender(job);
    JsonObject settings(JsonLines{4});
    settings.add("folder", ".")
        .add("sea", kSeaFile)
        .add("output", job.output)
        .add("frames", runs_text(frame_runs(job.frames, 1), ""))
        .add("chunk_size", job.frames_per_task);
    const Words others = add_options(settings, job.options);
    settings.add("options", shell_words(others))
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
