// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A command as a value: its name, the table of its options and what it does. Whatever reads the
// command line is behind run_program() (command_line.hpp); nothing here knows of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ocean::app {

class Console;
class InterruptWatch;

/// Options that every command has.
struct RunOptions {
    int threads = 0;  // 0 = all
    bool quiet = false;
    bool verbose = false;
    bool json = false;
};

/// What a running command works with; lives as long as the program.
struct Context {
    const RunOptions& options;
    Console& console;
    InterruptWatch& interrupts;
};

/// Where the value of an option goes. Must live as long as the command; a bool is a flag, and a
/// list takes one value each time that the option is given. An optional text may be given without
/// its value, and is "" then.
using OptionTarget = std::variant<bool*, int*, std::string*, std::optional<int>*,
                                  std::optional<double>*, std::optional<std::string>*,
                                  std::vector<std::string>*, bool RunOptions::*, int RunOptions::*>;

/// What a value is checked for before the command runs.
struct NotEmpty {};
struct OneOf {
    std::vector<std::string> words;
};
struct Within {
    int lowest;
    int highest;
};
using ValueRule = std::variant<std::monostate, NotEmpty, OneOf, Within>;

inline constexpr bool kRequired = true;
inline constexpr bool kOptional = false;

struct Option {
    /// "-o,--output"; "SEA" takes a word without a name; "!--no-foam" is a flag that clears.
    std::string names;
    OptionTarget target;
    std::string type = {};  // of its value, for the help; a flag has none
    std::string help = {};
    bool required = kOptional;
    ValueRule rule = {};
    std::string excludes = {};  // an earlier option that cannot be given beside it
};

/// Options that stand together in the help; groups of the same name are one.
struct OptionGroup {
    std::string name;  // "" = Options
    std::vector<Option> options;
};

struct Command {
    std::string name = {};
    std::string summary = {};
    std::vector<OptionGroup> options = {};
    std::string footer = {};  // "" = that of the program
    /// Throws ocean::Error when it fails.
    std::function<void(const Context&)> run = {};
};

/// --threads, -q, -v; `json_help` = "" leaves --json out.
OptionGroup run_options(const std::string& json_help);

}  // namespace ocean::app
