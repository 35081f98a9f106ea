// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The commands of `ocean`, one file each. A function here adds its command's options to the parser
// and leaves a callback that runs it; the callback throws ocean::Error when it fails.
#pragma once

namespace CLI {
class App;
}

namespace ocean::app {

class Console;
class InterruptWatch;
struct RunOptions;

/// What the callbacks refer to; lives as long as the program.
struct Context {
    RunOptions& options;
    Console& console;
    InterruptWatch& interrupts;
};

void add_info_command(CLI::App& app, Context& context);
void add_bake_command(CLI::App& app, Context& context);
void add_povray_command(CLI::App& app, Context& context);
void add_query_command(CLI::App& app, Context& context);
void add_gauge_command(CLI::App& app, Context& context);
void add_spectrum_command(CLI::App& app, Context& context);
void add_records_command(CLI::App& app, Context& context);
void add_params_command(CLI::App& app, Context& context);
void add_presets_command(CLI::App& app, Context& context);

}  // namespace ocean::app
