// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean gauge`: reads virtual wave gauges, fixed or moving, over time by summing all modes, and
// estimates wave statistics from their records.
#include <cmath>
#include <memory>

#include "bed_points.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "gauge/gauge_files.hpp"
#include "gauge/gauge_points.hpp"
#include "input_files.hpp"
#include "interrupt.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"
#include "subject_argument.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

struct GaugeOptions {
    SubjectArgument sea;
    std::string points;
    std::string from;
    std::string to;
    std::string rate;
    std::string degrees_of_freedom = "40";
    std::string output;
    std::string spectrum;
};

/// The validated options.
struct GaugePlan {
    SampleTimes times;
    double degrees_of_freedom;
    std::vector<Gauge> gauges;
    std::string left_out;  // of PointTable
};

SampleTimes sample_times(const GaugeOptions& options) {
    constexpr double kMaxSamples = 1e9;
    SampleTimes times{};
    times.from = parse_number(options.from, "--from", -1e9, 1e9);
    times.to = parse_number(options.to, "--to", -1e9, 1e9);
    times.rate = parse_number(options.rate, "--rate", 1e-6, 1e6);
    if (times.to < times.from) {
        refuse("--to = " + options.to + ": allowed is --from or later, " + options.from);
    }
    if ((times.to - times.from) * times.rate > kMaxSamples) {
        refuse(format_text("--rate = %s: %.3g samples from %s to %s s; allowed are 1e+09",
                           options.rate.c_str(), (times.to - times.from) * times.rate,
                           options.from.c_str(), options.to.c_str()));
    }
    return times;
}

GaugePlan plan_of(const GaugeOptions& options, const Sea& sea) {
    GaugePlan plan;
    plan.times = sample_times(options);
    plan.degrees_of_freedom =
        parse_number(options.degrees_of_freedom, "--degrees-of-freedom", 2.0, 1e6);
    const std::size_t samples = plan.times.count();
    const bool too_short = gauge_segment(samples, plan.degrees_of_freedom) == 0;
    if (!options.spectrum.empty() && too_short) {
        refuse("--spectrum: " + std::to_string(samples) + " samples are too few for " +
               options.degrees_of_freedom +
               " degrees of freedom; allowed are more samples or a smaller "
               "--degrees-of-freedom");
    }
    GaugePoints points = read_gauges(options.points, plan.times.from, plan.times.at(samples - 1),
                                     sea.parameters.water.depth);
    plan.gauges = std::move(points.gauges);
    plan.left_out = std::move(points.left_out);
    return plan;
}

/// Warns of a patch that is too small for the confidence limits, which are those of an infinite
/// sea: a long record in a small patch resolves single modes, whose sum depends on the place.
void warn_of_single_modes(Ocean& ocean, const SampleTimes& times, Console& console) {
    constexpr double kEnoughModes = 50.0;
    const double duration = times.to - times.from;
    const double modes = modes_at_peak(ocean, duration);
    if (modes >= kEnoughModes) return;
    const double patch = ocean.parameters().grid.patch_size;
    console.warning(
        format_text("grid.patch_size = %g m holds few waves of each period: a record of %g s "
                    "depends on its place "
                    "more than the confidence limits state, unless the patch is %.0f m or more",
                    patch, duration, patch * std::sqrt(kEnoughModes / modes)));
}

void require_room(const GaugePlan& plan, Ocean& ocean, int threads) {
    constexpr std::uint64_t kTextBytes = 400;  // of one reading, in a growing string
    const std::size_t samples = plan.times.count();
    const std::uint64_t text = std::uint64_t{samples} * plan.gauges.size() * kTextBytes;
    require_memory(
        gauge_series_bytes(ocean.modes(), ocean.parameters(), plan.gauges, samples, threads) + text,
        format_text("a record of %zu times at %zu gauges", samples, plan.gauges.size()),
        "choose fewer times or gauges");
}

