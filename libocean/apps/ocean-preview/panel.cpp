// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/seafile.hpp"
#include "ocean/text.hpp"
#include "ocean/water_types.hpp"
#include "parameter_row.hpp"
#include "stage_picture.hpp"

namespace ocean::app {
namespace {

/// Whether the word that the parameter counts for is the sea's: "jonswap, tma".
bool is_used(const ParameterInfo& info, const Parameters& parameters, std::size_t wave) {
    if (info.used_by.empty()) return true;
    const std::vector<std::string> words = split(info.used_by, ", ");
    for (const ParameterInfo& other : parameter_table()) {
        if (other.section != info.section || other.choices().empty()) continue;
        const std::string value = to_text(value_of(parameters, {&other, wave}));
        if (std::ranges::find(words, value) != words.end()) return true;
    }
    return false;
}

bool try_to_set(LiveSea& sea, PanelState& state, const std::string& path,
                const std::string& value) {
    state.touched = true;
    try {
        sea.set(path, value);
        state.message.clear();
        return true;
    } catch (const Error& error) {
        state.message = error.what();
        return false;
    }
}

class Rows {
  public:
    Rows(LiveSea& sea, PanelState& state) : sea_(sea), state_(state) {}

    void section(const char* name, std::string_view section, std::size_t wave) {
        bool any = false;
        for (const ParameterInfo& info : parameter_table()) {
            any = any || (info.section == section && is_found(info, wave, state_.search));
        }
        if (!any) return;
        const ImGuiTreeNodeFlags open =
            state_.search.empty() && section != "waves" ? 0 : ImGuiTreeNodeFlags_DefaultOpen;
        if (!ImGui::CollapsingHeader(name, open)) return;
        ImGui::PushID(name);
        for (const ParameterInfo& info : parameter_table()) {
            if (info.section == section && is_found(info, wave, state_.search)) {
                row(info, wave);
            }
        }
        ImGui::PopID();
    }

  private:
    void row(const ParameterInfo& info, std::size_t wave) {
        static const Parameters defaults;
        const Parameters& now = sea_.now();
        const ShownParameter shown{info, wave, value_of(now, {&info, wave}),
                                   value_of(defaults, {&info, 0}), is_used(info, now, wave)};
        ImGui::SetNextItemWidth(panel_length(150.0f));
        draw_parameter(shown, [this](const ParameterChange& change) { set(change); });
    }

    void set(const ParameterChange& change) {
        const auto& [path, value, before, is_drag] = change;
        if (!try_to_set(sea_, state_, path, value)) return;
        // A drag is one change, however often it was heard.
        const bool goes_on = is_drag && !state_.changes.empty() &&
                             state_.changes.back().path == path &&
                             state_.changes.back().before == before;
        if (!goes_on) state_.changes.push_back({path, before});
    }

