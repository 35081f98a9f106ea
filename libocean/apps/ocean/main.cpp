// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `ocean` command: parses, runs one command, and turns every failure into one line on standard
// error and an exit code: 0 done, 1 failed at run time, 2 wrong usage or bad sea file,
// 130 interrupted.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>

#include "command.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/error.hpp"
#include "ocean/version.hpp"

namespace {

using ocean::Error;
using ocean::ErrorKind;

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;
constexpr int kInterrupted = 130;

int exit_code(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::output:
        case ErrorKind::out_of_memory:
            return kFailed;
        case ErrorKind::interrupted:
            return kInterrupted;
        case ErrorKind::invalid_value:
        case ErrorKind::bad_file:
        case ErrorKind::not_found:
        case ErrorKind::unsupported:
            break;
    }
    return kWrongUsage;
}

void describe(CLI::App& app) {
    app.set_version_flag("--version", "ocean " OCEAN_VERSION "\n" OCEAN_LIBRARY_VERSIONS,
                         "Print the versions of this program and of its libraries");
    app.require_subcommand(1);
    app.footer(
        "A sea is a sea file, a baked EXR file or preset:NAME (see `ocean presets`).\n"
        "`ocean COMMAND --help` lists the options of a command.\n"
        "Exit codes: 0 done, 1 failed at run time (disk, memory), 2 wrong usage or bad sea\n"
        "file, 130 interrupted.");
    app.get_formatter()->column_width(34);
}

/// Help and version go to standard output as they are; a wrong use becomes one line.
int report_usage(const CLI::App& app, const CLI::ParseError& error, ocean::app::Console& console) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::string message = error.what();
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::string command = "ocean";
    for (const CLI::App* sub : app.get_subcommands()) command += " " + sub->get_name();
    console.error(message + " (see `" + command + " --help`)");
    return kWrongUsage;
}

int run(int argc, char** argv) {
    ocean::app::RunOptions options;
    ocean::app::Console console(options);
    ocean::app::InterruptWatch interrupts([&console] { console.interrupted(); });
    ocean::app::Context context{options, console, interrupts};

    CLI::App app("One statistical ocean, in real units, for Blender, POV-Ray, OpenGL and OpenEXR.",
                 "ocean");
    describe(app);
    add_run_options(app, options, "JSON lines on standard error; `info` prints JSON");
    add_info_command(app, context);
    add_bake_command(app, context);
    add_povray_command(app, context);
    add_query_command(app, context);
    add_gauge_command(app, context);
    add_spectrum_command(app, context);
    add_records_command(app, context);
    add_params_command(app, context);
    add_presets_command(app, context);
    try {
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::ParseError& error) {
        return report_usage(app, error, console);
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

int main(int argc, char** argv) {
    try {
        const int code = run(argc, argv);
        // Help texts are written by the parser: a full disk behind them shows only here.
        const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
        if (code != 0 || written) return code;
        std::fputs("ocean: standard output cannot be written\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ocean: %s\n", error.what());
    }
    return kFailed;
}
