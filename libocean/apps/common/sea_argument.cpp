// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See sea_argument.hpp.
#include "sea_argument.hpp"

#include <algorithm>
#include <filesystem>

#include "any_spectra.hpp"
#include "assignment.hpp"
#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrainfile.hpp"
#include "source_text.hpp"

namespace ocean::app {
namespace {

Sea read_source(const std::string& source) {
    if (source.starts_with(kPresetPrefix)) {
        const std::string name = source.substr(kPresetPrefix.size());
        if (std::ranges::find(terrain_presets(), name, &Preset::name) != terrain_presets().end()) {
            throw Error(ErrorKind::not_found, source + " is a terrain, not a sea" + kTerrainHint);
        }
        return parse_sea(find_preset(name).toml, source, "", read_any_spectra);
    }
    const SourceText found = read_source_text(source, kSeaKind);
    try {
        return parse_sea(found.text, found.name, found.base_dir, read_any_spectra);
    } catch (const Error& error) {
        const std::string message = error.what();
        if (!message.ends_with("is a terrain file, not a sea file")) throw;
        throw Error(error.kind(), message + kTerrainHint, error.fields());
    }
}

void assign(Parameters& parameters, const std::string& name, std::string value) {
    const std::string_view key = find_parameter(name).info->key;
    if ((key == "file" || key == "take" || key == "seabed") && !value.empty()) {
        value = std::filesystem::absolute(utf8_path(value))
                    .string();  // relative to the working directory
    }
    set_parameter(parameters, name, value);
}

}  // namespace

OptionGroup sea_options(SeaArgument& argument, bool required) {
    return {
        "Sea",
        {{"SEA", &argument.source, "",
          "A sea file, - for standard input, an EXR file that was baked from one, or preset:NAME",
          required},
         {"--set", &argument.assignments, "NAME=VALUE",
          "Change a parameter, such as wind_speed=12 or waves.1.fetch=50000; may be "
          "repeated"}}};
}

Sea open_sea(const SeaArgument& argument) {
    Sea sea = read_source(argument.source);
    for (const std::string& text : argument.assignments) {
        const Assignment set = parse_assignment(text, "wind_speed=12");
        assign(sea.parameters, set.name, set.value);
    }
    resolve_files(sea, utf8_path(argument.source).parent_path().string(), read_any_spectra);
    validate(sea);
    return sea;
}

void set_in_sea(Sea& sea, const std::string& name, const std::string& value) {
    assign(sea.parameters, name, value);
    resolve_files(sea, "", read_any_spectra);
    validate(sea);
}

}  // namespace ocean::app
