// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The argument SEA or TERRAIN and the option --set, which most commands share, and the resolved and
// validated sea or terrain that they name.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "command.hpp"
#include "ocean/sea.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean::app {

struct SubjectArgument {
    std::string source;                    // a file of parameters, a baked file, or preset:NAME
    std::vector<std::string> assignments;  // name=value, in order
};

/// Returns the options SEA and --set for the kind "sea", TERRAIN and --set for "terrain".
OptionGroup subject_options(SubjectArgument& argument, std::string_view kind,
                            bool required = kRequired);

/// Return the sea or the terrain of an argument. Throw Error, also for a subject of the other kind.
Sea open_sea(const SubjectArgument& argument);
TerrainModel open_terrain(const SubjectArgument& argument);

/// Returns the kind of the subject that a source names. Standard input and pipes are not looked
/// into: they are seas, and so is what no reader knows. Throws Error not_found for a preset of no
/// kind.
std::string_view kind_of_source(const std::string& source);
using OpenedSubject = std::variant<Sea, TerrainModel>;
/// Returns the sea or the terrain of an argument, whichever it names. Throws Error.
OpenedSubject open_subject(const SubjectArgument& argument);

/// Throws Error unsupported for an option that only subjects of another kind have.
void refuse_options_of_others(const Context& context, std::string_view kind);

/// Sets a parameter of an open sea as --set does: a file that the value names is read, relative to
/// the working directory. Throws Error, after which the sea must not be used.
void set_in_sea(Sea& sea, const std::string& name, const std::string& value);

/// The presets of a kind of subject.
struct PresetList {
    std::string_view kind;
    std::string_view title;
    std::span<const Preset> presets;
};
std::array<PresetList, 2> preset_lists();
/// Returns the kind of a preset. Throws Error not_found, with the nearest names and `hint` at the
/// end, for a preset of no kind.
std::string_view kind_of_preset(const std::string& name, const std::string& hint);

}  // namespace ocean::app
