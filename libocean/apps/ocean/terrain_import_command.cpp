// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean terrain import`: makes raw floats (.flt) of an elevation model in another format, and
// reports the facts of the model.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "commands.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/elevation_import.hpp"
#include "ocean/internal/elevation_rules.hpp"
#include "ocean/internal/io/elevation.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

struct ImportCommandOptions {
    std::string file;
    std::string output;
    std::string unit;
    std::string sign = "up";
    std::string holes = "refuse";
    std::string degrees = "auto";
    std::string cell;
    std::string range;
    std::string corner;
    std::string crop;
    std::string square;
};

/// Returns the numbers of "X0,Y0,X1,Y1", each of them within -1e9 .. 1e9.
template <std::size_t count>
std::array<double, count> numbers_of(const std::string& text, const std::string& option,
                                     const std::string& shape) {
    constexpr double kMaxNumber = 1e9;
    const std::vector<std::string> words = split(text, ',');
    if (words.size() != count) {
        refuse(option + " " + text::printable(text) + ": allowed is " + shape);
    }
    std::array<double, count> numbers{};
    for (std::size_t i = 0; i < count; ++i) {
        numbers[i] = parse_number(words[i], option, -kMaxNumber, kMaxNumber);
    }
    return numbers;
}

std::array<double, 2> range_of(const std::string& text) {
    const auto range = numbers_of<2>(text, "--range", "LOWEST,HIGHEST in metres");
    for (const double height : range) {
        if (std::abs(height) <= kMaxElevation) continue;
        refuse("--range " + text::printable(text) +
               ": allowed are heights of -100000 .. "
               "100000 m");
    }
    if (range[0] == range[1]) {
        refuse("--range " + text::printable(text) + ": black and white have one height");
    }
    return range;
}

std::array<double, 2> corner_of(const std::string& text) {
    const auto corner = corner_of_name(text);
    if (corner && text.size() == 7) return *corner;
    refuse("--corner " + text::printable(text) + ": allowed is the name of a tile, as N34W119");
}

/// Sets the edges of "WEST,SOUTH,EAST,NORTH": metres, or degrees as in "6W,51.5N,2E,54N".
void set_crop(const std::string& text, ElevationOptions& options) {
    const std::string shape = "WEST,SOUTH,EAST,NORTH in metres, or in degrees as 6W,51.5N,2E,54N";
    options.crop_in_degrees = text.find_first_of("NSEW") != text.npos;
    if (!options.crop_in_degrees) {
        options.crop = numbers_of<4>(text, "--crop", shape);
        return;
    }
    std::string plain;
    std::vector<std::string> words = split(text, ',');
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view letters = i % 2 == 0 ? "EW" : "NS";
        const std::size_t letter = words[i].empty() ? 2 : letters.find(words[i].back());
        if (letter > 1) {
            refuse("--crop " + text::printable(text) + ": allowed is " + shape);
        }
        words[i].pop_back();
        plain += (i == 0 ? "" : ",") + std::string(letter == 1 ? "-" : "") + words[i];
    }
    options.crop = numbers_of<4>(plain, "--crop", shape);
}

ElevationImport request_of(const ImportCommandOptions& options) {
    ElevationImport request;
    request.options.unit = enumerator_of<HeightUnit>(options.unit);  // "": as the file says
    request.options.sign = options.sign == "down" ? HeightSign::down : HeightSign::up;
    request.options.holes = HolePolicy::keep;  // refused or filled once the facts are reported
    request.options.degrees = options.degrees == "yes"  ? CellsInDegrees::yes
                              : options.degrees == "no" ? CellsInDegrees::no
                                                        : CellsInDegrees::automatic;
    if (!options.cell.empty()) {
        constexpr double kMinCell = 1e-6, kMaxCell = 1e6;
        request.cell = parse_number(options.cell, "--cell", kMinCell, kMaxCell);
    }
    if (!options.range.empty()) request.range = range_of(options.range);
    if (!options.corner.empty()) request.corner = corner_of(options.corner);
    if (!options.crop.empty()) set_crop(options.crop, request.options);
    return request;
}

