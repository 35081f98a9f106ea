// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean presets`: lists the built-in seas and terrains.
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrainfile.hpp"
#include "subject_argument.hpp"

namespace ocean::app {
namespace {

std::string presets_text() {
    std::string text;
    for (const PresetList& list : preset_lists()) {
        text += (text.empty() ? "" : "\n") + std::string(list.title) + "\n";
        for (const Preset& preset : list.presets) {
            text += format_text("  %-14s%s\n", preset.name.c_str(), preset.description.c_str());
        }
    }
    return text;
}

std::string presets_json() {
    JsonArray array(JsonLines{1});
    for (const PresetList& list : preset_lists()) {
        for (const Preset& preset : list.presets) {
            array.add(JsonObject()
                          .add("name", preset.name)
                          .add("description", preset.description)
                          .add("kind", list.kind));
        }
    }
    return array.text() + "\n";
}

/// Returns the file of a preset of any kind. Throws Error not_found naming the nearest.
const std::string& preset_file(const std::string& name) {
    const bool is_sea = kind_of_preset(name, "lists them") == kSeaKind;
    return (is_sea ? find_preset(name) : find_terrain_preset(name)).toml;
}

}  // namespace

Command presets_command() {
    auto name = std::make_shared<std::string>();
    return {
        .name = "presets",
        .summary = "List the presets, or print the file of one",
        .options = {{"", {{"NAME", name.get(), "", "Print the file of this preset"}}},
                    {"Output",
                     {{"--json", &RunOptions::json, "", "Print the list as a JSON array"}}}},
        .run =
            [name](const Context& context) {
                if (!name->empty()) return context.console.data(preset_file(*name));
                context.console.data(context.options.json ? presets_json() : presets_text());
            },
    };
}

}  // namespace ocean::app
