// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean spectrum`: the directional spectrum of a sea as CSV, from the one table that modes, CPU
// and GPU read, and as a picture.
#include <cmath>
#include <complex>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/ocean.hpp"
#include "plot/spectrum_plot.hpp"
#include "sea_argument.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

struct SpectrumOptions {
    SeaArgument sea;
    bool directional = false;
    std::string output;
    std::string plot;
};

constexpr double kDegrees = 180.0 / kPi;

std::span<const double> row_of(const DirectionalSpectrum& spectrum, std::size_t row) {
    const auto columns = static_cast<std::size_t>(spectrum.directions());
    return spectrum.table().subspan(row * columns, columns);
}

/// "mean,spread" in degrees of one row, empty cells where there is no energy. The spread is
/// sqrt(2 (1 - r)), r the length of the mean direction vector.
std::string direction_cells(std::span<const double> row) {
    std::complex<double> vector = 0.0;
    double sum = 0.0;
    for (std::size_t j = 0; j < row.size(); ++j) {
        const double theta = kTwoPi * static_cast<double>(j) / static_cast<double>(row.size());
        vector += std::polar(row[j], theta);
        sum += row[j];
    }
    if (!(sum > 0.0)) return ",";
    const double degrees = std::arg(vector) * kDegrees;
    const double spread = std::sqrt(std::max(0.0, 2.0 * (1.0 - std::abs(vector) / sum)));
    return format_text("%.6g,%.6g", degrees < 0.0 ? degrees + 360.0 : degrees, spread * kDegrees);
}

/// One line for each row of the table, so that the trapezoid over them is the exact variance.
std::string frequency_csv(const DirectionalSpectrum& spectrum) {
    std::string csv = "frequency_hz,density_m2_per_hz,mean_direction_deg,directional_spread_deg\n";
    const std::span<const double> omega = spectrum.angular_frequencies();
    for (std::size_t i = 0; i < omega.size(); ++i) {
        csv += format_text("%.12g,%.12g,", omega[i] / kTwoPi,
                           kTwoPi * spectrum.frequency_density(omega[i]));
        csv += direction_cells(row_of(spectrum, i)) + '\n';
    }
    return csv;
}

std::string directional_csv(const DirectionalSpectrum& spectrum) {
    std::string csv = "frequency_hz,direction_deg,density_m2_per_hz_per_deg\n";
    const std::span<const double> omega = spectrum.angular_frequencies();
    for (std::size_t i = 0; i < omega.size(); ++i) {
        const std::span<const double> row = row_of(spectrum, i);
        for (std::size_t j = 0; j < row.size(); ++j) {
            const double degrees = 360.0 * static_cast<double>(j) / static_cast<double>(row.size());
            csv += format_text("%.12g,%.9g,%.9g\n", omega[i] / kTwoPi, degrees,
                               row[j] * kTwoPi / kDegrees);
        }
    }
    return csv;
}

void run(const SpectrumOptions& options, const Context& context) {
    const Sea sea = open_sea(options.sea);
    Ocean ocean(sea, {.threads = context.options.threads});
    const DirectionalSpectrum& spectrum = ocean.spectrum();
    const auto write = [&](const std::string& path, const std::string& bytes) {
        write_output(context.interrupts, path, bytes);
        if (!context.options.quiet) context.console.data(path + "\n");
    };
    if (!options.plot.empty()) {
        write(options.plot, plot_spectrum(ocean, options.sea.source, context.options.threads));
    }
    const bool wanted = !options.output.empty() || options.plot.empty();
    if (!wanted) return;
    const std::string csv =
        options.directional ? directional_csv(spectrum) : frequency_csv(spectrum);
    if (options.output.empty()) return context.console.data(csv);
    write(options.output, csv);
}

constexpr char kFooter[] =
    R"(Columns: frequency_hz, density_m2_per_hz, mean_direction_deg, directional_spread_deg
(empty without energy), at the rows of libocean's own table: the trapezoid over them is
the variance m0, and 4 sqrt(m0) the significant wave height.
With --directional: frequency_hz, direction_deg, density_m2_per_hz_per_deg.
Directions in degrees counter-clockwise from +x (east), the way the waves travel.)";

}  // namespace

Command spectrum_command() {
    auto options = std::make_shared<SpectrumOptions>();
    return {
        .name = "spectrum",
        .summary = "Print the spectrum as CSV, or draw it with --plot",
        .options = {sea_options(options->sea),
                    {"Output",
                     {{"--directional", &options->directional, "",
                       "The two-dimensional spectrum: a line for each frequency and direction"},
                      {"-o,--output", &options->output, "FILE", "Write the CSV here"},
                      {"--plot", &options->plot, "FILE.png",
                       "Draw both spectra as a PNG picture; CSV then only with -o"}}},
                    run_options("")},
        .footer = kFooter,
        .run = [options](const Context& context) { run(*options, context); },
    };
}

}  // namespace ocean::app
