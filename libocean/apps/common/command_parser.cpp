// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See command_parser.hpp.
#include "command_parser.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

#include "help_text.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::app {
namespace {

constexpr char kEmptyValue[] = "an empty value is not allowed";

/// Sets the target of an option by its type.
struct TargetSetter {
    const Option& option;
    const std::string& value;

    void operator()(bool& flag) const { flag = is_on() != option.names.starts_with('!'); }
    void operator()(int& number) const {
        if (const auto* const rule = std::get_if<Within>(&option.rule)) {
            number = parse_whole_number(value, name_of(option), rule->lowest, rule->highest);
            return;
        }
        const char* const end = value.data() + value.size();
        const auto [rest, code] = std::from_chars(value.data(), end, number);
        if (code != std::errc() || rest != end) throw refused("; allowed: a whole number");
    }
    void operator()(std::optional<int>& number) const { (*this)(number.emplace()); }
    void operator()(std::optional<double>& number) const {
        number = text::parse_number(value);
        if (number && std::isfinite(*number)) return;
        throw refused(": allowed is a finite number");
    }
    void operator()(std::string& text) const { text = value; }
    void operator()(std::optional<std::string>& text) const { text = value; }
    void operator()(std::vector<std::string>& texts) const { texts.push_back(value); }

  private:
    Error refused(const std::string& fault) const {
        return Error(ErrorKind::invalid_value, name_of(option) + " = " + value + fault);
    }
    /// Returns true for a flag alone; a flag may be switched as --quiet=false.
    bool is_on() const {
        constexpr std::array<std::string_view, 5> kOn{"", "true", "yes", "on", "1"};
        constexpr std::array<std::string_view, 4> kOff{"false", "no", "off", "0"};
        if (std::ranges::find(kOn, value) != kOn.end()) return true;
        if (std::ranges::find(kOff, value) != kOff.end()) return false;
        throw refused(": a flag has no value");
    }
};

/// Returns the fault that a rule finds in a text; "" for none. Rules of numbers are checked when
/// the numbers are read.
std::string fault_of(const Option& option, const std::string& value) {
    if (std::holds_alternative<NotEmpty>(option.rule) && value.empty()) return kEmptyValue;
    const auto* const rule = std::get_if<OneOf>(&option.rule);
    return rule != nullptr ? rule->fault_of(value) : "";
}

bool names_a_file(std::string_view word) {
    std::error_code ignored;
    return word.find_first_of("./\\:") != std::string_view::npos ||
           std::filesystem::exists(utf8_path(word), ignored);
}

/// Returns false for "-", which is a file, and for a negative number.
bool looks_like_option(std::string_view word) {
    return word.size() > 1 && word[0] == '-' && word[1] != '.' &&
           !(word[1] >= '0' && word[1] <= '9');
}

class CommandParser {
  public:
    CommandParser(const Program& program, std::span<char* const> words)
        : program_(program), words_(words.begin(), words.end()) {}

    ParsedCommand parse(RunOptions& run_options) {
        for (; at_ < words_.size(); ++at_) {
            read(words_[at_]);
            if (text_) return {current(), text_};
        }
        require_runnable();
        place_arguments();
        for (const Command* command : {&program_.main, command_}) {
            if (command != nullptr) assign_all(*command, run_options);
        }
        if (!arguments_.empty()) {
            const char* const begin = arguments_.size() > 1
                                          ? "The following arguments were not expected: "
                                          : "The following argument was not expected: ";
            throw refused(begin + joined(arguments_, " "));
        }
        return {current(), std::nullopt, std::move(given_)};
    }

  private:
    const Command& current() const { return command_ != nullptr ? *command_ : program_.main; }
    Error refused(const std::string& message) const {
        return Error(ErrorKind::invalid_value,
                     message + " (see `" + usage_of(program_, current()) + " --help`)");
    }

    void read(std::string_view word) {
        if (only_arguments_ || !looks_like_option(word)) {
            read_argument(word);
        } else if (word == "--") {
            only_arguments_ = true;
        } else if (word == "--help" || word.starts_with("--help=")) {
            text_ = help(word);
        } else if (word == "--version" && command_ == nullptr) {
            text_ = program_.version + "\n";
        } else if (word.starts_with("--")) {
            read_long(word);
        } else {
            read_short(word);
        }
    }

    void read_long(std::string_view word) {
        const std::size_t equals = std::min(word.find('='), word.size());
        const Option& option = known_option(word.substr(0, equals), word);
        if (equals == word.size()) return give(option, value_after(option));
        if (equals + 1 == word.size()) throw refused(name_of(option) + ": " + kEmptyValue);
        give(option, word.substr(equals + 1));
    }

