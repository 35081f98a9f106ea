// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include <array>
#include <utility>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

constexpr const char* kOpenPopup = "open a file";
constexpr const char* kSavePopup = "save as";
constexpr const char* kRecentPopup = "recent files";

/// Closes the open popup when Escape is pressed, also while its field has the keys.
void close_by_escape() {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
}

/// Draws the field for a path, where the desktop has no dialog. Returns true when it is confirmed.
bool path_field(FileRows& files, const char* button) {
    close_by_escape();
    ImGui::TextDisabled("No file dialog (zenity, kdialog) was found: type a path");
    std::array<char, 4096> typed{};
    files.typed.copy(typed.data(), typed.size() - 1);
    ImGui::SetNextItemWidth(panel_length(2.0f * kWidgetWidth));
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText("##path", typed.data(), typed.size(),
                                          ImGuiInputTextFlags_EnterReturnsTrue);
    files.typed = typed.data();
    ImGui::SameLine();
    const bool pressed = ImGui::Button(button);
    const bool confirmed = (entered || pressed) && !files.typed.empty();
    if (confirmed) ImGui::CloseCurrentPopup();
    return confirmed;
}

void draw_recent(PanelState& state) {
    if (!ImGui::BeginPopup(kRecentPopup)) return;
    close_by_escape();
    if (state.files.recent.empty()) ImGui::TextDisabled("No file was opened yet");
    for (const FileRows::Recent& file : state.files.recent) {
        const std::string words = file.path + (file.is_missing ? "   (missing)" : "");
        const ImGuiSelectableFlags flags =
            file.is_missing ? ImGuiSelectableFlags_Disabled : ImGuiSelectableFlags_None;
        ImGui::PushID(&file);
        if (ImGui::Selectable(words.c_str(), false, flags)) state.requests.open = file.path;
        ImGui::PopID();
    }
    ImGui::EndPopup();
}

/// Asks for a path in the dialog of the desktop, or in a field.
void ask(PanelState& state, FileRows::Ask purpose) {
    const bool opens = purpose == FileRows::Ask::open;
    if (!state.files.has_dialog) {
        state.files.ask = purpose;
    } else if (opens) {
        state.requests.ask_open = true;
    } else {
        state.requests.ask_save = true;
    }
}

void draw_path_fields(PanelState& state) {
    FileRows& files = state.files;
    const FileRows::Ask asked = std::exchange(files.ask, FileRows::Ask::nothing);
    if (asked == FileRows::Ask::open) ImGui::OpenPopup(kOpenPopup);
    if (asked == FileRows::Ask::save) ImGui::OpenPopup(kSavePopup);
    if (ImGui::BeginPopup(kOpenPopup)) {
        if (path_field(files, "Open")) state.requests.open = files.typed;
        ImGui::EndPopup();
    }
    if (ImGui::BeginPopup(kSavePopup)) {
        if (path_field(files, "Save")) state.requests.save_as = files.typed;
        ImGui::EndPopup();
    }
}

}  // namespace

void draw_open_buttons(const LiveScene& scene, PanelState& state) {
    if (ImGui::Button("Open ...")) ask(state, FileRows::Ask::open);
    tooltip(
        "A sea, a terrain, a take, a baked file or a sky (Ctrl O);\n"
        "files can be dropped on the window too");
    ImGui::SameLine();
    if (ImGui::Button("Save as ...")) ask(state, FileRows::Ask::save);
    tooltip(scene.sea() != nullptr ? "Save the sea under a chosen name (Ctrl S)"
                                   : "Save the terrain under a chosen name (Ctrl S)");
    ImGui::SameLine();
    if (ImGui::Button("Recent")) {
        state.requests.list_recent = true;
        ImGui::OpenPopup(kRecentPopup);
    }
    draw_path_fields(state);
    draw_recent(state);
}

}  // namespace ocean::app