/// Throws if the output exists and is another program's, or is the input.
void check_output(const ImportCommandOptions& options) {
    const std::filesystem::path output = utf8_path(options.output);
    if (output.extension() != ".flt") {
        refuse("-o " + text::printable(options.output, 200) +
               ": allowed is NAME.flt; NAME.hdr and NAME.prj are written beside it");
    }
    io::require_folder(output.parent_path().string());
    std::error_code ignored;
    for (const char* extension : {".flt", ".hdr", ".prj"}) {
        std::filesystem::path file = output;
        file.replace_extension(extension);
        std::filesystem::path input = utf8_path(options.file);
        const bool is_input =
            std::filesystem::equivalent(file, input, ignored) ||
            std::filesystem::equivalent(file, input.replace_extension(extension), ignored);
        if (is_input) {
            refuse("'" + text::to_utf8(file) +
                   "' is an input of this command: it is not overwritten; choose another "
                   "file");
        }
        io::refuse_to_replace_foreign_file(text::to_utf8(file), "`ocean terrain import`", [&] {
            return io::is_written_elevation(options.output);
        });
    }
}

std::string system_text(const ElevationModel& model) {
    const std::string name = elevation::crs_name(model.crs);
    std::string text = name.empty() ? "unknown" : name;
    if (model.was_degrees) {
        text += ", in degrees; the south-west cell lies at " +
                fixed_text(model.geographic_origin[1], 6) + " N, " +
                fixed_text(model.geographic_origin[0], 6) + " E";
    }
    return text;
}

std::string facts_text(const ElevationModel& model, const ElevationSummary& summary) {
    const Domain& domain = model.domain;
    const double step_x = domain.step(0), step_y = domain.step(1);
    const std::string cell = fixed_text(step_x, 3) + " m x " + fixed_text(step_y, 3) + " m";
    std::string text =
        "size     " + std::to_string(domain.samples[0]) + " x " +
        std::to_string(domain.samples[1]) + " cells, " + length_text(step_x * domain.samples[0]) +
        " x " + length_text(step_y * domain.samples[1]) + "\ncell     " + cell + "\norigin   " +
        plain_text(domain.origin[0]) + ", " + plain_text(domain.origin[1]) +
        " m, the centre of the south-west cell\nsystem   " + system_text(model) + "\nheights  " +
        fixed_text(double{summary.lowest}, 2) + " .. " + fixed_text(double{summary.highest}, 2) +
        " m, mean " + fixed_text(summary.mean, 2) + " m, rms " + fixed_text(summary.rms, 2) +
        " m\nholes    " + std::to_string(summary.holes) + " of " + std::to_string(domain.count()) +
        " cells (" +
        significant<3>(100.0 * static_cast<double>(summary.holes) /
                       static_cast<double>(domain.count())) +
        " %)\n";
    for (const std::string& note : model.notes) text += wrapped("note: " + note, 0, 80);
    return text;
}

std::string facts_json(const ImportCommandOptions& options, const ElevationModel& model,
                       const ElevationSummary& summary) {
    const Domain& domain = model.domain;
    JsonObject json{JsonLines{2}};
    json.add("file", options.file)
        .add("samples", json_array(domain.samples))
        .add("cell", json_array(std::array{domain.step(0), domain.step(1)}))
        .add("origin", json_array(domain.origin))
        .add("unit", "m")
        .add("system", model.crs.empty() ? Json(nullptr) : Json(model.crs))
        .add("was_degrees", model.was_degrees)
        .add("geographic_origin",
             model.was_degrees ? Json(json_array(model.geographic_origin)) : Json(nullptr))
        .add("lowest", double{summary.lowest})
        .add("highest", double{summary.highest})
        .add("mean", summary.mean)
        .add("rms", summary.rms)
        .add("holes", summary.holes)
        .add("share_of_holes",
             static_cast<double>(summary.holes) / static_cast<double>(domain.count()))
        .add("notes", json_array(model.notes))
        .add("output", options.output.empty() ? Json(nullptr) : Json(options.output));
    return json.text() + "\n";
}

/// Returns a function that reports the rows that were read every few seconds.
std::function<void(int, int)> row_progress_on(Console& console) {
    auto report = std::make_shared<std::function<void(std::size_t)>>();
    return [&console, report](int rows, int of_rows) {
        if (!*report) *report = progress_on(console, "rows", static_cast<std::size_t>(of_rows));
        if (rows > 0) (*report)(static_cast<std::size_t>(rows));
    };
}

void settle_holes(ElevationModel& model, const ImportCommandOptions& options,
                  const ElevationSummary& summary) {
    if (summary.holes > 0 && options.holes == "refuse" && summary.holes < model.heights.size()) {
        throw Error(ErrorKind::bad_file,
                    text::printable(options.file, 200) + ": " + std::to_string(summary.holes) +
                        " of " + std::to_string(model.heights.size()) +
                        " heights are missing; --holes fill fills them with the smooth surface "
                        "around them");
    }
    elevation::apply_holes(model, options.file, HolePolicy::fill);
}

