// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See command.hpp.
#include "command.hpp"

#include <algorithm>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::app {

void refuse(const std::string& sentence) {
    throw Error(ErrorKind::invalid_value, sentence);
}

std::string OneOf::fault_of(const std::string& value) const {
    if (std::ranges::find(words, value) != words.end()) return "";
    const std::vector<std::string_view> known(words.begin(), words.end());
    return "'" + text::printable(value) + "' is none of " + joined(words, ", ") +
           did_you_mean(value, known);
}

std::vector<OptionGroup> options_for(std::string_view kind, std::vector<OptionGroup> groups) {
    for (OptionGroup& group : groups) {
        std::erase_if(group.options, [&](const Option& option) {
            return !option.subject.empty() && option.subject != kind;
        });
    }
    return groups;
}

OptionGroup run_options(const std::string& json_help) {
    OptionGroup group{"Running",
                      {{"--threads", &RunOptions::threads, "N", "Threads to use; 0 = all cores",
                        kOptional, Within{0, 1024}},
                       {"-q,--quiet", &RunOptions::quiet, "", "Print errors only"},
                       {"-v,--verbose", &RunOptions::verbose, "", "Print more details"}}};
    if (!json_help.empty()) group.options.push_back({"--json", &RunOptions::json, "", json_help});
    return group;
}

OptionGroup progress_option() {
    return {"Running",
            {{"--progress", &RunOptions::progress, "LINE",
              "Print LINE on standard error at each per cent, with its number for #, such as "
              "'openjd_progress: #'; -q leaves these lines alone",
              kOptional, NotEmpty{}, "--json"}}};
}

bool is_positional(const Option& option) {
    return !option.names.starts_with('-') && !option.names.starts_with('!');
}

std::vector<std::string> names_of(const Option& option) {
    return split(option.names.substr(option.names.starts_with('!') ? 1 : 0), ',');
}

std::string name_of(const Option& option) {
    return names_of(option).back();
}

Takes takes(const Option& option) {
    if (std::holds_alternative<bool*>(option.target) ||
        std::holds_alternative<bool RunOptions::*>(option.target)) {
        return Takes::nothing;
    }
    return std::holds_alternative<std::optional<std::string>*>(option.target)
               ? Takes::optional_value
               : Takes::value;
}

bool takes_several(const Option& option) {
    return std::holds_alternative<std::vector<std::string>*>(option.target);
}

std::vector<const Option*> options_of(const Command& command) {
    std::vector<const Option*> options;
    for (const OptionGroup& group : command.options) {
        for (const Option& option : group.options) options.push_back(&option);
    }
    return options;
}

std::string_view second_word(const Command& command) {
    const std::size_t blank = std::min(command.name.find(' '), command.name.size() - 1);
    return std::string_view(command.name).substr(blank + 1);
}

std::vector<const Command*> commands_below(const Program& program, const Command& first) {
    std::vector<const Command*> below;
    for (const Command& command : program.commands) {
        if (command.name.starts_with(first.name + " ")) below.push_back(&command);
    }
    return below;
}

}  // namespace ocean::app