    /// Reads "-o", "-oFILE", and flags that share a dash, "-qv".
    void read_short(std::string_view word) {
        if (word.size() > 2 && word[2] == '=') {
            refuse(std::string(word) +
                   ": the value of a short option follows after a blank, and a flag has "
                   "none");
        }
        for (std::size_t i = 1; i < word.size(); ++i) {
            if (word[i] == 'h') {
                text_ = help(word);
                return;
            }
            const Option& option = known_option(std::string{'-', word[i]}, word);
            const std::string_view rest = word.substr(i + 1);
            const bool is_value = takes(option) == Takes::value && !rest.empty();
            give(option, is_value ? rest : value_after(option));
            if (is_value) return;
        }
    }

    void give(const Option& option, std::string_view value) {
        given_.push_back({&option, std::string(value)});
    }

    /// Takes the next word for an option that has no value yet; another option is no value.
    std::string_view value_after(const Option& option) {
        if (takes(option) == Takes::nothing) return "";
        const bool is_optional = takes(option) == Takes::optional_value;
        if (at_ + 1 < words_.size()) {
            const std::string_view next = words_[at_ + 1];
            const bool is_option = is_optional ? looks_like_option(next) : is_known(next);
            if (!is_option) return words_[++at_];
        }
        if (is_optional) return "";
        throw refused(name_of(option) + " needs a value, " + option.type);
    }

    bool is_known(std::string_view word) const {
        return word == "--" || word == "-h" || word == "--help" ||
               find_option(word.substr(0, word.find('='))) != nullptr;
    }

    const Option* find_option(std::string_view name) const {
        for (const Option* option : options_of(current())) {
            const bool has_name = std::ranges::count(names_of(*option), name) != 0;
            if (has_name && !is_positional(*option)) return option;
        }
        return nullptr;
    }

    /// Returns the option, or throws for the word that names it.
    const Option& known_option(std::string_view name, std::string_view word) const {
        if (const Option* const option = find_option(name)) return *option;
        word = word.substr(0, word.find('='));
        const std::string quoted = "'" + text::printable(word) + "'";
        if (command_ != nullptr && word == "--version") {
            throw refused(quoted + " stands before the command");
        }
        std::vector<std::string> names = {"-h", "--help"};
        for (const Option* option : options_of(current())) {
            if (!is_positional(*option))
                std::ranges::move(names_of(*option), std::back_inserter(names));
        }
        if (command_ == nullptr) names.emplace_back("--version");
        throw refused("unknown option " + quoted + did_you_mean(word, names, std::identity()));
    }

    void read_argument(std::string_view word) {
        const bool is_command = !only_arguments_ && !program_.commands.empty();
        if (is_command && command_ == nullptr) return read_command(word);
        if (is_command && arguments_.empty() && read_second_word(word)) return;
        arguments_.emplace_back(word);
    }

    void read_command(std::string_view word) {
        const auto found = std::ranges::find(program_.commands, word, &Command::name);
        if (found == program_.commands.end()) {
            std::vector<std::string_view> names;
            for (const Command& command : program_.commands) {
                if (second_word(command).empty()) names.push_back(command.name);
            }
            throw refused("unknown command '" + text::printable(word) + "'" +
                          did_you_mean(word, names));
        }
        command_ = &*found;
        first_at_ = at_;
        given_before_ = given_.size();
    }

    /// Returns true for the second word of a command. What stood before it is read again, as
    /// options of that command.
    bool read_second_word(std::string_view word) {
        const std::vector<const Command*> below = commands_below(program_, *command_);
        const auto found = std::ranges::find_if(
            below, [&](const Command* command) { return second_word(*command) == word; });
        if (found != below.end()) {
            command_ = *found;
            words_.erase(words_.begin() + static_cast<std::ptrdiff_t>(at_));
            at_ = first_at_;
            given_.resize(given_before_);
            return true;
        }
        const std::string hint =
            did_you_mean(word, below, [](const Command* command) { return second_word(*command); });
        const bool is_argument = command_->run && (hint.empty() || names_a_file(word));
        if (below.empty() || is_argument) return false;
        throw refused("unknown command '" + command_->name + " " + text::printable(word) + "'" +
                      hint);
    }