    LiveSea& sea_;
    PanelState& state_;
};

void slider(PanelState& state, const char* label, double& value, float lowest, float highest,
            const char* format, ImGuiSliderFlags flags = ImGuiSliderFlags_None) {
    auto shown = static_cast<float>(value);
    if (ImGui::SliderFloat(label, &shown, lowest, highest, format, flags)) {
        value = static_cast<double>(shown);
        state.touched = true;
    }
}

void transport(LiveSea& sea, PanelState& state) {
    if (ImGui::Button(sea.paused ? "Play (Space)" : "Pause (Space)")) {
        sea.paused = !sea.paused;
    }
    ImGui::SameLine();
    if (ImGui::Button("To start")) {
        sea.go_to(sea.sea().parameters.time.start);
        state.touched = true;
    }
    ImGui::SameLine();
    if (ImGui::Button("To end")) {
        sea.go_to(sea.take_end());
        state.touched = true;
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("To the last change of the take");
    ImGui::SameLine();
    if (ImGui::Button(sea.recording() ? "Stop (R)###record" : "Record (R)###record")) {
        state.record = true;
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip(
            "Changes of gliding parameters become a take of the sea, which is saved\n"
            "with it and plays everywhere; what the take has later goes");
    }
    ImGui::PushItemWidth(panel_length(150.0f));
    double time = sea.time();
    if (ImGui::DragScalar("Time", ImGuiDataType_Double, &time, 0.05f, nullptr, nullptr, "%.2f s")) {
        sea.go_to(std::clamp(time, -1e9, 1e9));
        state.touched = true;
    }
    bool again = sea.play_again_after.has_value();
    if (ImGui::Checkbox("Play again from the start", &again)) {
        // The whole of what there is to see: a loop, or a take and some seconds of its last glide.
        const double loop = sea.sea().parameters.time.loop_period;
        const double take = sea.take_end() - sea.sea().parameters.time.start;
        sea.play_again_after.reset();
        if (again) sea.play_again_after = loop > 0.0 ? loop : std::max(10.0, take + 3.0);
    }
    if (again && sea.play_again_after) {
        slider(state, "After", *sea.play_again_after, 1.0f, 600.0f, "%.1f s",
               ImGuiSliderFlags_Logarithmic);
    }
    slider(state, "Speed", sea.speed, 0.05f, 20.0f, "%.2f x", ImGuiSliderFlags_Logarithmic);
    ImGui::PopItemWidth();
}

void picture(LiveSea& sea, PanelState& state) {
    ImGui::PushItemWidth(panel_length(150.0f));
    if (ImGui::BeginCombo("View (V)", state.view.c_str())) {
        for (const std::string& view : all_view_names()) {
            if (ImGui::Selectable(view.c_str(), view == state.view)) {
                state.view = view;
                state.touched = true;
            }
        }
        ImGui::EndCombo();
    }
    const std::string all = state.cascade < 0 ? "all" : std::to_string(state.cascade);
    if (ImGui::BeginCombo("Cascade", all.c_str())) {
        for (int cascade = -1; cascade < state.cascades; ++cascade) {
            const std::string name = cascade < 0 ? "all" : std::to_string(cascade);
            if (ImGui::Selectable(name.c_str(), cascade == state.cascade)) {
                state.cascade = cascade;
                state.touched = true;
            }
        }
        ImGui::EndCombo();
    }
    preview::Look& look = state.look;
    const std::vector<std::string> looks = preview::look_names();
    if (ImGui::BeginCombo("Look", looks[static_cast<std::size_t>(look.kind)].c_str())) {
        for (const std::string& name : looks) {
            if (ImGui::Selectable(name.c_str())) {
                look.kind = preview::look_of(name);
                state.touched = true;
            }
        }
        ImGui::EndCombo();
    }
    if (ImGui::BeginCombo("Water", look.water_type.c_str())) {
        for (const WaterType& type : water_types()) {
            const std::string name(type.name);
            if (ImGui::Selectable(name.c_str(), name == look.water_type)) {
                look.water_type = name;
                state.touched = true;
            }
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(type.help).c_str());
        }
        ImGui::EndCombo();
    }
    if (look.environment) {
        slider(state, "Sky turned", look.environment_turn, -180.0f, 180.0f, "%.1f deg");
    } else {
        slider(state, "Sun's altitude", look.sun_altitude, -12.0f, 90.0f, "%.1f deg");
        slider(state, "Sun's bearing", look.sun_bearing, -180.0f, 180.0f, "%.0f deg");
    }
    slider(state, "Exposure", look.exposure, 0.05f, 20.0f, "%.2f", ImGuiSliderFlags_Logarithmic);
    slider(state, "Visibility", look.visibility, 500.0f, 200000.0f, "%.0f m",
           ImGuiSliderFlags_Logarithmic);
    ImGui::PopItemWidth();
    ImGui::PushItemWidth(panel_length(62.0f));  // two in a row
    slider(state, "Foam shown", look.foam_amount, 0.0f, 4.0f, "%.2f");
    ImGui::SameLine();
    slider(state, "Crest light", look.crest_light, 0.0f, 4.0f, "%.2f");
    ImGui::PopItemWidth();
    if (ImGui::Checkbox("Wireframe (F)", &state.wireframe)) state.touched = true;
    ImGui::SameLine();
    if (ImGui::Checkbox("Probe (P)", &state.probing)) state.touched = true;
    ImGui::SameLine();
    if (ImGui::Checkbox("Near detail", &sea.near_detail)) state.touched = true;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("The waves too short for the maps");
}

void camera_rows(CameraControl& camera, PanelState& state) {
    static constexpr const char* kModes[] = {"fly", "walk", "orbit", "float"};
    ImGui::PushItemWidth(panel_length(150.0f));
    int mode = static_cast<int>(camera.mode);
    if (ImGui::Combo("Camera (C)", &mode, kModes, 4)) {
        camera.mode = static_cast<CameraMode>(mode);
        state.touched = true;
    }
    slider(state, "Field of view", camera.camera().field_of_view, 5.0f, 120.0f, "%.0f deg");
    slider(state, "Height of the eye", camera.camera().eye[2], 0.3f, 5000.0f, "%.1f m",
           ImGuiSliderFlags_Logarithmic);
    ImGui::PopItemWidth();
    if (ImGui::Button("Back to where it began")) state.reset_camera = true;
    ImGui::TextDisabled("W A S D, Q E: move   Shift: fast\ndrag: turn   wheel: zoom");
}

void text_row(const char* label, std::string& text, const char* help) {
    std::array<char, 512> typed{};
    text.copy(typed.data(), typed.size() - 1);
    ImGui::SetNextItemWidth(panel_length(150.0f));
    if (ImGui::InputText(label, typed.data(), typed.size())) text = typed.data();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
}

/// Starts and stops a bridge of its own.
void own_bridge(BridgeRows& bridge) {
    ImGui::BeginDisabled(bridge.is_running);
    text_row("Address", bridge.host.listen, "Where clients come: HOST:PORT");
    text_row("Map of knobs", bridge.host.map, "A file; without one a1 is the wind's speed");
    ImGui::Checkbox("Dummy board", &bridge.host.dummy);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Instead of a K8055 on USB: OUT board0/a1 128");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button(bridge.is_running ? "Restart" : "Start")) {
        bridge.asked = BridgeRows::Asked::start;
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(!bridge.is_running);
    if (ImGui::Button("Stop")) bridge.asked = BridgeRows::Asked::stop;
    ImGui::EndDisabled();
}

/// Who moves what, and what was said.
void show_bridge(BridgeRows& bridge) {
    if (bridge.is_own) {
        own_bridge(bridge);
    } else {
        ImGui::TextUnformatted(bridge.link->connected() ? "joined"
                                                        : "not there; it is tried again");
    }
    if (bridge.link != nullptr) {
        for (const auto& [name, mover] : bridge.link->movers()) {
            const bool here = mover == bridge.link->own_name();
            if (here && name.starts_with("app.")) continue;  // its clock, which it always tells
            ImGui::Text("%s: %s", name.c_str(), here ? "this window" : mover.c_str());
        }
    }
    ImGui::BeginChild("log", {0.0f, panel_length(120.0f)}, true);
    for (const std::string& line : bridge.log) ImGui::TextWrapped("%s", line.c_str());
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1.0f);
    ImGui::EndChild();
}

void choose_preset(LiveSea& sea, PanelState& state) {
    ImGui::SetNextItemWidth(panel_length(150.0f));
    if (!ImGui::BeginCombo("Preset", "choose ...")) return;
    for (const Preset& preset : presets()) {
        if (ImGui::Selectable(preset.name.c_str())) {
            state.touched = true;
            try {
                Sea before = sea.sea();
                sea.open(parse_sea(preset.toml, preset.name, ""));
                state.changes.push_back({"the sea", "what it was", std::move(before)});
                state.message = preset.name + ": " + preset.description;
            } catch (const Error& error) {
                state.message = error.what();
            }
        }
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", preset.description.c_str());
    }
    ImGui::EndCombo();
}

void numbers(const LiveSea& sea, const preview::ShownSea& shown, const PanelState& state) {
    ImGui::Text("Hs %.2f m   Tp %.1f s   mss %.4f", shown.significant_wave_height,
                shown.peak_period, shown.mean_square_slope);
    const double settling = sea.foam_settling();
    // A line that comes and goes would move what is under the mouse.
    const std::string foam =
        settling > 0.0 ? format_text("foam settling: %.1f s", settling) : "foam settled";
    const std::size_t changes = sea.sea().take.events.size();
    ImGui::Text("%s   %s %zu changes", foam.c_str(),
                sea.recording() ? "RECORDING," : "take:", changes);
    ImGui::Text("sea %.1f ms   draw %.1f ms   panel %.1f ms", state.times.sea, state.times.draw,
                state.times.panel);
    ImGui::TextDisabled("%s", state.drawn_by.c_str());
}

/// What computes the sea, and what each that has computed takes for a frame.
void choose_backend(PanelState& state) {
    ImGui::SetNextItemWidth(panel_length(150.0f));
    if (!ImGui::BeginCombo("Computed by", state.backend.c_str())) return;
    for (const BackendRow& row : state.backends) {
        std::string words = row.name;
        if (row.milliseconds > 0.0) words += format_text("   %.1f ms", row.milliseconds);
        if (!row.why_not.empty()) words += "   " + row.why_not;
        const ImGuiSelectableFlags flags =
            row.why_not.empty() ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
        if (ImGui::Selectable(words.c_str(), row.name == state.backend, flags)) {
            state.backend_asked = row.name;
        }
    }
    ImGui::EndCombo();
}

/// Warnings of the sea and what was written or refused, at the foot of the window; and what the
/// mouse points at.
void speak(LiveSea& sea, const PanelState& state) {
    if (!state.under_mouse.empty()) ImGui::SetTooltip("%s", state.under_mouse.c_str());
    std::string text;
    if (state.shown) {
        for (const std::string& warning : full_development_warnings(sea.now())) {
            text += warning + "\n";
        }
    }
    text += state.message;
    if (text.empty()) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float margin = panel_length(kPanelMargin);
    ImGui::SetNextWindowPos({size.x - margin, size.y - margin}, ImGuiCond_Always, {1.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.7f);
    ImGui::Begin("message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(std::max(panel_length(200.0f), 0.6f * size.x));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

/// The panel where it begins, beside the sea; and after another scale where a hand has put it, as
/// much larger as its letters are, but within the window.
void place_panel(PanelPlace& place) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float margin = panel_length(kPanelMargin);
    const float least = panel_length(200.0f);
    const auto within = [&](float length, float whole) {
        return std::min(length, std::max(least, whole - 2.0f * margin));
    };
    const float letters = ImGui::GetFontSize();
    if (letters == place.letters) return;
    const bool is_first = place.letters == 0.0f;
    const float times = is_first ? 1.0f : letters / place.letters;
    if (is_first) {
        place.corner = {margin, margin};
        place.wanted = {panel_length(kPanelWidth) - 2.0f * margin, window.y};
    } else {
        // What had no room before may have it now; a size that a hand gave is another one.
        if (place.size != place.fitted) place.wanted = place.size;
        for (float& length : place.wanted) length *= times;
    }
    place.letters = letters;
    place.fitted = {within(place.wanted[0], window.x), within(place.wanted[1], window.y)};
    const auto inside = [&](int axis, float whole) {
        return std::clamp(times * place.corner[static_cast<std::size_t>(axis)], 0.0f,
                          std::max(0.0f, whole - place.fitted[static_cast<std::size_t>(axis)]));
    };
    ImGui::SetNextWindowPos({inside(0, window.x), inside(1, window.y)});
    ImGui::SetNextWindowSize({place.fitted[0], place.fitted[1]});
}

}  // namespace

void toggle_recording(LiveSea& sea, PanelState& state) {
    state.touched = true;
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
        state.message = "nothing to take back";
        return;
    }
    const Change change = state.changes.back();
    if (change.sea) {
        const double time = sea.time();
        sea.open(*change.sea);
        sea.go_to(time);
        state.touched = true;
    } else if (!try_to_set(sea, state, change.path, change.before)) {
        return;
    }
    state.changes.pop_back();
    state.message = change.path + " back to " + change.before;
}

void draw_panel(LiveSea& sea, const preview::ShownSea& shown, CameraControl& camera,
                PanelState& state) {
    speak(sea, state);
    if (!state.shown) return;
    place_panel(state.place);
    const bool is_open = ImGui::Begin("Sea (Tab hides)");
    state.place.corner = {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y};
    if (is_open) {
        state.place.size = {ImGui::GetWindowSize().x, ImGui::GetWindowSize().y};
        transport(sea, state);
        numbers(sea, shown, state);
        if (ImGui::Button("Save sea")) state.save_sea = true;
        ImGui::SameLine();
        if (ImGui::Button("Undo")) undo(sea, state);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Ctrl Z");
        ImGui::SameLine();
        if (ImGui::Button("PNG (F12)")) state.save_picture = ".png";
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Save the picture as it is shown");
        ImGui::SameLine();
        if (ImGui::Button("EXR")) state.save_picture = ".exr";
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("Save its light, linear, for a compositor (Shift F12)");
        }
        ImGui::SameLine();
        if (ImGui::Button("Reload")) state.reload = true;
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("The sea file, as it is now (Ctrl R)");
        if (ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen)) {
            picture(sea, state);
        }
        if (ImGui::CollapsingHeader("Camera")) camera_rows(camera, state);
        if (ImGui::CollapsingHeader("Bridge")) show_bridge(state.bridge);
        ImGui::Separator();
        char search[64] = {};
        std::strncpy(search, state.search.c_str(), sizeof search - 1);
        ImGui::SetNextItemWidth(panel_length(150.0f));
        if (ImGui::InputText("Search (/)", search, sizeof search)) state.search = search;
        choose_preset(sea, state);
        choose_backend(state);
        Rows rows(sea, state);
        const std::size_t systems = sea.sea().parameters.waves.size();
        for (std::size_t wave = 0; wave < systems; ++wave) {
            rows.section(("Waves " + std::to_string(wave)).c_str(), "waves", wave);
        }
        rows.section("Surface and foam", "surface", 0);
        rows.section("Water body", "water", 0);
        rows.section("Grid", "grid", 0);
        rows.section("Clock", "time", 0);
        rows.section("Chance", "random", 0);
    }
    ImGui::End();
}

}  // namespace ocean::app
