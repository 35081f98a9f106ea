// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The frames that exist in a plan's folder, from any run: chunks of one bake share the files that
// list its frames.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"

namespace ocean {

/// Returns, ascending, the frames of this shard that may have files already. Reads the plan's
/// folder once, so that a million new frames cost no question to the file system each; a folder
/// that cannot be read may hold them all.
std::vector<int> frames_that_may_exist(const BakePlan& plan);
/// Returns the files of frames_that_may_exist(), after the files that frames share.
std::vector<BakeFile> files_that_may_exist(const BakePlan& plan);
/// Returns the paths of files_that_may_exist(), after the path of the manifest.
std::vector<std::string> paths_that_may_exist(const BakePlan& plan);

/// Frame numbers, ascending.
struct ExistingFrames {
    std::vector<int> of_plan;
    std::vector<int> foreign;  // of another subject or of other options
};

/// Returns the frames whose files match the plan's pattern, sorted by `matches_plan`, which gets
/// the files of one frame. A folder that cannot be read has no frames.
ExistingFrames find_frames(const BakePlan& plan,
                           const std::function<bool(std::span<const BakeFile>)>& matches_plan);

/// Returns the frames of both lists, ascending, without duplicates.
std::vector<int> united(std::vector<int> frames, std::span<const int> others);

/// Returns a warning about the foreign frames that `written` will not replace, or "" if none
/// remain. `list` is the file that leaves out the foreign frames.
std::string foreign_frames_warning(const ExistingFrames& existing, std::span<const int> written,
                                   const std::string& list);

}  // namespace ocean
