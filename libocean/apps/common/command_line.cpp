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
#include <string_view>

#include "command_parser.hpp"
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
