// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean presets`: lists the built-in seas.
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/seafile.hpp"

namespace ocean::app {
namespace {

std::string presets_text() {
    std::string text;
    for (const Preset& preset : presets()) {
        text += format_text("%-14s%s\n", preset.name.c_str(), preset.description.c_str());
    }
    return text;
}

std::string presets_json() {
    JsonArray list(JsonLines{1});
    for (const Preset& preset : presets()) {
        list.add(JsonObject().add("name", preset.name).add("description", preset.description));
    }
    return list.text() + "\n";
}

}  // namespace

Command presets_command() {
    auto name = std::make_shared<std::string>();
    return {
        .name = "presets",
        .summary = "List the presets, or print the sea file of one",
        .options = {{"", {{"NAME", name.get(), "", "Print the sea file of this preset"}}},
                    {"Output",
                     {{"--json", &RunOptions::json, "", "Print the list as a JSON array"}}}},
        .run =
            [name](const Context& context) {
                if (!name->empty()) return context.console.data(find_preset(*name).toml);
                context.console.data(context.options.json ? presets_json() : presets_text());
            },
    };
}

}  // namespace ocean::app
