// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/session_files.hpp"

#include <algorithm>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/seafile.hpp"
#include "offscreen_run.hpp"
#include "panel/changes.hpp"
#include "scene_argument.hpp"

namespace ocean::app {
namespace {

/// Returns the take of a sea as text; "" for a sea without one and for any other subject.
std::string take_of(const Subject& scene) {
    const Sea* const sea = find_sea(scene);
    return sea != nullptr ? write_take(sea->take) : "";
}

/// Returns the tracks of a sea that are in no file of their own.
std::vector<std::shared_ptr<const HullTrack>> tracks_of(const Subject& scene) {
    std::vector<std::shared_ptr<const HullTrack>> tracks;
    const Sea* const sea = find_sea(scene);
    if (sea == nullptr) return tracks;
    for (const Hull& hull : sea->parameters.hulls) {
        if (hull.track_file.empty()) tracks.push_back(hull.track);
    }
    return tracks;
}

/// Returns true for the source of a scene that is a file.
bool is_file(const std::string& source) {
    std::error_code error;
    return std::filesystem::is_regular_file(utf8_path(source), error);
}

/// Returns true if the file has a subject of that kind, which another one may replace.
bool has_subject(const std::string& path, std::string_view kind) {
    try {
        return open_scene({path, {}})->kind() == kind;
    } catch (const Error&) {
        return false;
    }
}

/// Returns "NAME.toml" for a name without an extension.
std::string with_extension(const std::string& name) {
    return utf8_path(name).has_extension() ? name : name + ".toml";
}

}  // namespace

std::string free_name(const std::string& stem, const std::string& ending) {
    for (int n = 1;; ++n) {
        const std::string name = stem + "-" + std::to_string(n) + ending;
        if (!std::filesystem::exists(utf8_path(name))) return name;
    }
}

SavedScene::SavedScene(std::string stem, const OpenedScene& scene) : stem_(std::move(stem)) {
    set_read(*scene);
}

std::string SavedScene::save(const Subject& scene, const std::string& requested) {
    std::string name = requested + ".toml";
    if (requested.empty()) {
        name = free_name(stem_ + (take_of(scene).empty() ? "-changed" : "-performed"), ".toml");
    } else if (std::filesystem::exists(utf8_path(name))) {
        name = free_name(requested, ".toml");
    }
    io::write_file_atomically(name, scene.text());
    set_read(scene);
    return name;
}

void SavedScene::set_read(const Subject& scene) {
    kept_take_ = take_of(scene);
    kept_tracks_ = tracks_of(scene);
}

bool SavedScene::lacks(const Subject& scene) const {
    const std::string take = take_of(scene);
    const auto is_kept = [&](const auto& track) {
        return std::ranges::find(kept_tracks_, track) != kept_tracks_.end();
    };
    return (!take.empty() && take != kept_take_) || !std::ranges::all_of(tracks_of(scene), is_kept);
}

SessionFiles::SessionFiles(const SubjectArgument& source, LiveScene& scene, PanelState& state,
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
        show(path, read_opened_file(path, *scene_->opened()));
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
    if (opened.sky) {
        state_.look.environment = std::move(opened.sky);
        state_.message = "opened: " + path + ", a sky";
        return;
    }
    save_recording();
    const std::string before(scene_.row().kind);
    open_with_undo(scene_, state_, opened.scene);
    if (opened.take_changes) {
        saved_.set_read(*opened.scene);
        state_.message =
            "opened: " + path + format_text(", a take of %zu changes", *opened.take_changes);
        return;
    }
    state_.changes.back().source = std::exchange(state_.source, {path, {}});
    saved_ = SavedScene(stem_of(path), opened.scene);
    state_.message = "opened: " + path + "; Undo brings back the " + before + " before";
}

/// Saves a take or a driven track that no file has, before another scene replaces it.
void SessionFiles::save_recording() {
    if (LiveSea* const sea = scene_->performed()) sea->stop_drive();
    const OpenedScene scene = scene_->opened();
    if (saved_.lacks(*scene)) console_.note("written: " + saved_.save(*scene));
}

bool SessionFiles::run(const PanelRequests& requests) {
    if (requests.list_recent) list_recent();
    if (requests.ask) ask(*requests.ask);
    if (!requests.open.empty()) open({requests.open});
    if (!requests.save_as.empty()) save_as(requests.save_as, false);
    bool changed = !requests.open.empty() || !requests.save_as.empty() || requests.list_recent;
    try {
        if (const auto answer = dialog_.poll()) {
            changed = true;
            state_.message.clear();
            if (answer->path.empty()) return true;
            if (answer->purpose == FilePurpose::open) {
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

void SessionFiles::ask(FilePurpose purpose) {
    if (dialog_.is_open()) return;
    if (!state_.files.has_dialog) {
        state_.files.ask = purpose;
        state_.shown = true;
        return;
    }
    try {
        const std::filesystem::path source = utf8_path(state_.source.source);
        if (purpose == FilePurpose::save) {
            const std::string name = free_name(saved_.stem() + "-changed", ".toml");
            dialog_.ask(purpose, text::to_utf8(std::filesystem::absolute(utf8_path(name))));
            state_.message = "choose a name in the dialog";
        } else {
            dialog_.ask(purpose, text::to_utf8(is_file(state_.source.source)
                                                   ? std::filesystem::absolute(source).parent_path()
                                                   : std::filesystem::current_path()) +
                                     "/");
            state_.message = "choose a file in the dialog";
        }
    } catch (const Error& error) {
        warn(error.what());
    }
}

void SessionFiles::save_as(const std::string& requested, bool may_replace) {
    try {
        const std::string path = with_extension(requested);
        const std::string kind(scene_.row().kind);
        std::error_code error;
        const bool exists = std::filesystem::exists(utf8_path(path), error);
        if (exists && (!may_replace || path != requested || !has_subject(path, kind))) {
            throw Error(ErrorKind::output,
                        path + " exists" +
                            (may_replace ? ", and no " + kind + " is in it" : std::string()) +
                            ": choose another name");
        }
        const OpenedScene scene = scene_->opened();
        io::write_file_atomically(path, scene->text());
        state_.source = {path, {}};
        saved_ = SavedScene(stem_of(path), scene);
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
