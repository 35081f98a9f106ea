// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The common part of the engines of a farm: the words of the commands that a job runs, frames as
// ranges, words of a shell.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/farm/farm_job.hpp"

namespace ocean::farm {

using Words = std::vector<std::string>;
/// Spells a path of the job as an engine does.
using PathSpeller = std::function<std::string(const std::string& path)>;

extern const FarmEngine kSlurm, kOpenjd, kFlamenco;

/// The first words of each text, and the mark of is_farm_file().
inline constexpr std::string_view kMark = "Written by `ocean farm`";
/// The text of ocean_bake.js, the job type of Flamenco.
extern const std::string_view kOceanBakeScript;
inline constexpr std::string_view kSeaFile = "sea.toml";

/// FIRST-LAST, or FIRST-LAST in steps.
struct FrameRun {
    int first;
    int last;
    int step;
};
/// Returns ascending frames as runs of steps up to `max_step`.
std::vector<FrameRun> frame_runs(const std::vector<int>& frames, int max_step = 1 << 30);
/// Returns "1-9x2,20" for the separator 'x' of steps.
std::string runs_text(const std::vector<FrameRun>& runs, std::string_view step_separator);
std::string frames_word(const FarmJob& job);  // for --frames

/// Return the words after `ocean`: a bake without its frames, and the check of all frames.
Words bake_words(const FarmJob& job, const PathSpeller& spelled);
Words check_words(const FarmJob& job, const PathSpeller& spelled);

bool renders_by_blender(const FarmJob& job);
/// Returns the words after `povray` for any frame; +SF and +EF choose it. As in the folder of
/// `ocean povray`, frame_number is the frame and clock its time.
Words povray_words(const FarmJob& job, const PathSpeller& spelled);
/// Returns the words of povray_words() that state the animation.
Words povray_clock(const FarmJob& job);

/// Returns the folder of a path; "." for a name alone.
std::string folder_of(const std::string& path);
bool is_absolute(const std::string& path);
/// Returns the stem of the output in letters that every engine accepts as a job's name.
std::string job_name(const FarmJob& job);

/// Returns the text as one word of a POSIX shell.
std::string shell_word(const std::string& text);
/// Returns the words of a shell's command.
std::string shell_words(const Words& words);
/// Returns the words as a JSON array, which YAML and JavaScript read too.
std::string json_words(const Words& words);

}  // namespace ocean::farm