void run(const GaugeOptions& options, const Context& context) {
    const Sea sea = open_sea(options.sea);
    InputFiles inputs(options.sea.source, named_files(sea));
    inputs.add(options.points);
    for (const std::string& output : {options.output, options.spectrum}) inputs.spare(output);
    const GaugePlan plan = plan_of(options, sea);
    if (!plan.left_out.empty()) context.console.warning("--points: " + plan.left_out);
    std::vector<WaterPoint> places;
    for (const Gauge& gauge : plan.gauges) {
        const GaugePlace at = gauge.track.front().place;
        places.push_back({at.x, at.y, at.z});
    }
    for (const std::string& text : bed_point_warnings(sea, places, true)) {
        context.console.warning(text);
    }
    Ocean ocean(sea, {.threads = context.options.threads});
    ThreadPool pool(context.options.threads);
    require_room(plan, ocean, pool.size());
    warn_of_single_modes(ocean, plan.times, context.console);
    const GaugeSeries series =
        read_gauge_series(ocean, plan.gauges, plan.times, pool,
                          progress_on(context.console, "times", plan.times.count()));

    const std::vector<GaugeSummary> summaries =
        summarize(series, plan.gauges, plan.times, plan.degrees_of_freedom);
    const auto write = [&](const std::string& path, const std::string& bytes) {
        write_output(context.interrupts, path, bytes);
    };
    if (!options.output.empty()) {
        const bool npy = options.output.ends_with(".npy");
        write(options.output, npy ? series_npy(series) : series_csv(series, plan.gauges));
    }
    if (!options.spectrum.empty()) write(options.spectrum, spectrum_csv(summaries));
    context.console.data(context.options.json ? summary_json(summaries, plan.times)
                                              : summary_table(summaries));
    if (gauge_segment(plan.times.count(), plan.degrees_of_freedom) == 0) {
        context.console.warning("the record is too short for confidence limits with " +
                                options.degrees_of_freedom + " degrees of freedom");
    }
}

constexpr char kGaugeFooter[] =
    R"(FILE has a header line and the columns x, y (m); name; z (m, 0 = still water,
the default, and negative below); velocity_x, velocity_y (m/s) of a gauge that
moves from x, y on; or time (s): the rows of one name are then its track, with
straight lines in between. For separators, decimal commas, units and further
columns see `ocean query --help`.
Readings: time, gauge, x, y; elevation (m) and slope_x, slope_y of the displaced
surface at x, y; velocity_x, velocity_y, velocity_z (m/s) of the water and its
pressure (Pa, without the hydrostatic part) at z by linear theory; above still
water the values of z = 0.
.npy: float64 of the shape (times, gauges, 10), the columns as in the CSV
without gauge.
Printed: zero up-crossing waves, H1/3, Hmax, their mean period Tz; Hs = 4
sqrt(m0) and Tm02 = sqrt(m0/m2); the periods and Hs with 95 % confidence limits.
--json has more.)";

}  // namespace

Command gauge_command() {
    auto options = std::make_shared<GaugeOptions>();
    return {
        .name = "gauge",
        .summary = "Read virtual wave gauges over time, and estimate wave statistics",
        .options = {subject_options(options->sea, kSeaKind),
                    {"Record",
                     {{"--points", &options->points, "FILE",
                       "Table of the gauges, see below; - = standard input", kRequired},
                      {"--from", &options->from, "SECONDS", "First time [s]", kRequired},
                      {"--to", &options->to, "SECONDS", "Last time [s]", kRequired},
                      {"--rate", &options->rate, "HZ", "Samples per second", kRequired}}},
                    {"Output",
                     {{"-o,--output", &options->output, "FILE",
                       "Write the readings here: .npy for NumPy, else CSV"},
                      {"--spectrum", &options->spectrum, "FILE",
                       "Write the estimated spectra here, as CSV"},
                      {"--degrees-of-freedom", &options->degrees_of_freedom, "N",
                       "Minimum for each density of the spectrum: more give narrower confidence "
                       "limits and a "
                       "coarser spectrum; default 40"}}},
                    run_options("Print one JSON object; progress as JSON lines")},
        .footer = kGaugeFooter,
        .run = [options](const Context& context) { run(*options, context); },
    };
}

}  // namespace ocean::app
