// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include <array>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

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
void ask(PanelState& state, FilePurpose purpose) {
    (state.files.has_dialog ? state.requests.ask : state.files.ask) = purpose;
}

/// Draws the field of a purpose while its popup is open, and opens the popup if it is asked for.
void draw_path_field(FileRows& files, FilePurpose purpose, const char* popup, const char* button,
                     std::string& path) {
    if (files.ask == purpose) {
        files.ask.reset();
        ImGui::OpenPopup(popup);
    }
    if (!ImGui::BeginPopup(popup)) return;
    if (path_field(files, button)) path = files.typed;
    ImGui::EndPopup();
}

}  // namespace

void draw_open_buttons(const LiveScene& scene, PanelState& state) {
    if (ImGui::Button("Open ...")) ask(state, FilePurpose::open);
    tooltip(
        "A sea, a terrain, a take, a baked file or a sky (Ctrl O);\n"
        "files can be dropped on the window too");
    ImGui::SameLine();
    if (ImGui::Button("Save as ...")) ask(state, FilePurpose::save);
    tooltip(
        ("Save the " + std::string(scene.row().kind) + " under a chosen name (Ctrl S)").c_str());
    ImGui::SameLine();
    if (ImGui::Button("Recent")) {
        state.requests.list_recent = true;
        ImGui::OpenPopup(kRecentPopup);
    }
    draw_path_field(state.files, FilePurpose::open, "open a file", "Open", state.requests.open);
    draw_path_field(state.files, FilePurpose::save, "save as", "Save", state.requests.save_as);
    draw_recent(state);
}

}  // namespace ocean::app
