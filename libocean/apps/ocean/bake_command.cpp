// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean bake`: frames of a sea into files for other programs. A frame's time comes from the sea
// alone, so that frames may be baked in any order, on any machine.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <span>

#include "bake_plan.hpp"
#include "command.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/ocean.hpp"
#include "ocean/platform.hpp"
#include "ocean/seafile.hpp"
#include "text.hpp"
#include "write_output.hpp"

namespace ocean::app {
namespace {

/// Everything that stays the same from frame to frame.
struct Bake {
    const BakePlan& plan;
    const std::string& sea_text;
    Ocean& ocean;
    InterruptWatch& interrupts;
};

using Files = std::vector<std::string>;

Files write_exr_files(const Bake& bake, const io::Frame& frame) {
    const BakePlan& plan = bake.plan;
    if (plan.layered) {
        const std::string file = plan.pattern.file(frame.number);
        const auto whole = bake.interrupts.hold();
        io::write_exr_layered(frame, plan.products, file, plan.exr);
        return {file};
    }
    Files files;
    for (const FieldInfo* product : plan.products) {
        files.push_back(plan.product_in_name ? plan.pattern.file(frame.number, product->name)
                                             : plan.pattern.file(frame.number));
        const auto whole = bake.interrupts.hold();
        io::write_exr(frame, *product, files.back(), plan.exr);
    }
    return files;
}

Files write_height_field(const Bake& bake, const io::Frame& frame) {
    const std::string file = bake.plan.pattern.file(frame.number);
    const auto whole = bake.interrupts.hold();
    io::write_height_field(frame, file);
    return {file, file + ".txt"};
}

Files write_mesh(const Bake& bake, const io::Frame& frame, std::span<const Surface> levels) {
    const std::string file = bake.plan.pattern.file(frame.number);
    const io::Mesh mesh = bake.plan.view ? io::make_horizon_mesh(levels, *bake.plan.view)
                                         : io::make_patch_mesh(levels.front());
    const auto whole = bake.interrupts.hold();
    io::write_mesh2(mesh, frame, file, bake.plan.view ? &*bake.plan.view : nullptr);
    return {file};
}

Files bake_frame(const Bake& bake, int number) {
    const double time = bake.plan.sea.time_of(number);
    std::vector<Surface> levels;
    for (const int resolution : bake.plan.resolutions()) {
        levels.push_back(bake.ocean.evaluate(time, bake.plan.channels, resolution));
    }
    const io::Frame frame{levels.front(), bake.sea_text, number, time};
    switch (bake.plan.format) {
        case BakeFormat::exr:
            return write_exr_files(bake, frame);
        case BakeFormat::height_field:
            return write_height_field(bake, frame);
        case BakeFormat::mesh2:
            break;
    }
    return write_mesh(bake, frame, levels);
}

/// Light also meets the waves that are too short for the map.
void settle_slope_variance(BakePlan& plan, const Context& context) {
    if (!plan.view || plan.slope_variance_given) return;
    Parameters parameters = plan.sea.parameters;
    parameters.grid.resolution = std::min(plan.resolution, parameters.grid.resolution);
    const AskedResolved slope =
        Ocean(parameters, {.threads = context.options.threads}).state().mean_square_slope;
    plan.view->unresolved_slope_variance = std::max(0.0, slope.asked - slope.resolved);
}

void announce(const BakePlan& plan, Console& console) {
    const int frames = static_cast<int>(plan.frames.size());
    const Grid& grid = plan.sea.parameters.grid;
    const Lattice map{std::min(plan.resolution, grid.resolution), grid.patch_size};
    const double shortest = map.shortest_wavelength();
    console.begin(frames,
                  format_text("%d frame%s of %d x %d samples, period %g m, shortest wave %.3g m, ",
                              frames, frames == 1 ? "" : "s", plan.resolution, plan.resolution,
                              grid.patch_size, shortest) +
                      bytes_text(plan.memory_bytes()) + " of memory",
                  format_text("\"resolution\": %d, \"period\": %.9g, \"shortest_wave\": %.9g, "
                              "\"memory_bytes\": %llu",
                              plan.resolution, grid.patch_size, shortest,
                              static_cast<unsigned long long>(plan.memory_bytes())));
}

void run(const BakeOptions& options, const Context& context) {
    using Clock = std::chrono::steady_clock;
    BakePlan plan = make_bake_plan(options, context.options.threads);
    require_memory(plan.memory_bytes(),
                   format_text("a bake of %d x %d samples", plan.resolution, plan.resolution));
    make_folder(plan.pattern.folder());
    io::remove_abandoned_temporaries(plan.pattern.folder());
    announce(plan, context.console);
    settle_slope_variance(plan, context);
    Ocean ocean(plan.sea.parameters, {.threads = context.options.threads, .backend = plan.backend});
    const std::string sea_text = write_sea(plan.sea);
    const Bake bake{plan, sea_text, ocean, context.interrupts};
    const int threads = context.options.threads;
    context.console.note(format_text("%d threads", threads > 0 ? threads : available_cores()));
    for (const int number : plan.frames) {
        context.console.note(
            format_text("frame %d is at %.9g s", number, plan.sea.time_of(number)));
        const Clock::time_point started = Clock::now();
        const Files files = bake_frame(bake, number);
        const std::chrono::duration<double> seconds = Clock::now() - started;
        context.console.step(number, seconds.count(), files);
    }
    context.console.finish();
}

}  // namespace

void add_bake_command(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("bake", "Write frames of a sea: EXR, PNG, POV-Ray mesh");
    auto options = std::make_shared<BakeOptions>();
    add_bake_options(*command, *options);
    add_run_options(*command, context.options, "Progress, warnings and errors as JSON lines");
    command->footer(
        "With -o out/sea.####.exr a product goes into out/sea.<product>.0001.exr. A run of # is\n"
        "as many digits; %04d and $F4 are understood too. Finished paths are printed on standard\n"
        "output, progress on standard error. An interrupted bake leaves only whole files.");
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace ocean::app
