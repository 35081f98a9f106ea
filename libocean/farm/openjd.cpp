// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Open Job Description: a job bundle. template.yaml lets the engine choose the frames of a task,
// template_shards.yaml needs no extension of the specification.
#include <string>
#include <vector>

#include "job.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::farm {
namespace {

/// A path in the folder of the job, which the engine may put anywhere.
std::string in_bundle(const std::string& path) {
    return is_absolute(path) ? path : "{{Param.Job}}/" + path;
}

/// Returns texts of the user in a form that the engine does not read as parameters of its own.
void require_no_braces(const FarmJob& job) {
    Words words = job.options;
    words.insert(words.end(), {job.output, job.render});
    for (const std::string& word : words) {
        if (word.find("{{") == std::string::npos) continue;
        throw Error(ErrorKind::invalid_value,
                    word + ": Open Job Description reads {{ as a parameter of its own");
    }
}

std::string parameter(const std::string& name, const std::string& type, const Json& value,
                      const std::string& more = "") {
    return "- name: " + name + "\n  type: " + type + "\n" + more + "  default: " + value.text() +
           "\n";
}

std::string head(const FarmJob& job, bool in_chunks) {
    std::string text = "# " + std::string(kMark) +
                       ".\nspecificationVersion: jobtemplate-2023-09\n" +
                       (in_chunks ? "extensions:\n- TASK_CHUNKING\n" : "") +
                       "name: " + json_string(job_name(job)) + "\nparameterDefinitions:\n";
    text += parameter("Job", "PATH", ".", "  objectType: DIRECTORY\n  dataFlow: INOUT\n");
    text += parameter("Ocean", "STRING", "ocean");
    if (in_chunks) text += parameter("FramesPerTask", "INT", job.frames_per_task);
    if (!job.render.empty()) {
        text += renders_by_blender(job) ? parameter("Blender", "STRING", "blender")
                                        : parameter("Povray", "STRING", "povray");
    }
    return text + "steps:\n";
}

/// The parts of a step that differ.
struct Step {
    std::string name;
    std::string after = {};  // the step before it
    std::string tasks = {};  // the parameters of its tasks, in YAML
    std::string program;     // a parameter's name
    Words words;
    bool has_needs = false;
};

std::string step_text(const FarmJob& job, const Step& step) {
    std::string text = "- name: " + step.name + "\n";
    if (!step.after.empty()) text += "  dependencies:\n  - dependsOn: " + step.after + "\n";
    if (!step.tasks.empty()) {
        text += "  parameterSpace:\n    taskParameterDefinitions:\n" + step.tasks;
    }
    if (step.has_needs && (job.threads > 0 || job.memory_bytes > 0)) {
        text += "  hostRequirements:\n    amounts:\n";
        if (job.threads > 0) {
            text += format_text("    - name: amount.worker.vcpu\n      min: %d\n", job.threads);
        }
        if (job.memory_bytes > 0) {
            text += "    - name: amount.worker.memory\n      min: " +
                    std::to_string((job.memory_bytes >> 20) + 1) + "\n";
        }
    }
    text += "  script:\n    actions:\n      onRun:\n        command: \"{{Param." + step.program +
            "}}\"\n        args: " + json_words(step.words) + "\n";
    if (step.has_needs && job.minutes > 0) {
        text += format_text("        timeout: %d\n", 60 * job.minutes);
    }
    return text;
}

std::string task_parameter(const std::string& name, const std::string& type,
                           const std::string& range, const std::string& more = "") {
    return "    - name: " + name + "\n      type: " + type +
           "\n      range: " + json_string(range) + "\n" + more;
}

std::string frame_range(const FarmJob& job) {
    return runs_text(frame_runs(job.frames), ":");
}

/// Returns the words of a command with these further ones, and with its progress as the engine
/// reads it.
Words with_progress(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), {"--progress", "openjd_progress: #"});
    return words;
}

