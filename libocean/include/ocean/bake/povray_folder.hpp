// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What lies around the frames of a folder that POV-Ray renders as it is: the macros, the sea's
// parameters, the texture of its foam, a scene, and the settings of its animation.
#pragma once

#include <string>
#include <vector>

#include "ocean/bake/plan.hpp"

namespace ocean {

struct FolderFile {
    std::string name;
    std::string text;
    bool users = false;  // theirs to change: kept where it is

    /// What files of ours begin with, whatever else is in them.
    std::string opening() const;
};

/// `frames`: those of all shards, whose folder is one.
std::vector<FolderFile> povray_folder_files(const BakePlan& plan, const std::vector<int>& frames);

}  // namespace ocean
