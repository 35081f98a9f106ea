// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What lies around the frames of a folder that POV-Ray renders as it is: the macros, the sea's
// parameters, the texture of its foam, a scene, and the settings of its animation.
#pragma once

#include <string>
#include <vector>

#include "ocean/bake/frames_there.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/sea_state.hpp"

namespace ocean {

struct FolderFile {
    std::string name;
    std::string text;
    bool users = false;  // theirs to change: kept where it is

    /// What files of ours begin with, whatever else is in them.
    std::string opening() const;
};

/// Returns the frames of the plan's sea, form and maps that lie in its folder, and others.
FramesThere povray_frames_there(const BakePlan& plan);
/// Returns all files of the folder but its frames. `frames`: those that it has or will have,
/// ascending, at least one; `state`: of the plan's sea.
std::vector<FolderFile> povray_folder_files(const BakePlan& plan, const SeaState& state,
                                            const std::vector<int>& frames);
/// Returns those of them that depend on the frames.
std::vector<FolderFile> povray_frame_lists(const BakePlan& plan, const SeaState& state,
                                           const std::vector<int>& frames);

}  // namespace ocean
