// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A command as a value: its name, the table of its options and its function. command_parser.hpp
// reads a command line by it, help_text.hpp describes it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ocean::app {

/// Throws Error invalid_value, that of a wrong command line.
[[noreturn]] void refuse(const std::string& sentence);

class Console;
class InterruptWatch;

/// Options that every command has.
struct RunOptions {
    int threads = 0;  // 0 = all cores
    bool quiet = false;
    bool verbose = false;
    bool json = false;
    std::string progress;  // the line of each per cent, with # for its number; "" = none
};

struct Option;

/// An option of a command line with its value, "" for a flag.
struct GivenOption {
    const Option* option;
    std::string value;
};

/// The services of a running command; they live as long as the program.
struct Context {
    const RunOptions& options;
    const std::vector<GivenOption>& given;
    Console& console;
    InterruptWatch& interrupts;
};

/// The destination of an option's value, which must live as long as the command. A bool is a flag;
/// a list gets one value for each time that the option is given. An optional text may be given
/// without a value, and is then "".
using OptionTarget =
    std::variant<bool*, int*, std::string*, std::optional<int>*, std::optional<double>*,
                 std::optional<std::string>*, std::vector<std::string>*, bool RunOptions::*,
                 int RunOptions::*, std::string RunOptions::*>;

/// The checks of a value before the command runs.
struct NotEmpty {};
struct OneOf {
    std::vector<std::string> words;

    /// Returns "'foan' is none of foam, normal; did you mean foam?", or "" for one of the words.
    std::string fault_of(const std::string& value) const;
};
struct Within {
    int lowest;
    int highest;
};
using ValueRule = std::variant<std::monostate, NotEmpty, OneOf, Within>;

inline constexpr bool kRequired = true;
inline constexpr bool kOptional = false;

struct Option {
    /// "-o,--output"; "SEA" is a positional argument; "!--no-foam" is a flag that clears.
    std::string names;
    OptionTarget target;
    std::string type = {};  // placeholder of its value in the help; empty for a flag
    std::string help = {};
    bool required = kOptional;
    ValueRule rule = {};
    std::string excludes = {};      // an earlier option that cannot be combined with it
    std::string_view subject = {};  // the kind of subject that alone has it, "sea"; "" = all
};
/// Returns the option as one that subjects of a kind alone have.
inline Option only_of(std::string_view kind, Option option) {
    option.subject = kind;
    return option;
}

/// A group of options in the help; groups with the same name are merged.
struct OptionGroup {
    std::string name;  // "" = "Options"
    std::vector<Option> options;
};

/// A part of a help text: a title, and rows of a name and its text.
struct HelpRow {
    std::string name;
    std::string text;
};
struct HelpSection {
    std::string title;
    std::vector<HelpRow> rows;
};

/// A page of `COMMAND --help NAME`: the help of one of many things that a command knows.
struct HelpPage {
    std::vector<std::string> names;  // the first one is listed; the others find the page too
    std::string summary;             // one line of the list
    std::string title;
    std::string usage;  // "ocean bake SEA -o out/sea.####.exr [OPTIONS]"
    std::vector<HelpSection> sections;
};

struct Command {
    /// "bake", or two words: "terrain import" is a command beside "terrain", whose help lists it.
    std::string name = {};
    std::string summary = {};
    std::vector<OptionGroup> options = {};
    std::string footer = {};       // "" = the program's footer
    std::string page_noun = {};    // what a page is about: "format"
    std::string pages_title = {};  // of their list in the command's help
    std::vector<HelpPage> pages = {};
    /// Throws ocean::Error when it fails. Empty for a command that only begins the names of others.
    std::function<void(const Context&)> run = {};
};

struct Program {
    /// The program itself: its name, and the options before the command's name. It runs if the
    /// program has no commands.
    Command main;
    std::string version;  // what --version prints
    std::vector<Command> commands = {};
};

/// Returns the groups with the options that subjects of a kind have.
std::vector<OptionGroup> options_for(std::string_view kind, std::vector<OptionGroup> groups);

/// Returns --threads, -q and -v, and --json unless `json_help` is "".
OptionGroup run_options(const std::string& json_help);
/// Returns --progress, for commands that report shares of their run to the Console.
OptionGroup progress_option();

/// Returns true for an argument without a name, such as SEA.
bool is_positional(const Option& option);
/// Returns the names of an option, "-o" and "--output".
std::vector<std::string> names_of(const Option& option);
/// Returns the name that messages show, the long one if there is one.
std::string name_of(const Option& option);
/// The value that follows an option.
enum class Takes { nothing, optional_value, value };
Takes takes(const Option& option);
/// Returns true for an option that may be given more than once.
bool takes_several(const Option& option);
/// Returns the options of all groups, in their order.
std::vector<const Option*> options_of(const Command& command);

/// Returns the second word of a command's name, "import"; "" if it has one word.
std::string_view second_word(const Command& command);
/// Returns the commands whose names begin with the name of `first` and have a second word.
std::vector<const Command*> commands_below(const Program& program, const Command& first);

}  // namespace ocean::app
