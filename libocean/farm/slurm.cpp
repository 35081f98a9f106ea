// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// SLURM: scripts for sbatch, and a script that sends them in order. A task is an element of an
// array, and its number that of a shard.
#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "job.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::farm {
namespace {

/// MaxArraySize is 1001 unless a cluster sets it, and an array's numbers are below it.
constexpr int kMaxArray = 1000;

std::string unchanged(const std::string& path) {
    return path;
}

/// Returns the head of a script for sbatch: its name, and one directive a line.
std::string head(const FarmJob& job, const std::string& step, Words directives) {
    directives.insert(directives.begin(), {"--job-name=" + job_name(job) + "-" + step,
                                           "--open-mode=append", "--requeue"});
    std::string text = "#!/bin/sh\n";
    for (const std::string& one : directives) text += "#SBATCH " + one + "\n";
    return text + "# " + std::string(kMark) + " for the folder of this script.\nset -e\n";
}

/// Returns the directives of an array of `count` tasks.
Words array_of(int count, const std::string& step) {
    return {format_text("--array=1-%d", count), "--output=" + step + ".%a.log"};
}

/// Returns the directives of what a step of `ocean` needs.
Words needs(const FarmJob& job) {
    Words words;
    if (job.threads > 0) words.push_back(format_text("--cpus-per-task=%d", job.threads));
    if (job.memory_bytes > 0) {
        constexpr std::uint64_t kMebibyte = 1 << 20;
        words.push_back("--mem=" + std::to_string((job.memory_bytes + kMebibyte - 1) / kMebibyte) +
                        "M");
    }
    return words;
}

/// Returns the command `ocean` with these words, on the cores of the task unless they say on how
/// many.
std::string ocean_line(const FarmJob& job, const Words& words, const std::string& shard) {
    const bool says_threads = std::ranges::any_of(
        words, [](const std::string& word) { return word.starts_with("--threads"); });
    return "\"${OCEAN:-ocean}\" " + shell_words(words) + shard +
           (job.threads > 0 && !says_threads
                ? format_text(" --threads \"${SLURM_CPUS_PER_TASK:-%d}\"", job.threads)
                : std::string()) +
           "\n";
}

FarmFile bake_script(const FarmJob& job) {
    Words directives = array_of(job.tasks(), "bake");
    std::ranges::move(needs(job), std::back_inserter(directives));
    if (job.minutes > 0) directives.push_back(format_text("--time=%d", job.minutes));
    Words words = bake_words(job, unchanged);
    words.insert(words.end(), {"--frames", frames_word(job), "--shard"});
    return {"bake.sbatch",
            head(job, "bake", directives) +
                ocean_line(job, words, format_text(" \"$SLURM_ARRAY_TASK_ID/%d\"", job.tasks()))};
}

FarmFile check_script(const FarmJob& job) {
    Words directives = {"--output=check.log"};
    std::ranges::move(needs(job), std::back_inserter(directives));
    return {"check.sbatch",
            head(job, "check", directives) + ocean_line(job, check_words(job, unchanged), "")};
}

FarmFile render_script(const FarmJob& job) {
    const int all = static_cast<int>(job.frames.size());
    const int tasks = std::min(all, kMaxArray);
    std::string text = head(job, "render", array_of(tasks, "render")) + "frames() {\n";
    for (const FrameRun& run : frame_runs(job.frames)) {
        text += format_text("    seq %d %d %d\n", run.first, run.step, run.last);
    }
    text += "}\ni=$SLURM_ARRAY_TASK_ID\n" +
            format_text(
                "for frame in $(frames | sed -n \"$((%d * (i - 1) / %d + 1)),$((%d * i / "
                "%d))p\"); do\n    ",
                all, tasks, all, tasks);
    if (renders_by_blender(job)) {
        text += "\"${BLENDER:-blender}\" -b " + shell_word(job.render) + " -f \"$frame\"";
    } else {
        text += "\"${POVRAY:-povray}\" " + shell_words(povray_words(job, unchanged)) +
                " \"+SF$frame\" \"+EF$frame\"";
    }
    return {"render.sbatch", text + "\ndone\n"};
}

FarmFile submit_script(const FarmJob& job) {
    const std::string after =
        " --dependency=\"afterok:${%s%%%%;*}\" --kill-on-invalid-dep=yes \"$@\" ";
    std::string text =
        "#!/bin/sh\n# " + std::string(kMark) +
        ": sends the job. Arguments go to each sbatch: sh submit.sh --partition=NAME\n"
        "set -e\ncd \"$(dirname \"$0\")\"\n"
        "bake=$(sbatch --parsable \"$@\" bake.sbatch)\n"
        "check=$(sbatch --parsable" +
        format_text(after.c_str(), "bake") + "check.sbatch)\n";
    if (job.render.empty()) return {"submit.sh", text + "echo \"$bake $check\"\n"};
    return {"submit.sh", text + "render=$(sbatch --parsable" + format_text(after.c_str(), "check") +
                             "render.sbatch)\necho \"$bake $check $render\"\n"};
}

std::vector<FarmFile> files(const FarmJob& job) {
    std::vector<FarmFile> all = {bake_script(job), check_script(job)};
    if (!job.render.empty()) all.push_back(render_script(job));
    all.push_back(submit_script(job));
    return all;
}

}  // namespace

const FarmEngine kSlurm = {.name = "slurm",
                           .summary = "SLURM: scripts for sbatch",
                           .submit = "sh submit.sh",
                           .max_tasks = kMaxArray,
                           .files = files};

}  // namespace ocean::farm
