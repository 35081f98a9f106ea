// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See subject_argument.hpp.
#include "subject_argument.hpp"

#include <algorithm>
#include <filesystem>

#include "any_spectra.hpp"
#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/io/subject_words.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"
#include "source_text.hpp"
#include "standard_input.hpp"

namespace ocean::app {
namespace {

/// NAME=VALUE, as --set gives it to a parameter.
struct Assignment {
    std::string name;
    std::string value;  // may be empty
};

/// Returns the parts of the argument of a --set. example: an assignment that an error shows. Throws
/// Error invalid_value.
Assignment parse_assignment(const std::string& text, std::string_view example) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        refuse("--set " + text + ": allowed is NAME=VALUE, such as " + std::string(example));
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

// The differences between kinds of subjects.

struct SeaKind {
    static constexpr std::string_view kName = kSeaKind;
    static constexpr const char* kExample = "wind_speed=12";
    static constexpr auto find = find_preset;

    static Sea parse(const std::string& text, const std::string& name,
                     const std::string& base_dir) {
        return parse_sea(text, name, base_dir, read_any_spectra);
    }
    static void resolve(Sea& sea, const std::string& source) {
        resolve_files(sea, utf8_path(source).parent_path().string(), read_any_spectra);
    }
    static Parameters& parameters(Sea& sea) { return sea.parameters; }
    static bool names_file(const std::string& parameter) {
        const std::string_view key = find_parameter(parameter).info->key;
        return key == "file" || key == "take" || key == "seabed";
    }
    static void require_effect(const Sea&, const std::string&) {}
};

struct TerrainKind {
    static constexpr std::string_view kName = kTerrainKind;
    static constexpr const char* kExample = "beta=2.2";
    static constexpr auto find = find_terrain_preset;

