// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "ocean/parameter_table.hpp"
#include "ocean/text.hpp"
#include "panel/changes.hpp"
#include "panel/parameter_row.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

/// Returns whether the parameter has an effect with the words of its section: one that is used by
/// "jonswap, tma" has none while the spectrum is another one.
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
        ImGui::SetNextItemWidth(panel_length(kWidgetWidth));
        draw_parameter(shown, [this](const ParameterChange& change) { set(change); });
    }

    void set(const ParameterChange& change) {
        const auto& [path, value, before, is_drag] = change;
        if (!try_to_set(sea_, state_, path, value)) return;
        // A drag is one change, however many values it sets.
        const bool goes_on = is_drag && !state_.changes.empty() &&
                             state_.changes.back().path == path &&
                             state_.changes.back().before == before;
        if (!goes_on) state_.changes.push_back({path, before});
    }

    LiveSea& sea_;
    PanelState& state_;
};

}  // namespace

void draw_parameter_sections(LiveSea& sea, PanelState& state) {
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

}  // namespace ocean::app
