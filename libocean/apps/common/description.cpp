// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See description.hpp.
#include "description.hpp"

#include "ocean/internal/json.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::app {
namespace {

std::string_view taken_by(const OptionTarget& target) {
    if (std::holds_alternative<bool*>(target) ||
        std::holds_alternative<bool RunOptions::*>(target)) {
        return "nothing";
    }
    return std::holds_alternative<std::optional<std::string>*>(target) ? "optional value" : "value";
}

JsonObject described(const Option& option) {
    const std::string names = option.names.substr(option.names.starts_with('!') ? 1 : 0);
    const auto* const one_of = std::get_if<OneOf>(&option.rule);
    return JsonObject()
        .add("names", json_array(split(names, ',')))
        .add("type", option.type)
        .add("help", option.help)
        .add("required", option.required)
        .add("takes", taken_by(option.target))
        .add("repeats", std::holds_alternative<std::vector<std::string>*>(option.target))
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
