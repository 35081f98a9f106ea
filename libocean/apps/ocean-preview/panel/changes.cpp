// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "panel/changes.hpp"

#include <utility>

#include "ocean/error.hpp"
#include "ocean/text.hpp"

namespace ocean::app {

bool try_to_set(LiveSea& sea, PanelState& state, const std::string& path,
                const std::string& value) {
    state.requests.touched = true;
    try {
        sea.set(path, value);
        state.message.clear();
        return true;
    } catch (const Error& error) {
        state.message = error.what();
        return false;
    }
}

void open_with_undo(LiveSea& sea, PanelState& state, Sea opened) {
    Sea before = sea.sea();
    sea.open(std::move(opened));
    state.changes.push_back({"the sea", "what it was", std::move(before)});
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
        Sea before = sea.sea();
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

void undo(LiveSea& sea, PanelState& state) {
    if (state.changes.empty()) {
        state.message = "nothing to undo";
        return;
    }
    const Change change = state.changes.back();
    if (change.sea) {
        const double time = sea.time();
        sea.open(*change.sea);
        sea.go_to(time);
        if (change.source) state.source = *change.source;
        state.requests.touched = true;
    } else if (!try_to_set(sea, state, change.path, change.before)) {
        return;
    }
    state.changes.pop_back();
    state.message = change.path + " back to " + change.before;
}

}  // namespace ocean::app
