// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See help_text.hpp.
#include "help_text.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "text.hpp"

namespace ocean::app {
namespace {

constexpr std::size_t kIndent = 2;
constexpr std::size_t kTextColumn = 28;

/// Returns the lines of a row; a long name has its text on the next line.
std::string row_text(const HelpRow& row) {
    std::string line = std::string(kIndent, ' ') + row.name;
    if (row.text.empty()) return line + "\n";
    std::string text = wrapped(row.text, kTextColumn, kHelpColumns);
    if (line.size() + kIndent > kTextColumn) return line + "\n" + text;
    return line + text.substr(line.size());
}

std::string section_text(const HelpSection& section) {
    std::string text = "\n" + section.title + ":\n";
    for (const HelpRow& row : section.rows) text += row_text(row);
    return text;
}

HelpRow row_of(const Option& option) {
    std::string text = option.help;
    if (!option.excludes.empty()) text += "; not with " + option.excludes;
    if (option.required && !is_positional(option)) text += " (required)";
    return {option_name(option), text};
}

std::vector<HelpSection> sections_of(const Command& command, bool has_version) {
    HelpSection positionals{"Positionals", {}};
    HelpSection unnamed{"Options", {{"-h, --help", "Print this help message and exit"}}};
    if (has_version) {
        unnamed.rows.push_back(
            {"--version", "Print the versions of this program and of its libraries"});
    }
    std::vector<HelpSection> named;
    for (const OptionGroup& group : command.options) {
        for (const Option& option : group.options) {
            if (is_positional(option)) {
                positionals.rows.push_back(row_of(option));
                continue;
            }
            if (group.name.empty()) {
                unnamed.rows.push_back(row_of(option));
                continue;
            }
            auto section = std::ranges::find(named, group.name, &HelpSection::title);
            if (section == named.end()) section = named.insert(section, {group.name, {}});
            section->rows.push_back(row_of(option));
        }
    }
    std::vector<HelpSection> all;
    if (!positionals.rows.empty()) all.push_back(std::move(positionals));
    if (!command.pages.empty()) {
        HelpSection& pages = all.emplace_back(HelpSection{command.pages_title, {}});
        for (const HelpPage& page : command.pages) {
            pages.rows.push_back({page.names.front(), page.summary});
        }
    }
    all.push_back(std::move(unnamed));
    std::ranges::move(named, std::back_inserter(all));
    return all;
}

std::string usage_text(const Command& command, const std::string& usage, bool has_commands) {
    std::string text = "Usage: " + usage + " [OPTIONS]";
    if (has_commands && !command.run) text += " COMMAND";
    for (const Option* option : options_of(command)) {
        if (!is_positional(*option)) continue;
        text += option->required ? " " + option->names : " [" + option->names + "]";
    }
    text += "\n";
    if (has_commands && command.run) text += "       " + usage + " COMMAND [OPTIONS]\n";
    return text;
}

/// Returns the commands that may follow: all of a program, or those with a second word. In a
/// program's list each command is followed by those whose names begin with its name.
std::vector<HelpRow> rows_of_commands(const Program& program, const Command& command) {
    std::vector<HelpRow> rows;
    if (&command != &program.main) {
        for (const Command* below : commands_below(program, command)) {
            rows.push_back({std::string(second_word(*below)), below->summary});
        }
        return rows;
    }
    for (const Command& first : program.commands) {
        if (!second_word(first).empty()) continue;
        rows.push_back({first.name, first.summary});
        for (const Command* below : commands_below(program, first)) {
            rows.push_back({below->name, below->summary});
        }
    }
    return rows;
}

}  // namespace

std::string option_name(const Option& option) {
    std::string name = joined(names_of(option), ", ");
    if (!option.type.empty()) name += " " + option.type;
    if (takes_several(option)) name += " ...";
    return name;
}

std::string usage_of(const Program& program, const Command& command) {
    const bool is_main = &command == &program.main;
    return is_main ? command.name : program.main.name + " " + command.name;
}

std::string command_help(const Program& program, const Command& command) {
    const std::vector<HelpRow> commands = rows_of_commands(program, command);
    std::string text = wrapped(command.summary, 0, kHelpColumns);
    text += usage_text(command, usage_of(program, command), !commands.empty());
    std::vector<HelpSection> sections = sections_of(command, &command == &program.main);
    if (!commands.empty()) sections.push_back({"Commands", commands});
    for (const HelpSection& section : sections) text += section_text(section);
    const std::string& footer = command.footer.empty() ? program.main.footer : command.footer;
    if (!footer.empty()) text += "\n" + footer + "\n";
    return text;
}

std::string page_help(const HelpPage& page) {
    std::string text = wrapped(page.title, 0, kHelpColumns);
    text += "Usage: " + page.usage + "\n";
    for (const HelpSection& section : page.sections) text += section_text(section);
    return text;
}

}  // namespace ocean::app
