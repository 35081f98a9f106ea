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

bool is_positional(const Option& option) {
    return !option.names.starts_with('-') && !option.names.starts_with('!');
}

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

std::vector<HelpSection> sections_of(const std::vector<OptionGroup>& groups, bool has_version) {
    HelpSection positionals{"Positionals", {}};
    HelpSection unnamed{"Options", {{"-h, --help", "Print this help message and exit"}}};
    if (has_version) {
        unnamed.rows.push_back(
            {"--version", "Print the versions of this program and of its libraries"});
    }
    std::vector<HelpSection> named;
    for (const OptionGroup& group : groups) {
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
    all.push_back(std::move(unnamed));
    std::ranges::move(named, std::back_inserter(all));
    return all;
}

std::string usage_text(const Command& command, const std::string& usage, bool has_commands) {
    std::string text = "Usage: " + usage + " [OPTIONS]";
    if (has_commands && !command.run) text += " COMMAND";
    for (const OptionGroup& group : command.options) {
        for (const Option& option : group.options) {
            if (!is_positional(option)) continue;
            text += option.required ? " " + option.names : " [" + option.names + "]";
        }
    }
    text += "\n";
    if (has_commands && command.run) text += "       " + usage + " COMMAND [OPTIONS]\n";
    return text;
}

}  // namespace

std::string option_name(const Option& option) {
    std::string name = option.names.substr(option.names.starts_with('!') ? 1 : 0);
    if (const std::size_t comma = name.find(','); comma != std::string::npos) {
        name.insert(comma + 1, " ");
    }
    if (!option.type.empty()) name += " " + option.type;
    if (std::holds_alternative<std::vector<std::string>*>(option.target)) name += " ...";
    return name;
}

std::string command_help(const Command& command, const std::string& usage,
                         const std::vector<HelpRow>& commands, bool has_version) {
    std::string text = wrapped(command.summary, 0, kHelpColumns);
    text += usage_text(command, usage, !commands.empty());
    std::vector<HelpSection> sections = sections_of(command.options, has_version);
    if (!command.pages.empty()) {
        HelpSection pages{command.pages_title, {}};
        for (const HelpPage& page : command.pages) {
            pages.rows.push_back({page.names.front(), page.summary});
        }
        const bool has_positionals = sections.front().title == "Positionals";
        sections.insert(sections.begin() + (has_positionals ? 1 : 0), std::move(pages));
    }
    if (!commands.empty()) sections.push_back({"Commands", commands});
    for (const HelpSection& section : sections) text += section_text(section);
    if (!command.footer.empty()) text += "\n" + command.footer + "\n";
    return text;
}

std::string page_help(const HelpPage& page) {
    std::string text = wrapped(page.title, 0, kHelpColumns);
    text += "Usage: " + page.usage + "\n";
    for (const HelpSection& section : page.sections) text += section_text(section);
    return text;
}

}  // namespace ocean::app
