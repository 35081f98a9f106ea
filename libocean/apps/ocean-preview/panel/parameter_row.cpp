// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "panel/parameter_row.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "ocean/internal/text.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

/// The slider that the user is dragging.
struct Drag {
    std::string path;  // empty: none
    double value = 0.0;
    std::string before;
};

class Row {
  public:
    Row(const ShownParameter& shown, const std::function<void(const ParameterChange&)>& set)
        : spec_(shown.spec),
          shown_(shown),
          set_(set),
          path_(spec_.path(shown.item)),
          label_(spec_.label) {}

    void draw() {
        ImGui::PushID(path_.c_str());
        if (!shown_.is_used) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.45f);
        if (!spec_.choices().empty()) {
            words();
        } else if (const auto* real = std::get_if<double>(&shown_.value)) {
            number(*real);
        } else if (spec_.member_type.optional) {
            number(std::nullopt);
        } else if (const auto* whole = std::get_if<std::int64_t>(&shown_.value)) {
            whole_number(*whole);
        } else if (const auto* truth = std::get_if<bool>(&shown_.value)) {
            checkbox(*truth);
        } else {
            text();
        }
        if (!shown_.is_used) ImGui::PopStyleVar();
        ImGui::PopID();
    }

  private:
    void tooltip() {
        if (!ImGui::IsItemHovered()) return;
        std::string words = path_ + "\n" + std::string(spec_.help) + "\n" + allowed_values(spec_);
        if (!spec_.used_by.empty()) words += "\nHas an effect with: " + std::string(spec_.used_by);
        if (!shown_.note.empty()) words += "\n" + std::string(shown_.note);
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(panel_length(380.0f));
        ImGui::TextUnformatted(words.c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }

    void menu() {
        tooltip();
        if (!ImGui::BeginPopupContextItem("menu")) return;
        const bool unsets = spec_.member_type.optional && to_text(shown_.default_value).empty();
        if (ImGui::MenuItem(unsets ? "Unset" : "Reset to default")) {
            set(to_text(shown_.default_value));
        }
        if (ImGui::MenuItem("Copy name")) ImGui::SetClipboardText(path_.c_str());
        ImGui::EndPopup();
    }

    /// value: nothing for an optional number that is unset; its slider begins at the low end.
    void number(std::optional<double> value) {
        const auto lowest = static_cast<float>(std::max(spec_.min, spec_.soft_min));
        const auto highest = static_cast<float>(std::min(spec_.max, spec_.soft_max));
        // A dragged slider follows the mouse, any other the model's value, which may glide.
        const bool is_dragged = drag_.path == path_;
        auto shown = is_dragged ? static_cast<float>(drag_.value)
                                : static_cast<float>(value.value_or(static_cast<double>(lowest)));
        const bool wide = lowest > 0.0f && highest / lowest > 100.0f;
        const std::string format =
            !value && !is_dragged
                ? "unset"
                : "%.5g" + (spec_.unit.empty() ? std::string() : " " + std::string(spec_.unit));
        const bool changed =
            ImGui::SliderFloat(label_.c_str(), &shown, lowest, highest, format.c_str(),
                               wide ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
        const bool active = ImGui::IsItemActive();
        const bool done = ImGui::IsItemDeactivatedAfterEdit();
        menu();
        if (changed) {
            if (drag_.path != path_) drag_.before = value ? shortest_text(*value) : "";
            drag_.path = path_;
            drag_.value = static_cast<double>(shown);
        }
        const bool live = spec_.change == ParameterClass::live;
        if (drag_.path == path_ && (done || (live && changed))) {
            set(shortest_text(static_cast<float>(drag_.value)));
        }
        if (drag_.path == path_ && !active) drag_.path.clear();
    }

    void whole_number(std::int64_t value) {
        if (spec_.rule == NumberRule::power_of_two) {
            if (ImGui::BeginCombo(label_.c_str(), std::to_string(value).c_str())) {
                const auto offer = [&](std::int64_t n) {
                    const std::string text = std::to_string(n);
                    if (ImGui::Selectable(text.c_str(), n == value)) set(text);
                };
                if (spec_.min_nonzero > 0.0) offer(0);
                for (std::int64_t n = 32; n <= 4096; n *= 2) offer(n);
                ImGui::EndCombo();
            }
        } else {
            auto shown = static_cast<int>(std::min<std::int64_t>(value, 2147483647));
            if (ImGui::InputInt(label_.c_str(), &shown, 1, 10,
                                ImGuiInputTextFlags_EnterReturnsTrue)) {
                set(std::to_string(shown));
            }
        }
        menu();
    }

    void checkbox(bool value) {
        bool shown = value;
        if (ImGui::Checkbox(label_.c_str(), &shown)) set(to_text(shown));
        menu();
    }

    void words() {
        const std::string value = to_text(shown_.value);
        if (ImGui::BeginCombo(label_.c_str(), value.c_str())) {
            for (const std::string_view word : spec_.choices()) {
                if (ImGui::Selectable(std::string(word).c_str(), word == value)) {
                    set(std::string(word));
                }
            }
            ImGui::EndCombo();
        }
        menu();
    }

    void text() {
        char shown[256] = {};
        std::strncpy(shown, to_text(shown_.value).c_str(), sizeof shown - 1);
        if (ImGui::InputText(label_.c_str(), shown, sizeof shown,
                             ImGuiInputTextFlags_EnterReturnsTrue)) {
            set(shown);
        }
        menu();
    }

    void set(const std::string& value) {
        const bool is_drag = drag_.path == path_;
        set_({path_, value, is_drag ? drag_.before : to_text(shown_.value), is_drag});
    }

    const ParameterSpec& spec_;
    const ShownParameter& shown_;
    const std::function<void(const ParameterChange&)>& set_;
    std::string path_;
    std::string label_;
    static inline Drag drag_;  // there is one mouse
};

}  // namespace

float panel_length(float at_scale_one) {
    return at_scale_one * ImGui::GetFontSize() / kLetterSize;
}

void draw_parameter(const ShownParameter& shown,
                    const std::function<void(const ParameterChange&)>& set) {
    Row(shown, set).draw();
}

bool is_found(const ParameterSpec& spec, std::size_t item, const std::string& search) {
    if (search.empty()) return true;
    const std::string wanted = lower_case(search);
    return lower_case(spec.label).find(wanted) != std::string::npos ||
           spec.path(item).find(wanted) != std::string::npos;
}

}  // namespace ocean::app
