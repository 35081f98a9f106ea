// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean spectrum`: prints the directional spectrum of a sea as CSV, from the table that modes, CPU
// and GPU share, or the rings of a terrain, and draws them as a plot.
#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "console.hpp"
#include "input_files.hpp"
#include "interrupt.hpp"
#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/terrain_rings.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrainfile.hpp"
#include "plot/plots.hpp"
#include "subject_argument.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr double kDegrees = 180.0 / kPi;

/// Returns "mean,spread" of one row [degrees], with empty cells if it has no energy. The spread is
/// sqrt(2 (1 - r)), where r is the length of the mean direction vector.
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

/// Returns a line for each row of the table; the trapezoidal rule over them is the exact variance.
std::string frequency_csv(const DirectionalSpectrum& spectrum) {
    std::string csv = "frequency_hz,density_m2_per_hz,mean_direction_deg,directional_spread_deg\n";
    const std::span<const double> omega = spectrum.angular_frequencies();
    for (std::size_t i = 0; i < omega.size(); ++i) {
        csv += format_text("%.12g,%.12g,", omega[i] / kTwoPi,
                           kTwoPi * spectrum.frequency_density(omega[i]));
        csv += direction_cells(spectrum.row(i)) + '\n';
    }
    return csv;
}

/// Returns a line for each row and direction.
std::string directional_csv(const DirectionalSpectrum& spectrum) {
    std::string csv = "frequency_hz,direction_deg,density_m2_per_hz_per_deg\n";
    const std::span<const double> omega = spectrum.angular_frequencies();
    for (std::size_t i = 0; i < omega.size(); ++i) {
        const std::vector<double> row = spectrum.row(i);
        for (std::size_t j = 0; j < row.size(); ++j) {
            const double degrees = 360.0 * static_cast<double>(j) / static_cast<double>(row.size());
            csv += format_text("%.12g,%.9g,%.9g\n", omega[i] / kTwoPi, degrees,
                               row[j] * kTwoPi / kDegrees);
        }
    }
    return csv;
}

/// Returns the rings as a table with a header line.
std::string terrain_rings_csv(std::span<const TerrainRing> rings) {
    std::string csv =
        "wavenumber,wavelength_m,count,density,asked_m4,seeds_mean_m4,seeds_scatter_log10\n";
    for (const TerrainRing& ring : rings) {
        csv += format_text("%.9g,%.6g,%.0f,%.6g,%.6g,%.6g,%.4f\n", ring.wavenumber,
                           kTwoPi / ring.wavenumber, ring.count, ring.tile, ring.asked, ring.mean,
                           ring.scatter);
    }
    return csv;
}

constexpr std::string_view kPlotCommand = "spectrum";

struct SpectrumOptions {
    SubjectArgument subject;
    bool directional = false;
    std::string output;
    std::string plot;
    std::string seeds;
};

constexpr int kDefaultSeeds = 16;

std::vector<io::HeaderString> plot_strings(std::string_view kind, const std::string& text) {
    const io::Provenance provenance{.kind = std::string(kind), .text = text};
    std::vector<io::HeaderString> strings = io::provenance_strings(provenance);
    strings.push_back(plot_mark(kPlotCommand));
    return strings;
}

/// Throws Error if an output is an input or replaces a file that is no plot.
void check_outputs(const SpectrumOptions& options, const std::vector<std::string>& named) {
    const InputFiles inputs(options.subject.source, named);
    for (const std::string& output : {options.output, options.plot}) inputs.spare(output);
    const std::filesystem::path picture = utf8_path(options.plot);
    if (picture.has_extension() && picture.extension() != ".png") {
        refuse("--plot " + options.plot + ": the plot is a PNG file; allowed is NAME.png");
    }
    if (!options.plot.empty()) {
        io::refuse_to_replace_foreign_file(options.plot, "`ocean spectrum --plot`",
                                           [&] { return is_plot(options.plot, kPlotCommand); });
    }
}

