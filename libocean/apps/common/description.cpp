// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See description.hpp.
#include "description.hpp"

#include "ocean/internal/json.hpp"

namespace ocean::app {
namespace {

JsonObject described(const Option& option) {
    constexpr std::string_view kTakes[] = {"nothing", "optional value", "value"};
    const auto* const one_of = std::get_if<OneOf>(&option.rule);
    return JsonObject()
        .add("names", json_array(names_of(option)))
        .add("type", option.type)
        .add("help", option.help)
        .add("required", option.required)
        .add("takes", kTakes[static_cast<std::size_t>(takes(option))])
        .add("repeats", takes_several(option))
        .add("words", one_of != nullptr ? json_array(one_of->words) : JsonArray())
        .add("excludes", option.excludes);
}

JsonObject described(const Command& command) {
    JsonArray groups;
    for (const OptionGroup& group : command.options) {
        JsonArray options;
        for (const Option& option : group.options) options.add(described(option));
        groups.add(JsonObject().add("name", group.name).add("options", options));
    }
    JsonArray pages;
    for (const HelpPage& page : command.pages) {
        pages.add(JsonObject().add("names", json_array(page.names)).add("summary", page.summary));
    }
    return JsonObject()
        .add("name", command.name)
        .add("summary", command.summary)
        .add("footer", command.footer)
        .add("runs", static_cast<bool>(command.run))
        .add("groups", groups)
        .add("pages_title", command.pages_title)
        .add("pages", pages);
}

}  // namespace

std::string description(const Program& program) {
    JsonArray commands;
    commands.add(described(program.main));
    for (const Command& command : program.commands) commands.add(described(command));
    return JsonObject().add("version", program.version).add("commands", commands).text() + "\n";
}

}  // namespace ocean::app
