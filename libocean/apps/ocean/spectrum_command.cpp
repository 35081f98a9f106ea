// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean spectrum`: prints the directional spectrum of a sea as CSV, from the table that modes, CPU
// and GPU share, and draws it as a plot.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "console.hpp"
#include "input_files.hpp"
#include "interrupt.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/io/png.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"
#include "plot/spectrum_plot.hpp"
#include "sea_argument.hpp"
#include "spectrum_csv.hpp"

namespace ocean::app {
namespace {

constexpr std::string_view kPlotString = "ocean:plot";

struct SpectrumOptions {
    SeaArgument sea;
    bool directional = false;
    std::string output;
    std::string plot;
};

std::vector<io::HeaderString> plot_strings(const Sea& sea) {
    const io::Provenance provenance{.kind = std::string(kSeaKind), .text = write_sea(sea)};
    std::vector<io::HeaderString> strings = io::provenance_strings(provenance);
    strings.push_back({std::string(kPlotString), "spectrum"});
    return strings;
}

bool is_plot(const std::string& path) {
    try {
        const auto header = io::read_png_header(path);
        return std::ranges::any_of(header,
                                   [](const auto& string) { return string.name == kPlotString; });
    } catch (const Error&) {
        return false;
    }
}

void run(const SpectrumOptions& options, const Context& context) {
    const Sea sea = open_sea(options.sea);
    const InputFiles inputs(options.sea.source, named_files(sea));
    for (const std::string& output : {options.output, options.plot}) inputs.spare(output);
    const std::filesystem::path picture = utf8_path(options.plot);
    if (picture.has_extension() && picture.extension() != ".png") {
        throw Error(ErrorKind::invalid_value,
                    "--plot " + options.plot + ": the plot is a PNG file; allowed is NAME.png");
    }
    if (!options.plot.empty()) {
        io::refuse_to_replace_foreign_file(options.plot, "`ocean spectrum --plot`",
                                           [&] { return is_plot(options.plot); });
    }
    Ocean ocean(sea, {.threads = context.options.threads});
    const DirectionalSpectrum& spectrum = ocean.spectrum();
    const auto write = [&](const std::string& path, const std::string& bytes) {
        write_output(context.interrupts, path, bytes);
        if (!context.options.quiet) context.console.data(path + "\n");
    };
    if (!options.plot.empty()) {
        const std::string png = plot_spectrum(ocean, options.sea.source, context.options.threads);
        write(options.plot, io::with_png_strings(png, plot_strings(sea)));
    }
    const bool wanted = !options.output.empty() || options.plot.empty();
    if (!wanted) return;
    const std::string csv =
        options.directional ? directional_csv(spectrum) : frequency_csv(spectrum);
    if (options.output.empty()) return context.console.data(csv);
    write(options.output, csv);
}

constexpr char kFooter[] =
    R"(Columns: frequency_hz, density_m2_per_hz, mean_direction_deg,
directional_spread_deg (empty without energy), at the rows of libocean's own
table: the trapezoidal rule over them gives the variance m0, and 4 sqrt(m0) is
the significant wave height.
With --directional: frequency_hz, direction_deg, density_m2_per_hz_per_deg.
Directions are in degrees counter-clockwise from +x (east), towards which the
waves travel.)";

}  // namespace

Command spectrum_command() {
    auto options = std::make_shared<SpectrumOptions>();
    return {
        .name = "spectrum",
        .summary = "Print the spectrum as CSV, or draw it with --plot",
        .options =
            {sea_options(options->sea),
             {"Output",
              {{"--directional", &options->directional, "",
                "Print the two-dimensional spectrum, with a line for each frequency and direction"},
               {"-o,--output", &options->output, "FILE", "Write the CSV here"},
               {"--plot", &options->plot, "FILE.png",
                "Draw both spectra as a PNG file; CSV is then written with -o only"}}},
             run_options("")},
        .footer = kFooter,
        .run = [options](const Context& context) { run(*options, context); },
    };
}

}  // namespace ocean::app