/// Writes plot and CSV; a plot alone prints no CSV.
template <typename Plot, typename Csv>
void write_results(const SpectrumOptions& options, const Context& context, const Plot& plot,
                   const Csv& csv) {
    const auto write = [&](const std::string& path, const std::string& bytes) {
        write_output(context.interrupts, path, bytes);
        if (!context.options.quiet) context.console.data(path + "\n");
    };
    if (!options.plot.empty()) write(options.plot, plot());
    if (options.output.empty() && !options.plot.empty()) return;
    if (options.output.empty()) return context.console.data(csv());
    write(options.output, csv());
}

void run_for(const TerrainModel& terrain, const SpectrumOptions& options, const Context& context) {
    if (options.directional) {
        throw Error(ErrorKind::unsupported,
                    "--directional: only a sea has it; a terrain is printed in rings");
    }
    check_outputs(options, named_files(terrain));
    const int seeds = options.seeds.empty()
                          ? kDefaultSeeds
                          : parse_whole_number(options.seeds, "--seeds", 1, kMaxSpectrumSeeds);
    if (terrain.base_model != nullptr) {
        throw Error(ErrorKind::unsupported,
                    options.subject.source +
                        ": the land of an elevation model has no law; `ocean "
                        "terrain fit " +
                        terrain.base + "` measures its spectrum");
    }
    if (terrain.is_shaped()) {
        context.console.warning(
            "the spectrum is that of the waves, before gullies, streams and shore shape them");
    }
    Terrain land(terrain, {.threads = context.options.threads});
    const auto report = progress_on(context.console, "tiles", static_cast<std::size_t>(seeds));
    const std::vector<TerrainRing> rings =
        terrain_rings(land, seeds, [&](int done, int) { report(static_cast<std::size_t>(done)); });
    write_results(
        options, context,
        [&] {
            return io::with_png_strings(plot_terrain(land, rings, seeds, options.subject.source),
                                        plot_strings(kTerrainKind, write_terrain(terrain)));
        },
        [&] { return terrain_rings_csv(rings); });
}

void run_for(const Sea& sea, const SpectrumOptions& options, const Context& context) {
    refuse_options_of_others(context, kSeaKind);
    check_outputs(options, named_files(sea));
    Ocean ocean(sea, {.threads = context.options.threads});
    const DirectionalSpectrum& spectrum = ocean.spectrum();
    write_results(
        options, context,
        [&] {
            const std::string png =
                plot_spectrum(ocean, options.subject.source, context.options.threads);
            return io::with_png_strings(png, plot_strings(kSeaKind, write_sea(sea)));
        },
        [&] { return options.directional ? directional_csv(spectrum) : frequency_csv(spectrum); });
}

constexpr char kSpectrumFooter[] =
    R"(Columns: frequency_hz, density_m2_per_hz, mean_direction_deg,
directional_spread_deg (empty without energy), at the rows of libocean's own
table: the trapezoidal rule over them gives the variance m0, and 4 sqrt(m0) is
the significant wave height.
With --directional: frequency_hz, direction_deg, density_m2_per_hz_per_deg.
Directions are in degrees counter-clockwise from +x (east), towards which the
waves travel.

For a terrain a line for each ring of wavenumbers: wavenumber [rad/m], its waves
(count), the density of this tile, that of the law (asked), and the mean of
--seeds tiles with the scatter of one, in log10. All densities are over (kx, ky)
[m^4]; a terrain file's `measured` reads the table.)";

}  // namespace

Command spectrum_command() {
    auto options = std::make_shared<SpectrumOptions>();
    return {
        .name = "spectrum",
        .summary = "Print the spectrum as CSV, or draw it with --plot",
        .options =
            {subject_options(options->subject, kSeaKind),
             {"Output",
              {{"--directional", &options->directional, "",
                "Print the two-dimensional spectrum, with a line for each frequency and direction"},
               only_of(kTerrainKind,
                       {"--seeds", &options->seeds, "N",
                        "Tiles of a terrain that are made for mean and scatter; default 16"}),
               {"-o,--output", &options->output, "FILE", "Write the CSV here"},
               {"--plot", &options->plot, "FILE.png",
                "Draw both spectra as a PNG file; CSV is then written with -o only"}}},
             run_options("")},
        .footer = kSpectrumFooter,
        .run =
            [options](const Context& context) {
                const OpenedSubject subject = open_subject(options->subject);
                std::visit([&](const auto& model) { run_for(model, *options, context); }, subject);
            },
    };
}

}  // namespace ocean::app
