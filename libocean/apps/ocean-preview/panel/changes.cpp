// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "panel/changes.hpp"

#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"

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
