// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ocean/internal/text.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/terrain_table.hpp"
#include "panel/changes.hpp"
#include "panel/parameter_row.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"
#include "sea_scene.hpp"
#include "terrain_scene.hpp"

namespace ocean::app {
namespace {

/// Returns whether the parameter has an effect with the words of its section: one that is used by
/// "jonswap, tma" has none while the spectrum is another one.
template <typename Model>
bool is_used(const Table<Model>& table, const RefOf<Model>& ref, const Model& model) {
    if (ref.info->used_by.empty()) return true;
    const std::vector<std::string> words = split(ref.info->used_by, ", ");
    for (const TableRow<Model>& other : table.rows) {
        if (other.section != ref.info->section || other.choices().empty()) continue;
        const std::string value = to_text(value_of(model, RefOf<Model>{&other, ref.item}));
        if (std::ranges::find(words, value) != words.end()) return true;
    }
    return false;
}

/// The rows of a model's table.
template <typename Model>
class Rows {
  public:
    /// model: with the values that are shown.
    Rows(const Table<Model>& table, const Model& model, LiveScene& scene, PanelState& state)
        : table_(table), model_(model), scene_(scene), state_(state) {
        for (const TableSection& section : table.sections) {
            if (!section.is_list()) continue;
            for (const TableRow<Model>& row : table.rows) {
                if (row.section == section.name && row.member.items(defaults_) == 0) {
                    row.member.renew(defaults_, 1);
                }
            }
        }
    }

    /// item: of a section that is a list.
    void section(const std::string& name, std::string_view section, std::size_t item, bool opens) {
        const bool any = std::ranges::any_of(table_.rows, [&](const TableRow<Model>& row) {
            return row.section == section && is_found(row, item, state_.search);
        });
        if (!any) return;
        const ImGuiTreeNodeFlags open =
            state_.search.empty() && !opens ? 0 : ImGuiTreeNodeFlags_DefaultOpen;
        if (!ImGui::CollapsingHeader(name.c_str(), open)) return;
        ImGui::PushID(name.c_str());
        for (const TableRow<Model>& row : table_.rows) {
            if (row.section == section && is_found(row, item, state_.search)) draw({&row, item});
        }
        ImGui::PopID();
    }

  private:
    void draw(const RefOf<Model>& ref) {
        const ShownParameter shown{*ref.info,
                                   ref.item,
                                   value_of(model_, ref),
                                   value_of(defaults_, RefOf<Model>{ref.info, 0}),
                                   is_used(table_, ref, model_),
                                   note_of(ref)};
        ImGui::SetNextItemWidth(panel_length(kWidgetWidth));
        draw_parameter(shown, [this](const ParameterChange& change) { set(change); });
    }

    std::string_view note_of(const RefOf<Model>& ref) const {
        if (scene_->performed() == nullptr) return "";
        return ref.info->change == ParameterClass::live
                   ? "Glides"
                   : "Makes another sea; a take cannot have it";
    }

    void set(const ParameterChange& change) {
        const auto& [path, value, before, is_drag] = change;
        if (!try_to_set(scene_, state_, path, value)) return;
        // A drag is one change, however many values it sets.
        const bool goes_on = is_drag && !state_.changes.empty() &&
                             state_.changes.back().path == path &&
                             state_.changes.back().before == before;
        if (!goes_on) state_.changes.push_back({path, before});
    }

    const Table<Model>& table_;
    const Model& model_;
    Model defaults_;
    LiveScene& scene_;
    PanelState& state_;
};

}  // namespace

void SeaScene::draw_parameters(LiveScene& scene, PanelState& state) {
    Rows<Parameters> rows(sea_table(), live_.now(), scene, state);
    const std::size_t systems = live_.sea().parameters.waves.size();
    for (std::size_t wave = 0; wave < systems; ++wave) {
        rows.section("Waves " + std::to_string(wave), "waves", wave, true);
    }
    if (state.search.empty()) {
        draw_hull_section(live_, state);
        draw_crest_section(state);
    }
    for (std::size_t crest = 0; crest < live_.sea().parameters.crests.size(); ++crest) {
        rows.section("Crest " + std::to_string(crest), "crests", crest, false);
    }
    const std::size_t hulls = live_.sea().parameters.hulls.size();
    for (std::size_t hull = 0; hull < hulls; ++hull) {
        rows.section("Hull " + std::to_string(hull), "hulls", hull, false);
    }
    rows.section("Surface and foam", "surface", 0, false);
    rows.section("Water body", "water", 0, false);
    rows.section("Shore", "water.shore", 0, false);
    rows.section("Grid", "grid", 0, false);
    rows.section("Clock", "time", 0, false);
    rows.section("Chance", "random", 0, false);
}

/// Draws all sections of the table, under their own names.
void TerrainScene::draw_parameters(LiveScene& scene, PanelState& state) {
    const TerrainModel shown = terrain_->model();  // a change replaces it
    Rows<TerrainModel> rows(terrain_table(), shown, scene, state);
    for (const TableSection& section : terrain_table().sections) {
        const std::string title = capitalised(section.item.empty() ? section.name : section.item);
        if (!section.is_list()) {
            rows.section(title, section.name, 0, true);
            continue;
        }
        for (std::size_t item = 0; item < items_of(terrain_table(), section.name, shown); ++item) {
            rows.section(title + " " + std::to_string(item), section.name, item, false);
        }
    }
}

}  // namespace ocean::app
