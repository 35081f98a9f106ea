// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean info`: prints the quantities of a sea that oceanographers use, or those of a terrain, as
// the spectrum asks for and as the grid resolves. Also reads them back from a baked file.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "console.hpp"
#include "info_text.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/find_crest.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrainfile.hpp"
#include "source_text.hpp"
#include "standard_input.hpp"
#include "subject_argument.hpp"

namespace ocean::app {
namespace {

struct InfoOptions {
    SubjectArgument subject;
    bool sea_file = false;
    bool find_crest = false;
    std::optional<double> from;  // [s]
    std::optional<double> to;
    std::string box;
};

/// Returns the window of --find-crest: by default ten minutes from the start, or a loop, and all of
/// the period.
CrestWindow window_of(const InfoOptions& info, const Timing& time) {
    constexpr double kSearched = 600.0;  // [s]
    CrestWindow window;
    window.from = info.from.value_or(time.start);
    const double span = time.loop_period > 0.0 ? std::min(time.loop_period, kSearched) : kSearched;
    window.to = info.to.value_or(window.from + span);
    for (const double end : {window.from, window.to}) require_time(end);
    if (window.to < window.from) {
        refuse("--to = " + plain_text(window.to) + ": allowed is --from or later, " +
               plain_text(window.from));
    }
    if (info.box.empty()) return window;
    const std::vector<std::string> numbers = split(info.box, ',');
    std::array<double, 4>& place = window.place.emplace();
    for (std::size_t i = 0; i < place.size() && numbers.size() == place.size(); ++i) {
        place[i] = parse_number(numbers[i], "--box", -1e7, 1e7);
    }
    if (numbers.size() == place.size() && place[0] < place[2] && place[1] < place[3]) return window;
    refuse("--box " + info.box +
           ": allowed are X0,Y0,X1,Y1, the south-western and the "
           "north-eastern corner");
}

/// The frame of a baked file; nothing of a sea or terrain file, of a preset and of a pipe.
struct BakedFrame {
    std::optional<int> frame;
    std::optional<double> time;  // [s]

    /// Returns the name of the source with its frame, "sea.0012.exr, frame 12 at 0.458333 s".
    std::string named(const std::string& source) const {
        return source + (frame ? ", frame " + std::to_string(*frame) : "") +
               (time ? " at " + significant_text(*time, 6) + " s" : "");
    }
    /// Returns a JSON object with the members "frame" and "time" before its own.
    std::string added_to(const std::string& object) const {
        return "{" + (frame ? "\"frame\": " + std::to_string(*frame) + ", " : "") +
               (time ? "\"time\": " + plain_text(*time) + ", " : "") + object.substr(1);
    }
};

BakedFrame baked_frame_of(const std::string& source) {
    if (source == kStandardInput || source.starts_with(kPresetPrefix)) return {};
    if (text::is_pipe_or_device(source)) return {};
    const auto provenance = io::read_provenance(source);
    return provenance ? BakedFrame{provenance->frame, provenance->time} : BakedFrame{};
}

void describe(const TerrainModel& terrain, const InfoOptions& info, const Context& context) {
    if (info.sea_file) return context.console.data(write_terrain(terrain));
    Terrain land(terrain, {.threads = context.options.threads});
    const TerrainState state = land.state();
    const BakedFrame baked = baked_frame_of(info.subject.source);
    if (context.options.json) {
        context.console.data(baked.added_to(terrain_state_json(state)) + "\n");
    } else {
        context.console.data(terrain_info_text(terrain, baked.named(info.subject.source), state));
    }
    for (const std::string& warning : state.warnings) context.console.warning(warning);
}

void find_crest(const Sea& sea, const InfoOptions& info, const Context& context) {
    const Timing& time = sea.parameters.time;
    const CrestWindow window = window_of(info, time);
    Ocean ocean(sea, {.threads = context.options.threads});
    const std::size_t maps = crest_search_maps(ocean, window);
    const FoundCrest crest =
        find_highest_crest(ocean, window, progress_on(context.console, "maps", maps));
    const double frame = time.first_frame + (crest.time - time.start) * time.fps;
    const FoundCrestText text{crest, frame, window, ocean.state()};
    context.console.data(context.options.json ? found_crest_json(text) : found_crest_text(text));
}

void describe(const Sea& sea, const InfoOptions& info, const Context& context) {
    if (info.sea_file) return context.console.data(write_sea(sea));
    if (info.find_crest) return find_crest(sea, info, context);
    if (info.from || info.to || !info.box.empty()) {
        refuse("--from, --to and --box belong to --find-crest, which is not given");
    }
    Ocean ocean(sea, {.threads = context.options.threads});
    const SeaState state = ocean.state();
    const BakedFrame baked = baked_frame_of(info.subject.source);
    if (context.options.json) {
        context.console.data(baked.added_to(sea_state_json(state)) + "\n");
    } else {
        // A map of one period, which is measured, says nothing of a sea over a bed.
        const FrameCost cost = state.bed ? FrameCost{} : ocean.measure_frame_cost();
        context.console.data(info_text(sea, baked.named(info.subject.source), state, cost));
    }
    for (const std::string& warning : state.warnings) context.console.warning(warning);
}

constexpr char kInfoFooter[] =
    R"(asked: integral of the spectrum; resolved: sum over the modes of the grid.
For a terrain, asked: the mean of all seeds; the other column: this very tile.
Directions are in degrees counter-clockwise from +x (east), towards which the
waves travel; nautical directions are clockwise from north, from which the waves
come.)";

}  // namespace

Command info_command() {
    auto info = std::make_shared<InfoOptions>();
    return {
        .name = "info",
        .summary = "Describe a sea or a terrain: heights, periods, slopes, grid",
        .options = {subject_options(info->subject, kSeaKind),
                    {"Output",
                     {{"--sea-file", &info->sea_file, "",
                       "Print the resolved sea file instead, the text that baked files hold"}}},
                    {"Highest crest",
                     {only_of(kSeaKind, {"--find-crest", &info->find_crest, "",
                                         "Print the highest crest that the sea has in a window of "
                                         "time and place instead"}),
                      only_of(kSeaKind, {"--from", &info->from, "SECONDS",
                                         "First time of the window (default the start) [s]"}),
                      only_of(kSeaKind, {"--to", &info->to, "SECONDS",
                                         "Last time (default 600 s later, or the end of a loop) "
                                         "[s]"}),
                      only_of(kSeaKind, {"--box", &info->box, "X0,Y0,X1,Y1",
                                         "South-western and north-eastern corner of the window "
                                         "(default the whole period) [m]"})}},
                    run_options("Print one JSON object; warnings as JSON lines")},
        .footer = kInfoFooter,
        .run =
            [info](const Context& context) {
                const OpenedSubject subject = open_subject(info->subject);
                std::visit([&](const auto& model) { describe(model, *info, context); }, subject);
            },
    };
}

}  // namespace ocean::app
