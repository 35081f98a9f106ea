// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files beside the frames of a folder that POV-Ray renders as it is: the macros, the parameters
// of the sea or the terrain, the texture of the foam, a scene, and the settings of the animation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ocean/bake/plan.hpp"
#include "ocean/internal/bake/existing_frames.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/terrain.hpp"

namespace ocean {

/// Lines of a folder's settings. Jitter moves the rays of each pixel at random: a level horizon,
/// which a pixel shows a part of, would be a row of dashes.
inline constexpr std::string_view kPovrayPicture =
    "Width=960\nHeight=540\n"
    "Antialias=on\nAntialias_Threshold=0.1\nAntialias_Depth=2\nJitter=off\n"
    "Display=off\n";

struct FolderFile {
    std::string name;
    std::string text;
    bool is_users = false;  // the user's to change: an existing file is kept

    /// Returns the beginning that all versions of this file share.
    std::string opening() const;
};

/// Returns the frames in the plan's folder, divided into frames of the plan's sea, format and
/// resolution, and others.
ExistingFrames povray_existing_frames(const BakePlan& plan);
/// Where textures of foam may be found. All folders of a sea have the same textures.
struct FoamImages {
    std::string folder;      // the folder that gets the files
    std::string cache = {};  // keeps new textures, if it is writable; "": none
};
/// Returns all files of the folder except its frames. `frames` lists the frames that it has or will
/// have, ascending, at least one; `state` is the state of the plan's sea.
std::vector<FolderFile> povray_folder_files(const BakePlan& plan, const SeaState& state,
                                            const std::vector<int>& frames, const FoamImages& foam);
/// Returns all files of the folder of a terrain except its maps. `state` is the state of the plan's
/// terrain, `format` the format of the folder. With mesh2 the plan describes the map beside the
/// mesh.
std::vector<FolderFile> povray_terrain_files(const BakePlan& plan, const TerrainState& state,
                                             std::string_view format);
/// The plans of the folder of a sea over a bed or with hulls: its open sea, without these, and a
/// region of the sea. The references must outlive it.
struct PovrayRegionPlans {
    const BakePlan& open;
    const BakePlan& region;
};
/// Returns all files of such a folder except its frames: the files of its open sea, and the bed as
/// a land. `state` is the state of the open sea.
std::vector<FolderFile> povray_region_files(const PovrayRegionPlans& plans, const SeaState& state,
                                            const std::vector<int>& frames, const FoamImages& foam);
/// Returns only the files of povray_region_files() that depend on the frames.
std::vector<FolderFile> povray_region_frame_lists(const PovrayRegionPlans& plans,
                                                  const SeaState& state,
                                                  const std::vector<int>& frames);
/// Returns only the files of povray_folder_files() that depend on the frames.
std::vector<FolderFile> povray_frame_lists(const BakePlan& plan, const SeaState& state,
                                           const std::vector<int>& frames);

}  // namespace ocean
