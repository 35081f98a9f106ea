// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See terrain_argument.hpp.
#include "terrain_argument.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "assignment.hpp"
#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"
#include "source_text.hpp"
#include "standard_input.hpp"

namespace ocean::app {
namespace {

bool is_preset_of(std::span<const Preset> list, std::string_view name) {
    return std::ranges::find(list, name, &Preset::name) != list.end();
}

TerrainModel read_source(const std::string& source) {
    if (source.starts_with(kPresetPrefix)) {
        const std::string name = source.substr(kPresetPrefix.size());
        if (is_preset_of(presets(), name) && !is_preset_of(terrain_presets(), name)) {
            throw Error(ErrorKind::not_found, source + " is a sea, not a terrain");
        }
        return parse_terrain(find_terrain_preset(name).toml, source, "");
    }
    const SourceText found = read_source_text(source, kTerrainKind);
    return parse_terrain(found.text, found.name, found.base_dir);
}

void assign(TerrainModel& terrain, const std::string& name, std::string value) {
    const auto ref = find_parameter(terrain_table(), name);
    const bool names_file =
        ref.info->holds<&TerrainModel::measured>() || ref.info->holds<&TerrainModel::base>();
    if (names_file && !value.empty()) {
        value = text::to_utf8(std::filesystem::absolute(utf8_path(value)));
    }
    set_parameter(terrain, name, value);
}

/// Throws for a parameter of a section that is switched off: setting it would do nothing.
void require_effect(const TerrainModel& terrain, const std::string& name) {
    const auto ref = find_parameter(terrain_table(), name);
    const TerrainRow* const first = switch_of(*ref.info);
    if (first == ref.info || !is_switched_off(terrain, *ref.info)) return;
    throw Error(ErrorKind::invalid_value,
                "--set " + name + ": has no effect while " + first->path() + " is 0; set that too");
}

}  // namespace

OptionGroup terrain_options(TerrainArgument& argument, bool required) {
    return {
        "Terrain",
        {{"TERRAIN", &argument.source, "",
          "A terrain file, - for standard input, a file that was baked from one, or preset:NAME",
          required},
         {"--set", &argument.assignments, "NAME=VALUE",
          "Change a parameter, such as beta=2.2 or terrain.layer.0.gain=0.5; may be repeated"}}};
}

TerrainModel open_terrain(const TerrainArgument& argument) {
    TerrainModel terrain = read_source(argument.source);
    for (const std::string& text : argument.assignments) {
        const Assignment set = parse_assignment(text, "beta=2.2");
        assign(terrain, set.name, set.value);
    }
    for (const std::string& text : argument.assignments) {
        require_effect(terrain, parse_assignment(text, "beta=2.2").name);
    }
    resolve_files(terrain, "");
    validate(terrain);
    return terrain;
}

bool names_terrain(const std::string& source) {
    if (source.starts_with(kPresetPrefix)) {
        return is_preset_of(terrain_presets(), source.substr(kPresetPrefix.size()));
    }
    if (source == kStandardInput || text::is_pipe_or_device(source)) return false;
    try {
        const auto provenance = io::read_provenance(source);
        if (provenance) return provenance->kind == kTerrainKind;
        return kind_of_file_text(text::read_file(source, kMaxSeaFileBytes)) == kTerrainKind;
    } catch (const Error&) {
        return false;  // its reader explains what is wrong
    }
}

void refuse_unknown_preset(const std::string& source) {
    if (!source.starts_with(kPresetPrefix)) return;
    const std::string name = source.substr(kPresetPrefix.size());
    std::vector<std::string_view> names;
    for (const std::span<const Preset> list : {presets(), terrain_presets()}) {
        if (is_preset_of(list, name)) return;
        for (const Preset& preset : list) names.push_back(preset.name);
    }
    throw Error(ErrorKind::not_found, "no preset is called '" + text::printable(name) + "'" +
                                          did_you_mean(name, names) +
                                          "; `ocean presets` lists those of seas and terrains");
}

}  // namespace ocean::app
