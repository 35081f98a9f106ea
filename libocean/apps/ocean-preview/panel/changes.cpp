// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "panel/changes.hpp"

#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"

namespace ocean::app {

bool try_to_set(LiveScene& scene, PanelState& state, const std::string& path,
                const std::string& value) {
    state.requests.touched = true;
    try {
        scene->set(path, value);
        state.message.clear();
        return true;
    } catch (const Error& error) {
        state.message = error.what();
        return false;
    }
}

void open_with_undo(LiveScene& scene, PanelState& state, const OpenedScene& opened) {
    OpenedScene before = scene->opened();
    const std::string_view kind = scene.row().kind;
    std::optional<double> time;
    const LiveSea* const sea = scene->performed();
    if (sea != nullptr && opened->kind() != kind) time = sea->time();
    scene.open(opened);
    state.changes.push_back(
        {"the " + std::string(kind), "what it was", std::move(before), {}, time});
}

void toggle_recording(LiveSea& sea, PanelState& state) {
    state.requests.touched = true;
    const bool stops = sea.recording();
    const std::size_t changes = sea.sea().take.events.size();
    try {
        if (stops) {
            sea.stop_recording();
            state.message =
                format_text("recorded: the take has %zu changes; save the sea to keep it", changes);
            return;
        }
        OpenedScene before = make_subject(sea.sea());
        sea.start_recording();
        const std::size_t dropped = changes - sea.sea().take.events.size();
        state.message = "recording";
        if (dropped == 0) return;
        state.message += format_text("; %zu later changes of the take were dropped", dropped);
        state.changes.push_back({"the take", "what it was", std::move(before)});
    } catch (const Error& error) {
        state.message = error.what();
    }
}

namespace {

/// Begins a drive by a function, as a change that can be undone.
template <typename Begin>
void begin_drive(LiveSea& sea, PanelState& state, Begin&& begin) {
    state.requests.touched = true;
    sea.stop_drive();
    OpenedScene before = make_subject(sea.sea());
    begin();
    const std::string name = "hulls." + std::to_string(sea.driven_hull());
    state.message = "driving " + name + " by the arrow keys; H ends its track";
    state.changes.push_back({"the track of " + name, "what it was", std::move(before)});
}

}  // namespace

void drive_hull(LiveSea& sea, PanelState& state, std::size_t number) {
    if (number > 0) return begin_drive(sea, state, [&] { sea.start_drive(number - 1); });
    state.requests.touched = true;
    sea.stop_drive();
    state.message = "the hull's track has ended; save the sea to keep it";
}

void drive_new_hull(LiveSea& sea, PanelState& state, const std::array<double, 2>& place,
                    double heading) {
    begin_drive(sea, state, [&] { sea.drive_new_hull(place[0], place[1], heading); });
}

void add_crest(LiveSea& sea, PanelState& state, const std::array<double, 2>& place) {
    state.requests.touched = true;
    sea.stop_drive();
    const Sea& before = sea.sea();
    Sea with = before;
    const std::string name = "crests." + std::to_string(with.parameters.crests.size());
    with.parameters.crests.emplace_back();
    const double time = sea.time() + state.crest.ahead;
    set_parameter(with.parameters, name + ".height", state.crest.height);
    Crest& crest = with.parameters.crests.back();
    crest.time = time;
    crest.x = place[0];
    crest.y = place[1];
    Change change{name, "no crest", make_subject(before)};
    sea.change(std::move(with));
    state.changes.push_back(std::move(change));
    state.message = format_text("%s at %.1f, %.1f m in %.1f s", name.c_str(), place[0], place[1],
                                state.crest.ahead);
}

void undo(LiveScene& scene, PanelState& state) {
    if (state.changes.empty()) {
        state.message = "nothing to undo";
        return;
    }
    const Change change = state.changes.back();
    if (change.scene) {
        const LiveSea* const sea = scene->performed();
        const std::optional<double> time =
            sea != nullptr ? std::optional(sea->time()) : change.time;
        scene.open(change.scene);
        if (time) scene->go_to(*time);
        if (change.source) state.source = *change.source;
        state.requests.touched = true;
    } else if (!try_to_set(scene, state, change.path, change.before)) {
        return;
    }
    state.changes.pop_back();
    state.message = change.path + " back to " + change.before;
}

}  // namespace ocean::app