void run(const ImportCommandOptions& options, const Context& context) {
    constexpr double kMinSquare = 1e-3, kMaxSquare = 1e6;
    const double square = options.square.empty()
                              ? 0.0
                              : parse_number(options.square, "--square", kMinSquare, kMaxSquare);
    ElevationImport request = request_of(options);
    if (!options.output.empty()) check_output(options);
    request.options.progress = row_progress_on(context.console);
    ElevationModel model = import_elevation(options.file, request);
    const ElevationSummary summary = summarize(model);
    context.console.data(context.options.json ? facts_json(options, model, summary)
                                              : facts_text(model, summary));
    if (options.output.empty()) return;
    settle_holes(model, options, summary);
    if (square > 0.0) model = with_square_cells(model, square);
    const auto hold = context.interrupts.hold();
    io::make_folder(utf8_path(options.output).parent_path().string());
    io::write_elevation(model, options.output);
    if (!context.options.quiet && !context.options.json) {
        const Domain& grid = model.domain;
        context.console.data("written  " + options.output + ", " + std::to_string(grid.samples[0]) +
                             " x " + std::to_string(grid.samples[1]) +
                             " cells, with .hdr and .prj beside it\n");
    }
}

constexpr char kTerrainImportFooter[] =
    R"(Reads SRTM tiles (N34W119.hgt), OpenEXR (needs --cell; the channel whose name
says height, in metres), ESRI ASCII grids (.asc), raw floats (.flt with .hdr) and,
by ocean-raster, which is installed apart (Debian: ocean-terrain), what GDAL reads
of GeoTIFF, DTED, USGS DEM, Surfer, ENVI and grey PNG (needs --cell and --range):
one band, with its mask, its units, and its sidecars (.tfw, .aux.xml, .msk). Other
formats become GeoTIFF by `gdal_translate -ot Float32 IN OUT.tif`. Without -o the
facts are printed and nothing is written. Cells of degrees are scaled to metres
by the latitude of the centre, and the model then begins at (0, 0); cells of a map
that stretches the ground by more than 1 %, as Mercator's does, are scaled to it.
A crop is read alone, and scaled at its own centre. What reads a file works in a
process of its own, with limits of memory (2 GiB) and time (10 minutes of CPU).)";

}  // namespace

Command terrain_import_command() {
    auto options = std::make_shared<ImportCommandOptions>();
    const auto words = [](std::initializer_list<std::string> list) {
        return OneOf{std::vector<std::string>(list)};
    };
    return {
        .name = "terrain import",
        .summary = "Convert an elevation model to raw floats (.flt), and report its facts",
        .options =
            {{"", {{"FILE", &options->file, "", "The elevation model", kRequired, NotEmpty{}}}},
             {"Output",
              {{"-o,--output", &options->output, "FILE",
                "NAME.flt; NAME.hdr and NAME.prj are written beside it"}}},
             {"Heights",
              {{"--unit", &options->unit, "UNIT",
                "Unit of the heights: m, ft or us_ft (US survey feet); default: as the file says, "
                "else m",
                kOptional, words({"m", "ft", "us_ft"})},
               {"--sign", &options->sign, "SIGN",
                "up (default) or down: the file's depths are positive", kOptional,
                words({"up", "down"})},
               {"--holes", &options->holes, "POLICY",
                "refuse (default) missing heights, or fill them with the smooth surface around "
                "them",
                kOptional, words({"refuse", "fill"})},
               {"--range", &options->range, "LOWEST,HIGHEST",
                "Heights of black and white in a PNG [m]"}}},
             {"Place",
              {{"--cell", &options->cell, "METRES",
                "Side of a cell, for files that do not state it"},
               {"--degrees", &options->degrees, "WORD",
                "Cells are degrees: yes, no, or auto (default): as the file says, else by its "
                "coordinates",
                kOptional, words({"yes", "no", "auto"})},
               {"--corner", &options->corner, "NAME",
                "South-west corner of an SRTM tile whose file has another name, as N34W119"},
               {"--crop", &options->crop, "WEST,SOUTH,EAST,NORTH",
                "Keep the cells whose centres lie within these edges: metres, from the south-west "
                "cell on where cells are degrees, or degrees as 6W,51.5N,2E,54N"},
               {"--square", &options->square, "METRES",
                "Write square cells of this side, as the bed of a sea needs: between cells by "
                "interpolation, larger ones as means"}}},
             run_options("Print the facts as a JSON object")},
        .footer = kTerrainImportFooter,
        .run = [options](const Context& context) { run(*options, context); },
    };
}

}  // namespace ocean::app
