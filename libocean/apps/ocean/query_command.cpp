// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean query`: prints the displaced surface at points of the world; reads and writes CSV.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "bed_points.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "input_files.hpp"
#include "interrupt.hpp"
#include "ocean/channel.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"
#include "point_table.hpp"
#include "subject_argument.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr std::size_t kBatch =
    1 << 16;  // points at a time, so that a long list needs little memory
constexpr char kHeader[] =
    "x,y,height,normal_x,normal_y,normal_z,velocity_x,velocity_y,velocity_z,foam";
constexpr char kOrbitalHeader[] = ",orbital_velocity_x,orbital_velocity_y,orbital_velocity_z";

struct QueryCommandOptions {
    SubjectArgument sea;
    std::string points;
    std::string output;
    std::optional<double> time;
    std::optional<int> frame;
    std::optional<double> orbital_z;
    QueryOptions query;
};

class QueryRun {
  public:
    QueryRun(const QueryCommandOptions& options, const Context& context)
        : options_(options), context_(context), sea_(open_sea(options.sea)) {
        if (options.time.has_value() == options.frame.has_value()) {
            refuse("either --time or --frame is required");
        }
        time_ = options.time ? *options.time : sea_.time_of(*options.frame);
        InputFiles inputs(options.sea.source, named_files(sea_));
        inputs.add(options.points);
        inputs.spare(options.output);
    }

    void run() {
        static const std::array<PointColumn, 3> kColumns = {{{"x", PointColumn::Kind::needed, "m"},
                                                             {"y", PointColumn::Kind::needed, "m"},
                                                             {"name", PointColumn::Kind::text}}};
        const PointTable table = read_points(options_.points, kColumns);
        if (!table.left_out().empty()) context_.console.warning("--points: " + table.left_out());
        std::vector<WaterPoint> places;
        for (std::size_t i = 0; i < table.size(); ++i) {
            places.push_back(
                {table.numbers("x")[i], table.numbers("y")[i], options_.orbital_z.value_or(0.0)});
        }
        for (const auto& text : bed_point_warnings(sea_, places, options_.orbital_z.has_value())) {
            context_.console.warning(text);
        }
        Ocean ocean(sea_, {.threads = context_.options.threads,
                           .foam_progress = foam_progress_on(context_.console)});
        // The header waits for the first rows, whose query may be refused.
        std::string text = std::string(kHeader) + (options_.orbital_z ? kOrbitalHeader : "") +
                           (table.has("name") ? ",name\n" : "\n");
        for (std::size_t first = 0; first < table.size(); first += kBatch) {
            const std::size_t count = std::min(kBatch, table.size() - first);
            const auto names = table.has("name") ? table.texts("name").subspan(first, count)
                                                 : std::span<const std::string>();
            text += rows(ocean, table.numbers("x").subspan(first, count),
                         table.numbers("y").subspan(first, count), names);
            write(std::exchange(text, ""));
        }
        if (!text.empty()) write(text);  // there are no points
        if (!options_.output.empty()) write_output(context_.interrupts, options_.output, text_);
        if (folded_ > 0) {
            context_.console.warning(format_text(
                "%zu of %zu points lie where the crests have folded over: they take the top sheet",
                folded_, table.size()));
        }
        if (undecided_ > 0) {
            context_.console.warning(
                format_text("%zu of %zu points lie where the sea is folded so much that its top "
                            "sheet is unknown, "
                            "the first at %s; reduce choppiness",
                            undecided_, table.size(), first_undecided_.c_str()));
        }
    }

  private:
    void write(const std::string& text) {
        if (options_.output.empty()) return context_.console.data(text);
        text_ += text;
    }

