// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See command_words.hpp.
#include "command_words.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "help_text.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/platform.hpp"

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

/// Returns the second words of the commands that begin with `first`: "import" of "terrain import".
std::vector<std::string_view> second_words(const Program& program, std::string_view first) {
    std::vector<std::string_view> seconds;
    for (const Command& command : program.commands) {
        const std::string_view name = command.name;
        if (name.size() > first.size() && name.starts_with(first) && name[first.size()] == ' ') {
            seconds.push_back(name.substr(first.size() + 1));
        }
    }
    return seconds;
}

/// Returns the program's commands, each one followed by those whose names begin with its name.
std::vector<HelpRow> rows_of(const Program& program) {
    std::vector<HelpRow> rows;
    for (const Command& command : program.commands) {
        if (command.name.find(' ') != std::string::npos) continue;
        rows.push_back({command.name, command.summary});
        for (const Command& other : program.commands) {
            if (other.name.starts_with(command.name + " ")) {
                rows.push_back({other.name, other.summary});
            }
        }
    }
    return rows;
}

/// Returns the commands whose names begin with the command's name, by their second words.
std::vector<HelpRow> rows_below(const Program& program, const Command& command) {
    std::vector<HelpRow> rows;
    for (const std::string_view second : second_words(program, command.name)) {
        const std::string name = command.name + " " + std::string(second);
        const auto found = std::ranges::find(program.commands, name, &Command::name);
        rows.push_back({std::string(second), found->summary});
    }
    return rows;
}

bool names_a_file(std::string_view word) {
    std::error_code ignored;
    return word.find_first_of("./\\:") != std::string_view::npos ||
           std::filesystem::exists(utf8_path(word), ignored);
}

/// Reads the words of one command line.
class WordReader {
  public:
    WordReader(const Program& program, std::span<char* const> words)
        : program_(program), words_(words), known_(options_of(program.main)) {
        known_.push_back({"--version", false});
    }

    CommandWords read() {
        CommandWords result;
        for (; at_ < words_.size(); ++at_) {
            const std::string_view word = words_[at_];
            if (word == "--") break;
            if (word == "-h" || word == "--help" || word.starts_with("--help=")) {
                result.help = help();
                return result;
            }
            if (word.size() > 1 && word.starts_with('-')) {
                read_option(word);
            } else if (!program_.commands.empty() && command_ == nullptr) {
                read_command(word);
            } else {
                read_argument(word);
            }
        }
        require_runnable();
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (i == second_at_) continue;
            result.words.push_back(i == command_at_ ? parser_name(*command_) : words_[i]);
        }
        return result;
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
            for (const Command& command : program_.commands) {
                if (command.name.find(' ') == std::string::npos) names.push_back(command.name);
            }
            throw refused("unknown command '" + text::printable(word) + "'" +
                          did_you_mean(word, names));
        }
        choose(*found);
        command_at_ = at_;
        may_be_second_ = true;
    }

    void choose(const Command& command) {
        command_ = &command;
        known_ = options_of(command);
    }

    /// Reads a word that is no option. The first one after a command may be its second word.
    void read_argument(std::string_view word) {
        if (!may_be_second_) return;
        may_be_second_ = false;
        const std::vector<std::string_view> seconds = second_words(program_, command_->name);
        if (std::ranges::find(seconds, word) != seconds.end()) {
            const std::string name = command_->name + " " + std::string(word);
            choose(*std::ranges::find(program_.commands, name, &Command::name));
            second_at_ = at_;
            return;
        }
        const std::string hint = did_you_mean(word, seconds);
        const bool is_argument = command_->run && (hint.empty() || names_a_file(word));
        if (seconds.empty() || is_argument) return;
        throw refused("unknown command '" + command_->name + " " + text::printable(word) + "'" +
                      hint);
    }

    /// Throws for a command that only begins the names of others.
    void require_runnable() const {
        if (command_ == nullptr || command_->run) return;
        std::string known;
        for (const std::string_view second : second_words(program_, command_->name)) {
            known += (known.empty() ? "" : ", ") + std::string(second);
        }
        throw refused("a command is required after '" + command_->name + "': " + known);
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

    static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

    const Program& program_;
    std::span<char* const> words_;
    std::vector<KnownOption> known_;  // of the command, once it was read
    const Command* command_ = nullptr;
    std::size_t at_ = 0;
    std::size_t command_at_ = kNowhere;  // of the command's first and second word
    std::size_t second_at_ = kNowhere;
    bool may_be_second_ = false;  // the next argument may be the command's second word
};

}  // namespace

CommandWords read_command_words(const Program& program, std::span<char* const> words) {
    return WordReader(program, words).read();
}

std::string parser_name(const Command& command) {
    std::string name = command.name;
    std::ranges::replace(name, ' ', '.');
    return name;
}

std::string help_of(const Program& program, const std::string& name) {
    const auto command = std::ranges::find(program.commands, name, &Command::name);
    if (command == program.commands.end()) {
        return command_help(program.main, program.main.name, rows_of(program), true);
    }
    Command shown = *command;
    if (shown.footer.empty()) shown.footer = program.main.footer;
    return command_help(shown, program.main.name + " " + name, rows_below(program, *command),
                        false);
}

}  // namespace ocean::app
