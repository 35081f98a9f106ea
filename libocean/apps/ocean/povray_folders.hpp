// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The folder that `ocean povray` writes: a row for each kind of subject, and one writer of them
// all.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "console.hpp"
#include "ocean/internal/bake/povray_folder.hpp"
#include "region_argument.hpp"
#include "subject_argument.hpp"

namespace ocean::app {

/// The options of `ocean povray` as they were typed.
struct PovrayRequest {
    BakeOptions bake;
    SubjectArgument subject;
    std::string folder;
    std::string format = "df3";
    RegionArgument region;  // of a terrain or a coast
    bool near_only = false;
    bool dry_run = false;
};

/// The time and memory that POV-Ray will need, as a line and as members of a JSON object.
struct PovrayCost {
    std::string text;
    Console::Members members;
};

/// A folder that is planned and not written. `files` returns all files beside the maps, and
/// `frame_lists` those of them that depend on the frames, for all frames that the folder has or
/// will have; both take the folder's plans.
struct PovrayFolder {
    using Files = std::function<std::vector<FolderFile>(std::span<const BakePlan> plans,
                                                        const std::vector<int>& frames)>;

    std::vector<BakePlan> plans;  // of its maps, in the order in which they are baked
    std::size_t counted = 0;      // the plan whose frames the folder counts
    Files files;
    Files frame_lists = {};  // empty for a folder without frames
    std::optional<PovrayCost> cost = {};
};

/// Returns the folder of an open sea, of a sea over a bed or of a terrain. Throws Error, also for
/// options that the subject does not have.
PovrayFolder plan_povray_folder(const PovrayRequest& request, const OpenedSubject& subject,
                                const Context& context);

/// Writes the files, but keeps those that are the user's, and bakes the maps; prints the forecast
/// alone in a dry run. Throws Error, before it writes, if a file would replace an input or a file
/// that another program wrote.
void write_povray_folder(const PovrayFolder& folder, const PovrayRequest& request,
                         const Context& context);

}  // namespace ocean::app
