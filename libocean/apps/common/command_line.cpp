// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See command_line.hpp.
#include "command_line.hpp"

#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>

#include "command_parser.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/json.hpp"
#include "standard_streams.hpp"

namespace ocean::app {
namespace {

JsonObject described(const Option& option) {
    constexpr std::string_view kTakes[] = {"nothing", "optional value", "value"};
    const auto* const one_of = std::get_if<OneOf>(&option.rule);
    return JsonObject()
        .add("names", json_array(names_of(option)))
        .add("type", option.type)
        .add("help", option.help)
        .add("required", option.required)
        .add("takes", kTakes[static_cast<std::size_t>(takes(option))])
        .add("repeats", takes_several(option))
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

/// Returns what `PROGRAM --describe` prints: an object with `version` and `commands`, the program
/// itself first. A command has name, summary, footer, runs, groups of options and pages of help. An
/// option has names, type, help, required, takes ("nothing", "value" or "optional value"),
/// repeats, words (those that its value may have, empty for any) and excludes.
std::string description(const Program& program) {
    JsonArray commands;
    commands.add(described(program.main));
    for (const Command& command : program.commands) commands.add(described(command));
    return JsonObject().add("version", program.version).add("commands", commands).text() + "\n";
}

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

int parse_and_run(int argc, char** argv, const Program& program) {
    RunOptions options;
    Console console(program.main.name, options);
    InterruptWatch interrupts([&console] { console.interrupted(); });
    try {
        const std::span words(argv, static_cast<std::size_t>(argc));
        if (words.size() == 2 && words[1] == std::string_view("--describe")) {
            console.data(description(program));
            return 0;
        }
        const ParsedCommand parsed = parse_command_line(program, words.subspan(1), options);
        if (parsed.text) {
            console.data(*parsed.text);
        } else {
            parsed.command.run({options, parsed.given, console, interrupts});
        }
        return 0;
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

int run_program(int argc, char** argv, const Program& program) {
    const char* name = program.main.name.c_str();
    prepare_standard_streams();
    try {
        const int code = parse_and_run(argc, argv, program);
        // Buffered output: a full disk is detected only here.
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