    static TerrainModel parse(const std::string& text, const std::string& name,
                              const std::string& base_dir) {
        return parse_terrain(text, name, base_dir);
    }
    static void resolve(TerrainModel& terrain, const std::string&) { resolve_files(terrain, ""); }
    static TerrainModel& parameters(TerrainModel& terrain) { return terrain; }
    static bool names_file(const std::string& parameter) {
        const TerrainRow& row = *find_parameter(terrain_table(), parameter).info;
        return row.holds<&TerrainModel::measured>() || row.holds<&TerrainModel::base>();
    }
    /// Throws for a parameter of a section that is switched off: setting it would do nothing.
    static void require_effect(const TerrainModel& terrain, const std::string& parameter) {
        const TerrainRow& row = *find_parameter(terrain_table(), parameter).info;
        const TerrainRow* const first = switch_of(row);
        if (first == &row || !is_switched_off(terrain, row)) return;
        refuse("--set " + parameter + ": has no effect while " + first->path() +
               " is 0; set that too");
    }
};

/// Returns "" for a preset of no kind.
std::string_view find_kind_of_preset(std::string_view name) {
    for (const PresetList& list : preset_lists()) {
        if (std::ranges::count(list.presets, name, &Preset::name) != 0) return list.kind;
    }
    return "";
}

template <typename Kind>
auto read_source(const std::string& source) {
    if (source.starts_with(kPresetPrefix)) {
        const std::string name = source.substr(kPresetPrefix.size());
        const std::string_view kind = find_kind_of_preset(name);
        if (!kind.empty() && kind != Kind::kName) {
            throw Error(ErrorKind::not_found, source + " is " + io::subject_words(kind).noun +
                                                  ", not " + io::subject_words(Kind::kName).noun +
                                                  (kind == kTerrainKind ? kTerrainHint : ""));
        }
        return Kind::parse(Kind::find(name).toml, source, "");
    }
    const SourceText found = read_source_text(source, Kind::kName);
    try {
        return Kind::parse(found.text, found.name, found.base_dir);
    } catch (const Error& error) {
        const std::string message = error.what();
        if (!message.ends_with("is a terrain file, not a sea file")) throw;
        throw Error(error.kind(), message + kTerrainHint, error.fields());
    }
}

/// Sets a parameter; the file that it names is relative to the working directory.
template <typename Kind, typename Model>
void assign(Model& model, const std::string& name, std::string value) {
    if (Kind::names_file(name) && !value.empty()) {
        value = text::to_utf8(std::filesystem::absolute(utf8_path(value)));
    }
    set_parameter(Kind::parameters(model), name, value);
}

template <typename Kind>
auto open(const SubjectArgument& argument) {
    auto model = read_source<Kind>(argument.source);
    std::vector<Assignment> assignments;
    for (const std::string& text : argument.assignments) {
        const Assignment& set = assignments.emplace_back(parse_assignment(text, Kind::kExample));
        assign<Kind>(model, set.name, set.value);
    }
    for (const Assignment& set : assignments) Kind::require_effect(model, set.name);
    Kind::resolve(model, argument.source);
    validate(model);
    return model;
}

}  // namespace

OptionGroup subject_options(SubjectArgument& argument, std::string_view kind, bool required) {
    const bool is_sea = kind == kSeaKind;
    return {is_sea ? "Sea" : "Terrain",
            {{is_sea ? "SEA" : "TERRAIN", &argument.source, "",
              is_sea ? "A sea file, - for standard input, an EXR file that was baked from one, or "
                       "preset:NAME"
                     : "A terrain file, - for standard input, a file that was baked from one, or "
                       "preset:NAME",
              required},
             {"--set", &argument.assignments, "NAME=VALUE",
              is_sea ? "Change a parameter, such as wind_speed=12 or waves.1.fetch=50000; may be "
                       "repeated"
                     : "Change a parameter, such as beta=2.2 or terrain.layer.0.gain=0.5; may be "
                       "repeated"}}};
}

Sea open_sea(const SubjectArgument& argument) {
    return open<SeaKind>(argument);
}

TerrainModel open_terrain(const SubjectArgument& argument) {
    return open<TerrainKind>(argument);
}

std::string_view kind_of_source(const std::string& source) {
    if (source.starts_with(kPresetPrefix)) {
        return kind_of_preset(source.substr(kPresetPrefix.size()),
                              "lists those of seas and terrains");
    }
    if (source == kStandardInput || text::is_pipe_or_device(source)) return kSeaKind;
    std::string kind;
    try {
        const auto provenance = io::read_provenance(source);
        kind = provenance ? provenance->kind
                          : kind_of_file_text(text::read_file(source, kMaxSeaFileBytes));
    } catch (const Error&) {
        // The reader of a sea explains what is wrong.
    }
    return kind == kTerrainKind ? kTerrainKind : kSeaKind;
}

OpenedSubject open_subject(const SubjectArgument& argument) {
    if (kind_of_source(argument.source) == kTerrainKind) return open_terrain(argument);
    return open_sea(argument);
}

void refuse_options_of_others(const Context& context, std::string_view kind) {
    for (const GivenOption& given : context.given) {
        const std::string_view only = given.option->subject;
        if (only.empty() || only == kind) continue;
        throw Error(ErrorKind::unsupported,
                    name_of(*given.option) + ": only " + io::subject_words(only).noun +
                        " has it, and this is " + io::subject_words(kind).noun);
    }
}

void set_in_sea(Sea& sea, const std::string& name, const std::string& value) {
    assign<SeaKind>(sea, name, value);
    SeaKind::resolve(sea, "");
    validate(sea);
}

std::array<PresetList, 2> preset_lists() {
    return {{{kSeaKind, "Seas", presets()}, {kTerrainKind, "Terrains", terrain_presets()}}};
}

std::string_view kind_of_preset(const std::string& name, const std::string& hint) {
    if (const std::string_view kind = find_kind_of_preset(name); !kind.empty()) return kind;
    std::vector<std::string_view> names;
    for (const PresetList& list : preset_lists()) {
        for (const Preset& preset : list.presets) names.push_back(preset.name);
    }
    throw Error(ErrorKind::not_found, "no preset is called '" + text::printable(name) + "'" +
                                          did_you_mean(name, names) + "; `ocean presets` " + hint);
}

}  // namespace ocean::app