    std::string rows(Ocean& ocean, std::span<const double> x, std::span<const double> y,
                     std::span<const std::string> names) {
        std::vector<WorldPoint> points;
        for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i]});
        std::vector<QuerySample> samples(points.size());
        ocean.query(time_, points, samples, options_.query);
        std::vector<WaterMotion> orbital;
        if (options_.orbital_z) {
            orbital.resize(points.size());
            std::vector<WaterPoint> below;
            for (const WorldPoint& p : points) below.push_back({p.x, p.y, *options_.orbital_z});
            ocean.water_motion(time_, below, orbital, options_.query);
        }
        std::string text;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const QuerySample& sample = samples[i];
            folded_ += sample.folded ? 1 : 0;
            if (sample.undecided && undecided_++ == 0) {
                first_undecided_ = shortest_text(points[i].x) + "," + shortest_text(points[i].y);
            }
            text += shortest_text(points[i].x) + ',' + shortest_text(points[i].y);
            append_values(text, {&sample.height, 1});
            append_values(text, sample.normal);
            append_values(text, sample.velocity);
            append_values(text, {&sample.foam, 1});
            if (!orbital.empty()) {
                const WaterMotion& water = orbital[i];
                append_values(text, {{water.velocity_x, water.velocity_y, water.velocity_z}});
            }
            if (!names.empty()) text += ',' + csv_cell(names[i]);
            text += '\n';
        }
        return text;
    }

    /// Writes the digits of single precision, which maps have.
    void append_values(std::string& text, std::span<const double> values) const {
        for (const double value : values) {
            text += ',';
            text += options_.query.exact ? shortest_text(value)
                                         : shortest_text(static_cast<float>(value));
        }
    }

    const QueryCommandOptions& options_;
    const Context& context_;
    Sea sea_;
    double time_ = 0.0;
    std::size_t folded_ = 0;
    std::size_t undecided_ = 0;
    std::string first_undecided_;  // its coordinates
    std::string text_;             // of the file
};

constexpr char kQueryFooter[] =
    R"(Columns: x,y,height (m), normal_x,y,z (unit vector, up), velocity_x,y,z (m/s, of
the surface point), foam (0 .. 1). The displacement is inverted: a row describes
the surface that is visible at x,y. Where crests have folded over, it describes
the top sheet. A column name of the points comes last.
FILE has a header line with the columns x, y and optionally name; a unit may
follow: x [m].
Cells are separated by commas, semicolons, tabs or blanks; unless commas
separate cells, numbers may have a decimal comma. UTF-8 or UTF-16. Other columns
are ignored with a warning; an ambiguous table is an error.)";

}  // namespace

Command query_command() {
    auto options = std::make_shared<QueryCommandOptions>();
    QueryOptions& query = options->query;
    return {
        .name = "query",
        .summary = "Height, normal, velocity and foam at points of the world, as CSV",
        .options =
            {subject_options(options->sea, kSeaKind),
             {"Where and when",
              {{"--points", &options->points, "FILE",
                "Table with a header line and the columns x,y in metres, see below; - = standard "
                "input",
                kRequired},
               {"--time", &options->time, "T", "Seconds"},
               {"--frame", &options->frame, "N", "Number of a frame, in place of --time"}}},
             {"Accuracy",
              {{"--exact", &query.exact, "", "Sum all modes in double precision: slow"},
               {"--refine", &query.refine, "K",
                "Interpolate maps that are 1, 2, 4 ... times as fine; default 1, with an error of "
                "at "
                "most 2e-3 of the rms height"},
               {"!--no-foam", &query.foam, "",
                "Leave foam at 0: computing earlier foam takes far longer than all the rest"}}},
             {"Output",
              {{"--orbital", &options->orbital_z, "Z",
                "Add the velocity of the water at this height, 0 = still water, as columns "
                "orbital_velocity_x,y,z"},
               {"-o,--output", &options->output, "FILE", "Write the CSV here"}}},
             run_options("")},
        .footer = kQueryFooter,
        .run = [options](const Context& context) { QueryRun(*options, context).run(); },
    };
}

}  // namespace ocean::app
