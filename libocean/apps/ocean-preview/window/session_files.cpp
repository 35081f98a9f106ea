// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/session_files.hpp"

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "offscreen_run.hpp"
#include "panel/changes.hpp"

namespace ocean::app {
namespace {

/// Returns true for the source of a scene that is a file.
bool is_file(const std::string& source) {
    std::error_code error;
    return std::filesystem::is_regular_file(utf8_path(source), error);
}

/// Returns true if the file has a scene of that kind, which another one may replace.
bool has_a_scene(const std::string& path, preview::SceneKind kind) {
    try {
        return kind_of(open_scene({path, {}})) == kind;
    } catch (const Error&) {
        return false;
    }
}

/// Returns "NAME.toml" for a name without an extension.
std::string with_extension(const std::string& name) {
    return utf8_path(name).has_extension() ? name : name + ".toml";
}

}  // namespace

SessionFiles::SessionFiles(const SeaArgument& source, LiveScene& scene, PanelState& state,
                           SavedScene& saved, Console& console)
    : scene_(scene), state_(state), saved_(saved), console_(console) {
    state_.source = source;
    state_.files.has_dialog = FileDialog::is_available();
    if (is_file(state_.source.source)) remember(state_.source.source);
}

void SessionFiles::open(const std::vector<std::string>& paths) {
    std::size_t opened = 0;
    for (const std::string& path : paths) opened += open_one(path) ? 1 : 0;
    if (paths.size() > 1) {
        state_.message += format_text(" (%zu of %zu files were opened)", opened, paths.size());
    }
}

bool SessionFiles::open_one(const std::string& path) {
    try {
        show(path, read_opened_file(path, scene_.opened()));
        remember(path);
        console_.note("opened: " + path);
        return true;
    } catch (const Error& error) {
        warn("not opened: " + std::string(error.what()));
    } catch (const std::bad_alloc&) {
        warn("not opened: " + path + ": there is not enough memory");
    }
    return false;
}

void SessionFiles::show(const std::string& path, OpenedFile opened) {
    if (auto* const sky = std::get_if<OpenedSky>(&opened)) {
        state_.look.environment = std::move(sky->environment);
        state_.message = "opened: " + path + ", a sky";
        return;
    }
    save_recording();
    if (auto* const take = std::get_if<OpenedTake>(&opened)) {
        const std::size_t changes = take->sea.take.events.size();
        open_with_undo(scene_, state_, std::move(take->sea));
        saved_.set_read(scene_.opened());
        state_.message = "opened: " + path + format_text(", a take of %zu changes", changes);
        return;
    }
    const char* const before = noun_of(scene_.kind());
    open_with_undo(scene_, state_, std::get<OpenedModel>(opened).scene);
    state_.changes.back().source = std::exchange(state_.source, {path, {}});
    saved_ = SavedScene(stem_of(path), scene_.opened());
    state_.message = "opened: " + path + "; Undo brings back the " + before + " before";
}

/// Saves a take that no file has, before another scene replaces it.
void SessionFiles::save_recording() {
    if (!saved_.lacks(scene_.opened())) return;
    console_.note("written: " + saved_.save(scene_.opened()));
}

bool SessionFiles::run(const PanelRequests& requests) {
    if (requests.list_recent) list_recent();
    if (requests.ask_open) ask_open();
    if (requests.ask_save) ask_save();
    if (!requests.open.empty()) open({requests.open});
    if (!requests.save_as.empty()) save_as(requests.save_as, false);
    bool changed = !requests.open.empty() || !requests.save_as.empty() || requests.list_recent;
    try {
        if (const auto answer = dialog_.poll()) {
            changed = true;
            state_.message.clear();
            if (answer->path.empty()) return true;
            if (answer->purpose == FileDialog::Purpose::open) {
                open({answer->path});
            } else {
                save_as(answer->path, true);
            }
        }
    } catch (const Error& error) {
        warn(error.what());
        state_.files.has_dialog = false;  // the next button offers a field for the path
        changed = true;
    }
    return changed;
}

/// Shows the panel's field for a path, where no dialog is installed.
void SessionFiles::show_field(FileRows::Ask ask) {
    state_.files.ask = ask;
    state_.shown = true;
}

void SessionFiles::ask_open() {
    if (dialog_.is_open()) return;
    if (!state_.files.has_dialog) return show_field(FileRows::Ask::open);
    try {
        const std::string folder =
            is_file(state_.source.source)
                ? text::to_utf8(
                      std::filesystem::absolute(utf8_path(state_.source.source)).parent_path())
                : text::to_utf8(std::filesystem::current_path());
        dialog_.ask(FileDialog::Purpose::open, folder + "/");
        state_.message = "choose a file in the dialog";
    } catch (const Error& error) {
        warn(error.what());
    }
}

void SessionFiles::ask_save() {
    if (dialog_.is_open()) return;
    if (!state_.files.has_dialog) return show_field(FileRows::Ask::save);
    try {
        const std::string name = text::to_utf8(
            std::filesystem::absolute(utf8_path(free_name(saved_.stem() + "-changed", ".toml"))));
        dialog_.ask(FileDialog::Purpose::save, name);
        state_.message = "choose a name in the dialog";
    } catch (const Error& error) {
        warn(error.what());
    }
}

void SessionFiles::save_as(const std::string& requested, bool may_replace) {
    try {
        const std::string path = with_extension(requested);
        std::error_code error;
        const bool exists = std::filesystem::exists(utf8_path(path), error);
        if (exists && (!may_replace || path != requested || !has_a_scene(path, scene_.kind()))) {
            throw Error(ErrorKind::output,
                        path + " exists" +
                            (may_replace ? std::string(", and no ") + noun_of(scene_.kind()) +
                                               " is in it: choose another name"
                                         : std::string(": choose another name")));
        }
        io::write_file_atomically(path, text_of(scene_.opened()));
        state_.source = {path, {}};
        saved_ = SavedScene(stem_of(path), scene_.opened());
        state_.message = "written: " + path;
        console_.note(state_.message);
        remember(path);
    } catch (const Error& error) {
        warn("not saved: " + std::string(error.what()));
    }
}

void SessionFiles::list_recent() {
    state_.files.recent.clear();
    for (std::string& path : recent_.read()) {
        const bool is_missing = !is_file(path);
        state_.files.recent.push_back({std::move(path), is_missing});
    }
}

void SessionFiles::remember(const std::string& path) {
    try {
        recent_.add(path);
    } catch (const Error& error) {
        if (std::exchange(warned_of_list_, true)) return;
        console_.warning("the list of recent files is not kept: " + std::string(error.what()));
    }
}

void SessionFiles::warn(const std::string& message) {
    state_.message = text::printable(message, 600);
    console_.warning(state_.message);
}

}  // namespace ocean::app
