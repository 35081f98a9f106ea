// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean terrain fit`: writes a terrain file with the spectrum of an elevation model, and reports
// how well it fits.
#include <filesystem>
#include <memory>
#include <string>

#include "commands.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/elevation_import.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/terrain_fit.hpp"
#include "ocean/terrainfile.hpp"
#include "plot/plots.hpp"
#include "terrain_fit_text.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr char kOpening[] = "# Fitted by `ocean terrain fit`";
constexpr std::string_view kFitCommand = "terrain fit";

struct FitOptions {
    std::string bed;
    std::string output;
    std::string plot;
    std::string rings;
    std::string law = "table";
    bool ridge = false;
    int seeds = TerrainFitOptions().seeds;
};

bool begins_with(const std::string& path, std::string_view opening) {
    return text::first_bytes(path, opening.size()) == opening;
}

void require_extension(const std::string& option, const std::string& path,
                       const std::string& extension) {
    if (utf8_path(path).extension() == extension) return;
    refuse(option + " " + text::printable(path, 200) + ": allowed is NAME" + extension);
}

/// Throws if an output cannot be written, is another program's, or is the input.
void check_outputs(const FitOptions& options) {
    struct Output {
        const char* option;
        const std::string& path;
        const char* extension;
        bool (*is_ours)(const std::string& path);
    };
    const Output outputs[] = {
        {"-o", options.output, ".toml",
         [](const std::string& path) { return begins_with(path, kOpening); }},
        {"--rings", options.rings, ".csv",
         [](const std::string& path) { return begins_with(path, kRingsHeader); }},
        {"--plot", options.plot, ".png",
         [](const std::string& path) { return is_plot(path, kFitCommand); }},
    };
    for (const Output& output : outputs) {
        if (output.path.empty()) continue;
        require_extension(output.option, output.path, output.extension);
        io::require_folder(utf8_path(output.path).parent_path().string());
        io::refuse_to_replace_foreign_file(output.path, "`ocean terrain fit`",
                                           [&] { return output.is_ours(output.path); });
    }
}

ElevationModel read_bed(const FitOptions& options) {
    ElevationImport request;
    request.options.holes = HolePolicy::keep;
    ElevationModel bed = import_elevation(options.bed, request);
    const std::size_t holes = summarize(bed).holes;
    if (holes == 0) return bed;
    throw Error(ErrorKind::bad_file,
                text::printable(options.bed, 200) + ": " + std::to_string(holes) + " of " +
                    std::to_string(bed.heights.size()) +
                    " heights are missing; fill them by `ocean terrain import " +
                    text::printable(options.bed, 200) +
                    " --holes fill -o bed.flt`, or crop them "
                    "off");
}

/// Returns the path of a file as a terrain file beside it names it.
std::string named_from(const std::string& terrain, const std::string& file) {
    const std::filesystem::path folder =
        std::filesystem::absolute(utf8_path(terrain)).parent_path();
    const std::filesystem::path path = std::filesystem::absolute(utf8_path(file));
    return text::to_utf8(path.lexically_relative(folder));
}

/// Returns the sentence as lines of a comment.
std::string commented(const std::string& sentence) {
    constexpr std::size_t kWidth = 96;
    std::string lines;
    for (const std::string& line : split(wrapped(sentence, 0, kWidth), '\n')) {
        if (!line.empty()) lines += "# " + line + "\n";
    }
    return lines;
}

std::string terrain_text(const FitOptions& options, const TerrainFit& fit) {
    std::string opening = std::string(kOpening) + " to " + text::printable(options.bed, 200) +
                          ", law " + law_name(fit) +
                          ".\n# In log10 of the density the error is at "
                          "most " +
                          fixed_text(fit.error_above_lowest(), 3) +
                          " in each octave above the longest.\n";
    if (fit.terrain.rings != nullptr) {
        opening += commented(
            "The rings decide. beta is the exponent of their land, for who takes "
            "them away.");
    }
    for (const std::string& warning : fit.warnings) opening += commented(warning);
    return opening + write_terrain(fit.terrain);
}

