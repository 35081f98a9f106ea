// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean farm`: writes a bake as a job for the engine of a render farm.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bake_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "input_files.hpp"
#include "interrupt.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/bake/estimate.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/farm/farm_job.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/platform.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr int kMinutes = 10;

struct FarmOptions {
    BakeArguments bake;
    std::set<std::string> passed = {"--threads"};  // names of bake's options that a job repeats
    std::string engine, render;
    std::string folder = "farm";
    int minutes = kMinutes;
    int tasks = 0;  // 0 = by the minutes
    bool dry_run = false;
};

/// Returns bake's options without those that a job sets itself.
std::vector<OptionGroup> options_of_bake(FarmOptions& options, const Catalogue& catalogue) {
    static const std::set<std::string> not_ours = {"--from",    "--shard",   "--skip-existing",
                                                   "--dry-run", "--summary", "--egl-device",
                                                   "--stage"};
    static const std::set<std::string> in_sea_or_job = {"--set", "--fps", "--output", "--frames"};
    std::vector<OptionGroup> groups = bake_options(options.bake, catalogue);
    for (OptionGroup& group : groups) {
        std::erase_if(group.options,
                      [](const Option& one) { return not_ours.contains(name_of(one)); });
        for (Option& one : group.options) {
            const std::string name = name_of(one);
            if (is_positional(one) || name == "--frames") one.required = kRequired;
            if (name == "--frames") one.help = "FIRST-LAST[xSTEP] in comma lists, such as 1-250x2";
            if (name == "--output") one.help += "; it starts from the job's folder";
            if (!is_positional(one) && !in_sea_or_job.contains(name)) options.passed.insert(name);
        }
    }
    return groups;
}

std::string path_in(const std::string& folder, const std::string& name) {
    return text::to_utf8(utf8_path(folder) / utf8_path(name));
}

/// Returns true for a file of an earlier job, which may be replaced or removed.
bool is_of_a_job(const std::string& path) {
    constexpr std::size_t kMaxFile = std::size_t{1} << 30;
    return is_farm_file(text::read_file(path, kMaxFile));
}

void write_job(const std::string& folder, const std::vector<FarmFile>& files) {
    io::make_folder(folder);
    for (const std::string& name : farm_file_names()) {
        const std::filesystem::path path = utf8_path(path_in(folder, name));
        if (std::ranges::count(files, name, &FarmFile::name) == 0 &&
            std::filesystem::is_regular_file(path) && is_of_a_job(path_in(folder, name))) {
            std::filesystem::remove(path);
        }
    }
    for (const FarmFile& file : files) {
        io::write_file_atomically(path_in(folder, file.name), file.text);
    }
}

std::vector<std::string> words_for_bake(const FarmOptions& options, const Context& context) {
    std::vector<std::string> words;
    for (const auto& [option, value] : context.given) {
        const std::string name = name_of(*option);
        if (!options.passed.contains(name)) continue;
        // A value may begin with "-".
        words.push_back(takes(*option) == Takes::nothing || value.empty() ? name
                                                                          : name + "=" + value);
    }
    return words;
}

/// Sets the frames of a task and the minutes after which it is ended. Returns those that it is
/// expected to take here.
double size_tasks(const FarmOptions& options, const FarmEngine& engine, const BakePace& pace,
                  FarmJob& job) {
    const int all = static_cast<int>(job.frames.size());
    const auto frames_each = [&](int tasks) { return (all + tasks - 1) / tasks; };
    if (options.tasks > 0) {
        job.frames_per_task = frames_each(options.tasks);
    } else {
        const double rest = (60.0 * options.minutes - pace.first) / std::max(pace.next, 1e-9);
        const double frames = pace.frames_at_a_time * (1.0 + std::floor(std::max(rest, 0.0)));
        const int some = static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(all)));
        job.frames_per_task = std::max(some, frames_each(engine.max_tasks));
    }
    const double expected = pace.seconds(job.frames_per_task) / 60.0;
    // Ample: for slower machines, and for disks.
    job.minutes = 10 + static_cast<int>(std::ceil(3.0 * expected));
    return expected;
}

void show_job(const FarmOptions& options, const FarmEngine& engine, const FarmJob& job,
              double minutes, const BakePace& pace, const BakeForecast& forecast, Console& console,
              bool as_json) {
    if (as_json) {
        console.data(JsonObject()
                         .add("job", options.folder)
                         .add("engine", engine.name)
                         .add("frames", job.frames.size())
                         .add("tasks", job.tasks())
                         .add("frames_per_task", job.frames_per_task)
                         .add("seconds_per_task", 60.0 * minutes)
                         .add("limit_minutes", job.minutes)
                         .add("threads", job.threads)
                         .add("memory_bytes", job.memory_bytes)
                         .add("bytes", forecast.bytes)
                         .add("send", engine.submit)
                         .text() +
                     "\n");
        return;
    }
    std::string text =
        format_text("tasks    %d of at most %d of %zu frames, then a check%s\n", job.tasks(),
                    job.frames_per_task, job.frames.size(),
                    job.render.empty() ? "" : ", then the render") +
        format_text("minutes  about %.2g a task and those of writing; ended after %d\n", minutes,
                    job.minutes);
    if (pace.first > 2.0 * pace.next) {
        text +=
            format_text("start    about %.2g of the minutes, the past of foam too, once a task\n",
                        (pace.first - pace.next) / 60.0);
    }
    text += "memory   " + bytes_text(job.memory_bytes) +
            format_text(" a task, with %d threads\n", job.threads) + "bytes    " +
            bytes_text(forecast.bytes) + " at most, of all frames\n" + "send     " +
            std::string(engine.submit) + "   (in the folder " + options.folder + ")\n";
    console.data(text);
}

