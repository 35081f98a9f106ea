// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See command_line.hpp. Only this file includes CLI11, which takes longer to compile than all
// commands together.
#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string_view>
#include <utility>

#include "command_words.hpp"
#include "console.hpp"
#include "description.hpp"
#include "interrupt.hpp"
#include "ocean/error.hpp"
#include "standard_streams.hpp"

namespace ocean::app {
namespace {

constexpr int kFailed = 1;
constexpr int kClosedPipe = 128 + 13;  // the exit code of a process that SIGPIPE ended
constexpr int kWrongUsage = 2;

int exit_code(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::output:
        case ErrorKind::out_of_memory:
        case ErrorKind::no_gpu:
            return kFailed;
        case ErrorKind::interrupted:
            return kInterruptedExit;
        case ErrorKind::invalid_value:
        case ErrorKind::bad_file:
        case ErrorKind::not_found:
        case ErrorKind::unsupported:
            break;
    }
    return kWrongUsage;
}

/// Adds an option to the parser, with an overload for each kind of target.
struct OptionAdder {
    CLI::App& parser;
    const Option& option;
    RunOptions& run_options;

    CLI::Option* operator()(bool* flag) const {
        if (!option.names.starts_with('!'))
            return parser.add_flag(option.names, *flag, option.help);
        return parser.add_flag_callback(
            option.names.substr(1), [flag] { *flag = false; }, option.help);
    }
    CLI::Option* operator()(std::vector<std::string>* list) const {
        return value(*list)->allow_extra_args(false);
    }
    CLI::Option* operator()(std::optional<std::string>* target) const {
        const auto set_target = [target](const CLI::results_t& words) {
            const bool none =
                words.empty() || words.front() == "{}";  // the parser's word for no value
            *target = none ? std::string() : words.front();
            return true;
        };
        return parser.add_option(option.names, set_target, option.help)
            ->type_name(option.type)
            ->expected(0, 1);
    }
    template <typename Value>
    CLI::Option* operator()(Value* target) const {
        return value(*target);
    }
    template <typename Value>
    CLI::Option* operator()(Value RunOptions::*member) const {
        return (*this)(&(run_options.*member));
    }

  private:
    template <typename Value>
    CLI::Option* value(Value& target) const {
        return parser.add_option(option.names, target, option.help)->type_name(option.type);
    }
};

struct RuleAdder {
    CLI::Option& option;

    void operator()(std::monostate) const {}
    void operator()(NotEmpty) const {
        option.check([](const std::string& text) {
            return text.empty() ? "an empty value is not allowed" : std::string();
        });
    }
    void operator()(const OneOf& rule) const {
        option.check([rule](const std::string& text) { return rule.fault_of(text); });
    }
    void operator()(const Within& rule) const {
        option.check(CLI::Range(rule.lowest, rule.highest).description(""));
    }
};

void add_options(CLI::App& parser, const std::vector<OptionGroup>& groups,
                 RunOptions& run_options) {
    for (const OptionGroup& group : groups) {
        for (const Option& option : group.options) {
            CLI::Option* added =
                std::visit(OptionAdder{parser, option, run_options}, option.target);
            added->required(option.required);
            std::visit(RuleAdder{*added}, option.rule);
            if (!option.excludes.empty()) added->excludes(parser.get_option(option.excludes));
            if (!group.name.empty()) added->group(group.name);
        }
    }
}

/// The parser of a program, with the requested command.
class CommandLine {
  public:
    CommandLine(const Program& program, RunOptions& run_options)
        : program_(program), parser_(program.main.summary, program.main.name) {
        parser_.set_version_flag("--version", program.version,
                                 "Print the versions of this program and of its libraries");
        add_options(parser_, program.main.options, run_options);
        if (!program.commands.empty()) parser_.require_subcommand(1);
        for (const Command& command : program.commands) {
            CLI::App* parser = parser_.add_subcommand(parser_name(command), command.summary);
            add_options(*parser, command.options, run_options);
        }
    }

    /// Parses the words after the program's name.
    void parse(std::vector<std::string> words) {
        std::ranges::reverse(words);  // the order that the parser requires
        parser_.parse(std::move(words));
    }

    /// Runs the requested command, and throws its error.
    void run(const Context& context) const {
        const Command* requested = requested_command();
        (requested != nullptr ? *requested : program_.main).run(context);
    }

    /// Prints help and version on standard output, and wrong usage as one line of an error.
    int report(const CLI::ParseError& error, Console& console) const {
        const Command* requested = requested_command();
        if (error.get_name() == "CallForHelp") {
            console.data(help_of(program_, requested != nullptr ? requested->name : ""));
            return 0;
        }
        if (error.get_exit_code() == 0) return parser_.exit(error);
        std::string message = error.what();
        std::replace(message.begin(), message.end(), '\n', ' ');
        std::string command = program_.main.name;
        if (requested != nullptr) command += " " + requested->name;
        console.error(message + " (see `" + command + " --help`)");
        return kWrongUsage;
    }

  private:
    /// Returns nullptr for the program itself.
    const Command* requested_command() const {
        for (const Command& command : program_.commands) {
            if (parser_.got_subcommand(parser_name(command))) return &command;
        }
        return nullptr;
    }

    const Program& program_;
    CLI::App parser_;
};

int parse_and_run(int argc, char** argv, const Program& program) {
    RunOptions options;
    Console console(program.main.name, options);
    InterruptWatch interrupts([&console] { console.interrupted(); });
    CommandLine command_line(program, options);
    try {
        const std::span words(argv, static_cast<std::size_t>(argc));
        if (words.size() == 2 && words[1] == std::string_view("--describe")) {
            console.data(description(program));
            return 0;
        }
        CommandWords read = read_command_words(program, words.subspan(1));
        if (read.help) {
            console.data(*read.help);
            return 0;
        }
        command_line.parse(std::move(read.words));
        command_line.run({options, console, interrupts});
        return 0;
    } catch (const CLI::ParseError& error) {
        return command_line.report(error, console);
    } catch (const ClosedPipe&) {
        return kClosedPipe;
    } catch (const Error& error) {
        console.error(error.what());
        return exit_code(error.kind());
    } catch (const std::bad_alloc&) {
        console.error("there is not enough memory");
    } catch (const std::exception& error) {
        console.error(error.what());
    }
    return kFailed;
}

}  // namespace

OptionGroup run_options(const std::string& json_help) {
    OptionGroup group{"Running",
                      {{"--threads", &RunOptions::threads, "N", "Threads to use; 0 = all cores",
                        kOptional, Within{0, 1024}},
                       {"-q,--quiet", &RunOptions::quiet, "", "Print errors only"},
                       {"-v,--verbose", &RunOptions::verbose, "", "Print more details"}}};
    if (!json_help.empty()) group.options.push_back({"--json", &RunOptions::json, "", json_help});
    return group;
}

int run_program(int argc, char** argv, const Program& program) {
    const char* name = program.main.name.c_str();
    prepare_standard_streams();
    try {
        const int code = parse_and_run(argc, argv, program);
        // The parser writes help texts: a full disk is detected only here.
        const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
        if (code != 0 || written) return code;
        if (errno == EPIPE) return kClosedPipe;
        std::fprintf(stderr, "%s: standard output cannot be written\n", name);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", name, error.what());
    }
    return kFailed;
}

}  // namespace ocean::app