void write_outputs(const FitOptions& options, const ElevationModel& bed, const TerrainFit& fit,
                   const Context& context) {
    const auto write = [&](const std::string& path, const std::string& bytes) {
        write_output(context.interrupts, path, bytes);
        if (!context.options.quiet && !context.options.json) {
            context.console.data("written  " + path + "\n");
        }
    };
    if (!options.rings.empty()) write(options.rings, rings_csv(fit));
    if (!options.plot.empty()) {
        const io::Provenance provenance{.kind = std::string(kTerrainKind),
                                        .text = write_terrain(fit.terrain)};
        std::vector<io::HeaderString> strings = io::provenance_strings(provenance);
        strings.push_back(plot_mark(kFitCommand));
        const std::string name = text::to_utf8(utf8_path(options.bed).filename());
        const std::string png = plot_fit(bed, fit, name, context.options.threads);
        write(options.plot, io::with_png_strings(png, strings));
    }
    if (!options.output.empty()) write(options.output, terrain_text(options, fit));
}

void run(const FitOptions& options, const Context& context) {
    if (options.ridge && options.law != "broken") {
        refuse("--ridge is for --law broken");
    }
    check_outputs(options);
    const ElevationModel bed = read_bed(options);
    for (const std::string& note : bed.notes) context.console.note(note);
    auto report = std::make_shared<std::function<void(std::size_t)>>();
    const TerrainFitOptions fit_options{.law = options.law == "broken" ? FitLaw::broken
                                               : options.law == "one"  ? FitLaw::one
                                                                       : FitLaw::table,
                                        .ridge = options.ridge,
                                        .seeds = options.seeds,
                                        .threads = context.options.threads,
                                        .progress = [&, report](int done, int of) {
                                            if (!*report) {
                                                *report = progress_on(context.console, "terrains",
                                                                      static_cast<std::size_t>(of));
                                            }
                                            (*report)(static_cast<std::size_t>(done));
                                        }};
    TerrainFit fit = fit_terrain(bed, fit_options);
    if (fit.terrain.rings != nullptr && !options.output.empty()) {
        fit.terrain.measured =
            named_from(options.output, options.rings.empty() ? options.bed : options.rings);
    }
    for (const std::string& warning : fit.warnings) context.console.warning(warning);
    context.console.data(context.options.json ? fit_json(bed, fit) : fit_text(bed, fit));
    write_outputs(options, bed, fit, context);
}

constexpr char kTerrainFitFooter[] =
    R"(BED is an elevation model: .asc, .flt with .hdr, GeoTIFF or .hgt. Its plane is
removed and a Hann window applied; its density over the wavenumber plane is then
averaged in rings, 4 an octave. The law is corrected for the window by what the
mean of all terrains has, and terrains of 16 seeds, cut out and measured alike,
judge it. The terrain has the variance of the model about its mean, and a seed
whose longest waves have it, too: another seed has other long waves. The law is
written with its rings, so the terrain file needs BED no more; a broken law has
a few parameters that can be edited. Real land has a largest slope, ridges and
valleys that differ, and no Gaussian land has: the table compares them.)";

}  // namespace

Command terrain_fit_command() {
    auto options = std::make_shared<FitOptions>();
    return {
        .name = "terrain fit",
        .summary = "Fit a terrain to an elevation model: its spectrum, and how well it fits",
        .options =
            {{"", {{"BED", &options->bed, "", "The elevation model", kRequired, NotEmpty{}}}},
             {"Output",
              {{"-o,--output", &options->output, "FILE.toml", "Write the terrain file here"},
               {"--rings", &options->rings, "FILE.csv",
                "Write the rings: wavenumber [rad/m], density [m^4], count, that of the terrain, "
                "its scatter, residual"},
               {"--plot", &options->plot, "FILE.png",
                "Draw both spectra, and both lands as shaded relief"}}},
             {"Law",
              {{"--law", &options->law, "LAW",
                "table (default): the rings as they are; broken: two exponents and the wavelength "
                "between them; one: one exponent",
                kOptional, OneOf{{"table", "broken", "one"}}},
               {"--ridge", &options->ridge, "",
                "With --law broken: also a raised band, the distance of ridges"},
               {"--seeds", &options->seeds, "N", "Seeds that judge the fit, 4 .. 256; default 16",
                kOptional, Within{kMinFitSeeds, kMaxFitSeeds}}}},
             run_options("Print the report as a JSON object")},
        .footer = kTerrainFitFooter,
        .run = [options](const Context& context) { run(*options, context); },
    };
}

}  // namespace ocean::app