Words bake_with(const FarmJob& job, const Words& more) {
    return with_progress(bake_words(job, in_bundle), more);
}

/// The steps that check and render; they follow the step `after`.
std::string later_steps(const FarmJob& job, const std::string& after) {
    std::string text = step_text(job, {.name = "Check",
                                       .after = after,
                                       .program = "Ocean",
                                       .words = with_progress(check_words(job, in_bundle), {})});
    if (job.render.empty()) return text;
    Step render{.name = "Render",
                .after = "Check",
                .tasks = task_parameter("Frame", "INT", frame_range(job)),
                .program = renders_by_blender(job) ? "Blender" : "Povray",
                .words = {}};
    if (renders_by_blender(job)) {
        render.words = {"-b", in_bundle(job.render), "-f", "{{Task.Param.Frame}}"};
    } else {
        render.words = povray_words(job, in_bundle);
        render.words.insert(render.words.end(),
                            {"+SF{{Task.Param.Frame}}", "+EF{{Task.Param.Frame}}"});
    }
    return text + step_text(job, render);
}

/// Tasks of so many frames as the engine likes write into one manifest. Where a network disk loses
/// entries of it, the step Complete reads those frames and enters them.
std::string chunk_template(const FarmJob& job) {
    const bool has_gaps = frame_runs(job.frames, 1).size() > 1;
    const std::string chunks =
        "      chunks:\n        defaultTaskCount: \"{{Param.FramesPerTask}}\"\n"
        "        rangeConstraint: " +
        std::string(has_gaps ? "NONCONTIGUOUS" : "CONTIGUOUS") + "\n";
    return head(job, true) +
           step_text(job,
                     {.name = "Bake",
                      .tasks = task_parameter("Frames", "CHUNK[INT]", frame_range(job), chunks),
                      .program = "Ocean",
                      .words = bake_with(job, {"--frames", "{{Task.Param.Frames}}"}),
                      .has_needs = true}) +
           step_text(job, {.name = "Complete",
                           .after = "Bake",
                           .program = "Ocean",
                           .words = bake_with(job, {"--frames", frames_word(job)})}) +
           later_steps(job, "Complete");
}

std::string shard_template(const FarmJob& job) {
    const std::string tasks = std::to_string(job.tasks());
    return head(job, false) +
           step_text(job, {.name = "Bake",
                           .tasks = task_parameter("Shard", "INT", "1-" + tasks),
                           .program = "Ocean",
                           .words = bake_with(job, {"--frames", frames_word(job), "--shard",
                                                    "{{Task.Param.Shard}}/" + tasks}),
                           .has_needs = true}) +
           later_steps(job, "Bake");
}

std::string asset_references(const FarmJob& job) {
    Words inputs = {std::string(kSeaFile)};
    if (!job.render.empty()) inputs.push_back(job.render);
    return "# " + std::string(kMark) +
           ".\nassetReferences:\n  inputs:\n    filenames: " + json_words(inputs) +
           "\n    directories: []\n  outputs:\n    directories: " +
           json_words({folder_of(job.output)}) + "\n  referencedPaths: []\n";
}

std::string parameter_values() {
    return "# " + std::string(kMark) +
           ".\nparameterValues:\n- name: Job\n  value: \".\"\n- name: Ocean\n  value: \"ocean\"\n";
}

std::vector<FarmFile> files(const FarmJob& job) {
    require_no_braces(job);
    return {{"template.yaml", chunk_template(job)},
            {"template_shards.yaml", shard_template(job)},
            {"asset_references.yaml", asset_references(job)},
            {"parameter_values.yaml", parameter_values()}};
}

}  // namespace

const FarmEngine kOpenjd = {.name = "openjd",
                            .summary =
                                "Open Job Description: a job bundle, as AWS Deadline Cloud "
                                "takes it",
                            .submit = "openjd run template.yaml",
                            .max_tasks = 1 << 30,
                            .files = files};

}  // namespace ocean::farm
