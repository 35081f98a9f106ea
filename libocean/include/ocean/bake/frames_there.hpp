// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The frames that lie in a plan's folder, whoever baked them: chunks of one bake share the files
// that list its frames.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"

namespace ocean {

/// Frame numbers, ascending.
struct FramesThere {
    std::vector<int> of_plan;
    std::vector<int> foreign;  // of another sea or of other options
};

/// Looks into the folder for files of the plan's pattern, and asks `is_of_plan` of the files of
/// each frame. A folder that cannot be read has none.
FramesThere find_frames(const BakePlan& plan,
                        const std::function<bool(std::span<const BakeFile>)>& is_of_plan);

/// Returns the frames of both lists, ascending, each once.
std::vector<int> united(std::vector<int> frames, std::span<const int> others);

/// Warns of the foreign frames that `written` will not replace; `list` is the file that leaves them
/// out. Returns "" where there are none.
std::string foreign_frames_warning(const FramesThere& there, std::span<const int> written,
                                   const std::string& list);

}  // namespace ocean
