// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See farm_job.hpp and job.hpp.
#include "job.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {

using namespace farm;

namespace {

[[noreturn]] void refuse(const std::string& sentence) {
    throw Error(ErrorKind::invalid_value, sentence);
}

bool ends_with_any(const std::string& text, std::span<const std::string_view> endings) {
    return std::ranges::any_of(endings, [&](std::string_view one) { return text.ends_with(one); });
}

constexpr std::array<std::string_view, 1> kBlenderScenes = {".blend"};
constexpr std::array<std::string_view, 1> kPovrayScenes = {".pov"};

void check(const FarmEngine& engine, const FarmJob& job) {
    if (job.output.empty()) refuse("a farm needs the path of the frames, -o");
    if (job.frames.empty()) refuse("a farm needs frames, --frames");
    if (job.tasks() > engine.max_tasks) {
        refuse(format_text("%d tasks: %s takes at most %d; allowed: more frames a task",
                           job.tasks(), std::string(engine.name).c_str(), engine.max_tasks));
    }
    if (job.render.empty()) return;
    const std::string scene = lower_case(job.render);
    if (!ends_with_any(scene, kBlenderScenes) && !ends_with_any(scene, kPovrayScenes)) {
        refuse("--render " + job.render + ": a scene of POV-Ray, .pov, or of Blender, .blend");
    }
    if (job.frames.front() < 0) {
        refuse("--render: neither POV-Ray nor Blender's -f has frames below 0");
    }
}

}  // namespace

int FarmJob::tasks() const {
    const int all = static_cast<int>(frames.size());
    return frames_per_task <= 0 ? 1 : (all + frames_per_task - 1) / frames_per_task;
}

std::span<const FarmEngine> farm_engines() {
    static const std::array<FarmEngine, 3> engines = {kSlurm, kOpenjd, kFlamenco};
    return engines;
}

const FarmEngine& find_farm_engine(std::string_view name) {
    const std::span<const FarmEngine> engines = farm_engines();
    const auto found = std::ranges::find(engines, name, &FarmEngine::name);
    if (found != engines.end()) return *found;
    const auto name_of = [](const FarmEngine& engine) { return engine.name; };
    refuse("--engine " + std::string(name) + ": no such engine" +
           did_you_mean(name, engines, name_of) +
           "; known: " + joined(engines, ", ", [](auto& one) { return std::string(one.name); }));
}

std::vector<FarmFile> farm_files(const FarmEngine& engine, FarmJob job) {
    std::ranges::sort(job.frames);
    job.frames.erase(std::unique(job.frames.begin(), job.frames.end()), job.frames.end());
    check(engine, job);
    std::vector<FarmFile> files = {
        {std::string(kSeaFile), "# " + std::string(kMark) + ".\n" + job.sea_text}};
    std::ranges::move(engine.files(job), std::back_inserter(files));
    return files;
}

std::vector<std::string> farm_file_names() {
    const FarmJob largest{.sea_text = {},
                          .time_of = [](int) { return 0.0; },
                          .output = "sea.####.exr",
                          .frames = {1},
                          .options = {},
                          .render = "scene.pov"};
    std::vector<std::string> names = {std::string(kSeaFile)};
    for (const FarmEngine& engine : farm_engines()) {
        for (FarmFile& file : engine.files(largest)) names.push_back(std::move(file.name));
    }
    return names;
}

bool is_farm_file(std::string_view text) {
    return text.find(kMark) != std::string_view::npos;
}

namespace farm {

std::vector<FrameRun> frame_runs(const std::vector<int>& frames, int max_step) {
    std::vector<FrameRun> runs;
    for (std::size_t i = 0; i < frames.size();) {
        const auto step_after = [&](std::size_t at) {
            return static_cast<long long>(frames[at + 1]) - frames[at];
        };
        std::size_t last = std::min(i + 1, frames.size() - 1);
        const long long step = last > i ? step_after(i) : 1;
        while (last + 1 < frames.size() && step_after(last) == step) ++last;
        // Two frames apart are no range: 1,5-7 and not 1-5x4,6,7.
        if (step > max_step || (step > 1 && last < i + 2)) last = i;
        runs.push_back({frames[i], frames[last], last > i ? static_cast<int>(step) : 1});
        i = last + 1;
    }
    return runs;
}

std::string runs_text(const std::vector<FrameRun>& runs, std::string_view step_separator) {
    return joined(runs, ",", [&](const FrameRun& run) {
        std::string text = std::to_string(run.first);
        if (run.last != run.first) text += "-" + std::to_string(run.last);
        if (run.step > 1) text += std::string(step_separator) + std::to_string(run.step);
        return text;
    });
}

std::string frames_word(const FarmJob& job) {
    return runs_text(frame_runs(job.frames), "x");
}

Words bake_words(const FarmJob& job, const PathSpeller& spelled) {
    Words words = {"bake", spelled(std::string(kSeaFile)), "-o", spelled(job.output),
                   "--skip-existing"};
    words.insert(words.end(), job.options.begin(), job.options.end());
    return words;
}

Words check_words(const FarmJob& job, const PathSpeller& spelled) {
    return {"check",          spelled(job.output), "--frames",
            frames_word(job), "--against",         spelled(std::string(kSeaFile)),
            "--merge"};
}

bool renders_by_blender(const FarmJob& job) {
    return ends_with_any(lower_case(job.render), kBlenderScenes);
}

Words povray_clock(const FarmJob& job) {
    // With one frame POV-Ray's clock is not a number.
    const int first = job.frames.front();
    const int last = std::max(job.frames.back(), first + 1);
    return {format_text("+KFI%d", first), format_text("+KFF%d", last),
            format_text("+KI%.9g", job.time_of(first)), format_text("+KF%.9g", job.time_of(last))};
}

Words povray_words(const FarmJob& job, const PathSpeller& spelled) {
    const std::string folder = spelled(folder_of(job.render));
    Words words = {"+I" + spelled(job.render), "+L" + folder, "+L" + spelled(folder_of(job.output)),
                   "+O" + folder + "/", "-D"};
    std::ranges::move(povray_clock(job), std::back_inserter(words));
    return words;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.find_last_of("/\\");
    return slash == std::string::npos ? "." : path.substr(0, std::max<std::size_t>(slash, 1));
}

bool is_absolute(const std::string& path) {
    const bool has_drive = path.size() > 1 && path[1] == ':';
    return path.starts_with('/') || path.starts_with('\\') || has_drive;
}

std::string job_name(const FarmJob& job) {
    constexpr std::size_t kMaxLength = 60;
    const std::size_t slash = job.output.find_last_of("/\\");
    std::string stem = job.output.substr(slash == std::string::npos ? 0 : slash + 1);
    stem = stem.substr(0, stem.find_first_of(".#%$"));
    for (char& c : stem) {
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    }
    while (stem.ends_with('_')) stem.pop_back();
    return stem.empty() ? "sea" : stem.substr(0, kMaxLength);
}

std::string shell_word(const std::string& text) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=,@%+-";
    if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
    return "'" + joined(split(text, '\''), "'\\''") + "'";
}

std::string shell_words(const Words& words) {
    return joined(words, " ", shell_word);
}

std::string json_words(const Words& words) {
    return json_array(words).text();
}

}  // namespace farm
}  // namespace ocean
