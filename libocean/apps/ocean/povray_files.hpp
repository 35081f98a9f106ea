// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files of a folder for POV-Ray beside its maps, as `ocean povray` writes them for seas and
// terrains.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "command.hpp"
#include "console.hpp"
#include "input_files.hpp"
#include "ocean/internal/bake/estimate.hpp"
#include "ocean/internal/bake/povray_folder.hpp"
#include "ocean/sea.hpp"
#include "region_argument.hpp"

namespace ocean::app {

/// The max of samples along a side for which POV-Ray makes a mesh.
inline constexpr int kMaxPovrayResolution = 2048;

/// Returns the extension of a format of the catalogue.
std::string povray_extension(const std::string& format);
/// Throws Error invalid_value for a map of more than kMaxPovrayResolution.
void refuse_large_mesh(int resolution);

/// Throws Error invalid_value if a file would replace one that another program or the user wrote:
/// an input of the command, or a file of the folder.
void refuse_to_replace_others(const std::vector<FolderFile>& files, const std::string& folder,
                              const InputFiles& inputs);
/// Throws Error invalid_value for a folder that has `file`, which is of `other`: "a terrain". Two
/// scenes would have one name.
void refuse_folder_of(const std::string& folder, const std::string& file, const std::string& other,
                      const std::string& own);
/// A folder with its files, and the plans of its maps in the order in which they are baked.
struct PovrayFolderWork {
    const std::string& folder;
    const std::vector<FolderFile>& files;
    const BakePlan& frames;  // the one of the plans that a forecast counts
    std::vector<const BakePlan*> plans;
};
/// Writes the files, but keeps the user's, and bakes the maps; prints the forecast alone in a dry
/// run. Returns true if it wrote. Throws Error.
bool write_folder(const PovrayFolderWork& work, bool dry_run, const Context& context);
/// Writes the lists of frames again: another chunk may have baked some meanwhile. `lists_of`
/// returns the files for all frames of the folder.
void update_frame_lists(
    const BakePlan& plan, const std::string& folder,
    const std::function<std::vector<FolderFile>(const std::vector<int>&)>& lists_of,
    const Context& context);
/// Warns of frames of another sea, format or resolution in the folder.
void warn_of_foreign_frames(const ExistingFrames& existing, const BakePlan& plan,
                            const std::string& folder, const Context& context);

/// The options of `ocean povray` that a terrain has too.
struct PovrayTerrainRequest {
    BakeOptions bake;
    std::vector<std::string> assignments;  // of --set
    std::string folder;
    std::string format;
    RegionArgument region;
    bool dry_run = false;
};
/// Writes the folder of a terrain. Throws Error.
void write_povray_terrain(const PovrayTerrainRequest& request, const Context& context);

/// The options of `ocean povray` for a sea over a bed.
struct PovrayCoastRequest {
    BakeOptions bake;
    const Sea& sea;
    std::string source;
    std::string folder;
    std::string format;
    RegionArgument region;
    bool near_only = false;
    bool dry_run = false;
};
/// Writes the folder of a sea over a bed. Throws Error.
void write_povray_coast(const PovrayCoastRequest& request, const Context& context);

}  // namespace ocean::app
