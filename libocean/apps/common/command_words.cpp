// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See command_words.hpp.
#include "command_words.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "help_text.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"

namespace ocean::app {
namespace {

struct KnownOption {
    std::string name;  // "--frames" or "-o"
    bool takes_value;
};

bool takes_value(const Option& option) {
    return !std::holds_alternative<bool*>(option.target) &&
           !std::holds_alternative<bool RunOptions::*>(option.target) &&
           !std::holds_alternative<std::optional<std::string>*>(option.target);
}

std::vector<KnownOption> options_of(const Command& command) {
    std::vector<KnownOption> known = {{"-h", false}, {"--help", false}};
    for (const OptionGroup& group : command.options) {
        for (const Option& option : group.options) {
            std::string_view names = option.names;
            if (names.starts_with('!')) names.remove_prefix(1);
            if (!names.starts_with('-')) continue;
            while (!names.empty()) {
                const std::size_t comma = std::min(names.find(','), names.size());
                known.push_back({std::string(names.substr(0, comma)), takes_value(option)});
                names.remove_prefix(std::min(comma + 1, names.size()));
            }
        }
    }
    return known;
}

/// Reads the words of one command line.
class WordReader {
  public:
    WordReader(const Program& program, std::span<char* const> words)
        : program_(program), words_(words), known_(options_of(program.main)) {
        known_.push_back({"--version", false});
    }

    std::optional<std::string> requested_help() {
        for (; at_ < words_.size(); ++at_) {
            const std::string_view word = words_[at_];
            if (word == "--") return std::nullopt;
            if (word == "-h" || word == "--help" || word.starts_with("--help=")) return help();
            if (word.size() > 1 && word.starts_with('-')) {
                read_option(word);
            } else if (!program_.commands.empty() && command_ == nullptr) {
                read_command(word);
            }
        }
        return std::nullopt;
    }

  private:
    const Command& current() const { return command_ != nullptr ? *command_ : program_.main; }
    std::string usage() const {
        return program_.main.name + (command_ != nullptr ? " " + command_->name : "");
    }
    Error refused(const std::string& message) const {
        return Error(ErrorKind::invalid_value, message + " (see `" + usage() + " --help`)");
    }

    void read_option(std::string_view word) {
        const bool is_long = word.starts_with("--");
        const bool is_number = !is_long && (word[1] == '.' || (word[1] >= '0' && word[1] <= '9'));
        if (is_number) return;
        if (!is_long && word.size() > 2 && word[2] == '=') {
            // The parser would read it as several short options.
            throw Error(ErrorKind::invalid_value,
                        std::string(word) +
                            ": the value of a short option follows after a blank, and a flag has "
                            "none");
        }
        const std::size_t equals = std::min(word.find('='), word.size());
        const std::string_view name = word.substr(0, is_long ? equals : 2);
        const auto option = std::ranges::find(known_, name, &KnownOption::name);
        if (option == known_.end()) throw unknown_option(word.substr(0, equals));
        const bool has_value = equals < word.size() || (!is_long && word.size() > 2);
        if (option->takes_value && !has_value) ++at_;
    }

    Error unknown_option(std::string_view name) const {
        const std::string quoted = "'" + text::printable(name) + "'";
        if (command_ != nullptr && name == "--version") {
            return refused(quoted + " stands before the command");
        }
        std::vector<std::string_view> names;
        for (const KnownOption& option : known_) names.push_back(option.name);
        return refused("unknown option " + quoted + did_you_mean(name, names));
    }

    void read_command(std::string_view word) {
        const auto found = std::ranges::find(program_.commands, word, &Command::name);
        if (found == program_.commands.end()) {
            std::vector<std::string_view> names;
            for (const Command& command : program_.commands) names.push_back(command.name);
            throw refused("unknown command '" + text::printable(word) + "'" +
                          did_you_mean(word, names));
        }
        command_ = &*found;
        known_ = options_of(*command_);
    }

    /// Returns the page of help that the word at or after --help names, else the command's help.
    std::string help() const {
        std::string_view word = words_[at_];
        const std::size_t equals = word.find('=');
        if (equals != std::string_view::npos) {
            word.remove_prefix(equals + 1);
        } else {
            word = at_ + 1 < words_.size() ? words_[at_ + 1] : std::string_view();
            if (!names_a_page(word)) return help_of(program_, command_name());
        }
        for (const HelpPage& page : current().pages) {
            if (std::ranges::find(page.names, word) != page.names.end()) return page_help(page);
        }
        throw unknown_page(word);
    }

    std::string command_name() const { return command_ != nullptr ? command_->name : ""; }

    /// Returns false for another option, and for a SEA that follows --help.
    bool names_a_page(std::string_view word) const {
        if (current().pages.empty() || word.empty() || word.starts_with('-')) return false;
        if (word.starts_with('.')) word.remove_prefix(1);
        return word.find_first_of("./\\:") == std::string_view::npos;
    }

    Error unknown_page(std::string_view word) const {
        const std::string quoted = "'" + text::printable(word) + "'";
        if (current().pages.empty()) {
            return refused("--help of " + usage() + " has no page " + quoted);
        }
        for (const Command& command : program_.commands) {
            if (command.name != word) continue;
            return Error(ErrorKind::invalid_value, quoted + " is a command: see `" +
                                                       program_.main.name + " " + command.name +
                                                       " --help`");
        }
        std::vector<std::string_view> names;
        std::string known;
        for (const HelpPage& page : current().pages) {
            names.insert(names.end(), page.names.begin(), page.names.end());
            known += (known.empty() ? "" : ", ") + page.names.front();
        }
        return refused("unknown " + current().page_noun + " " + quoted + did_you_mean(word, names) +
                       "; known: " + known);
    }

    const Program& program_;
    std::span<char* const> words_;
    std::vector<KnownOption> known_;  // of the command, once it was read
    const Command* command_ = nullptr;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<std::string> requested_help(const Program& program, std::span<char* const> words) {
    return WordReader(program, words).requested_help();
}

std::string help_of(const Program& program, const std::string& name) {
    const auto command = std::ranges::find(program.commands, name, &Command::name);
    if (command == program.commands.end()) {
        return command_help(program.main, program.main.name, program.commands, true);
    }
    Command shown = *command;
    if (shown.footer.empty()) shown.footer = program.main.footer;
    return command_help(shown, program.main.name + " " + name, {}, false);
}

}  // namespace ocean::app