    /// Throws if a command is missing, or its second word.
    void require_runnable() const {
        if (command_ == nullptr && !program_.commands.empty()) {
            throw refused("a command is required");
        }
        if (command_ == nullptr || command_->run) return;
        const auto name = [](const Command* command) { return second_word(*command); };
        throw refused("a command is required after '" + command_->name +
                      "': " + joined(commands_below(program_, *command_), ", ", name));
    }

    /// Gives the arguments to the positional options, in their order.
    void place_arguments() {
        std::size_t used = 0;
        for (const Option* option : options_of(current())) {
            if (is_positional(*option) && used < arguments_.size())
                give(*option, arguments_[used++]);
        }
        arguments_.erase(arguments_.begin(),
                         arguments_.begin() + static_cast<std::ptrdiff_t>(used));
    }

    /// Assigns values in the order of the options, whose first mistake is named.
    void assign_all(const Command& command, RunOptions& run_options) const {
        for (const Option* option : options_of(command)) {
            if (count(option) > 1 && takes(*option) != Takes::nothing && !takes_several(*option)) {
                throw refused(name_of(*option) + " is given " + std::to_string(count(option)) +
                              " times; allowed is once");
            }
            for (const GivenOption& given : given_) {
                if (given.option == option) assign_one(given, run_options);
            }
        }
        for (const Option* option : options_of(command)) {
            if (option->required && count(option) == 0) {
                throw refused(name_of(*option) + " is required");
            }
            if (option->excludes.empty() || count(option) == 0) continue;
            if (count(find_option(option->excludes)) == 0) continue;
            throw refused(option->excludes + " excludes " + name_of(*option));
        }
    }

    std::ptrdiff_t count(const Option* option) const {
        return std::ranges::count(given_, option, &GivenOption::option);
    }

    void assign_one(const GivenOption& given, RunOptions& run_options) const {
        try {
            assign(*given.option, given.value, run_options);
        } catch (const Error& error) {
            throw refused(error.what());
        }
    }

    /// Returns the page of help that the word at or after --help names, else the command's help.
    std::string help(std::string_view word) const {
        if (const std::size_t equals = word.find('='); equals != std::string_view::npos) {
            return page(word.substr(equals + 1));
        }
        const std::string_view next = at_ + 1 < words_.size() ? words_[at_ + 1] : "";
        return names_a_page(next) ? page(next) : command_help(program_, current());
    }

    /// Returns false for another option, and for a SEA that follows --help.
    bool names_a_page(std::string_view word) const {
        if (current().pages.empty() || word.empty() || word.starts_with('-')) return false;
        if (word.starts_with('.')) word.remove_prefix(1);
        return word.find_first_of("./\\:") == std::string_view::npos;
    }

    std::string page(std::string_view name) const {
        const std::string quoted = "'" + text::printable(name) + "'";
        if (current().pages.empty()) {
            throw refused("--help of " + usage_of(program_, current()) + " has no page " + quoted);
        }
        std::vector<std::string_view> names;
        for (const HelpPage& page : current().pages) {
            if (std::ranges::count(page.names, name) != 0) return page_help(page);
            names.insert(names.end(), page.names.begin(), page.names.end());
        }
        if (std::ranges::count(program_.commands, name, &Command::name) != 0) {
            refuse(quoted + " is a command: see `" + program_.main.name + " " + std::string(name) +
                   " --help`");
        }
        const auto first_name = [](const HelpPage& page) { return page.names.front(); };
        throw refused("unknown " + current().page_noun + " " + quoted + did_you_mean(name, names) +
                      "; known: " + joined(current().pages, ", ", first_name));
    }

    const Program& program_;
    std::vector<std::string_view> words_;
    std::size_t at_ = 0;
    const Command* command_ = nullptr;
    std::size_t first_at_ = 0;      // of the command's first word
    std::size_t given_before_ = 0;  // options before it
    bool only_arguments_ = false;   // after "--"
    std::vector<std::string> arguments_;
    std::vector<GivenOption> given_;
    std::optional<std::string> text_;
};

}  // namespace

ParsedCommand parse_command_line(const Program& program, std::span<char* const> words,
                                 RunOptions& run_options) {
    return CommandParser(program, words).parse(run_options);
}

void assign(const Option& option, const std::string& value, RunOptions& run_options) {
    if (const std::string fault = fault_of(option, value); !fault.empty()) {
        refuse(name_of(option) + ": " + fault);
    }
    const TargetSetter set{option, value};
    std::visit(
        [&](auto target) {
            if constexpr (std::is_pointer_v<decltype(target)>) {
                set(*target);
            } else {
                set(run_options.*target);
            }
        },
        option.target);
}

}  // namespace ocean::app