void run(const FarmOptions& options, const Catalogue& catalogue, const Context& context) {
    const FarmEngine& engine = find_farm_engine(options.engine);
    BakeArguments bake = options.bake;
    bake.bake.output = path_in(options.folder, bake.bake.output);
    const BakePlan plan = plan_bake(bake, catalogue, context);
    const std::size_t tasks_asked = static_cast<std::size_t>(options.tasks);
    if (tasks_asked > plan.frames.size()) {
        refuse(format_text("--tasks %d: more than the %zu frames of the job", options.tasks,
                           plan.frames.size()));
    }
    FarmJob job{
        .sea_text = plan.subject_text,
        .time_of = [time = plan.subject->timeline()](int frame) { return time.time_of(frame); },
        .output = options.bake.bake.output,
        .frames = plan.frames,
        .options = words_for_bake(options, context),
        .render = options.render,
        .threads = plan.threads > 0 ? plan.threads : available_cores()};
    const InputFiles inputs(bake.subject.source, plan.subject->named_files());
    // A draft, which lacks what is measured, shows whether the job can be written.
    for (const FarmFile& file : farm_files(engine, job)) {
        const std::string path = path_in(options.folder, file.name);
        inputs.spare(path);
        io::refuse_to_replace_foreign_file(path, "a farm job", [&] { return is_of_a_job(path); });
    }
    io::require_folder(options.folder);
    const BakeForecast forecast = forecast_bake(plan);
    const BakePace pace = measure_bake_pace(plan);
    job.memory_bytes = forecast.memory_bytes;
    const double minutes = size_tasks(options, engine, pace, job);
    const std::vector<FarmFile> files = farm_files(engine, job);
    for (const std::string& warning : forecast.warnings) context.console.warning(warning);
    if (!options.dry_run) {
        const InterruptWatch::Hold whole = context.interrupts.hold();
        write_job(options.folder, files);
    }
    show_job(options, engine, job, minutes, pace, forecast, context.console, context.options.json);
}

constexpr char kFooter[] =
    R"(Writes a folder: the sea, which needs no other file, and what the engine reads.
-o and --render start from that folder, so that it can be moved. A task bakes a
part of the frames; when all have ended well, one runs `ocean check --merge`,
then the scene is rendered. Whatever is lost, send the job again: it keeps the
frames that are whole. Two frames are computed for the forecast.
slurm     sh submit.sh [--partition=NAME ...]
openjd    openjd run template.yaml, or template_shards.yaml without chunks
flamenco  sh submit.sh http://MANAGER:8080; ocean_bake.js is the job type
Exit codes: 0 done, 1 failed at run time (disk, memory), 2 wrong usage or bad
sea file.)";

}  // namespace

Command farm_command(const Catalogue& catalogue) {
    auto options = std::make_shared<FarmOptions>();
    options->bake.kind = kSeaKind;
    OneOf engines;
    for (const FarmEngine& engine : farm_engines()) engines.words.emplace_back(engine.name);
    std::vector<OptionGroup> groups = options_of_bake(*options, catalogue);
    const OptionGroup farm = {
        "Farm",
        {{"--engine", &options->engine, "NAME", "slurm, openjd (Open Job Description) or flamenco",
          kRequired, engines},
         {"--job", &options->folder, "FOLDER", "The folder of the job; default: farm", kOptional,
          NotEmpty{}},
         {"--minutes", &options->minutes, "M",
          "Minutes of a task on this machine, which set its frames; default 10", kOptional,
          Within{1, 10000}},
         {"--tasks", &options->tasks, "N", "Number of tasks that bake, in place of --minutes",
          kOptional, Within{1, 1000000}, "--minutes"},
         {"--render", &options->render, "FILE",
          "A scene of POV-Ray, .pov, or Blender, .blend, to render when all frames are whole",
          kOptional, NotEmpty{}},
         {"-n,--dry-run", &options->dry_run, "", "Print the summary; write nothing"}}};
    groups.insert(groups.begin() + 1, farm);
    groups.push_back(run_options("Print one JSON object"));
    return {
        .name = "farm",
        .summary = "Write a bake as a job for a render farm: SLURM, OpenJD, Flamenco",
        .options = groups,
        .footer = kFooter,
        .run = [options, &catalogue](const Context& context) { run(*options, catalogue, context); },
    };
}

}  // namespace ocean::app
