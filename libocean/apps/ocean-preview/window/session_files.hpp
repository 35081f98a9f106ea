// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files of a window's session: those that are dropped, chosen in a dialog or in the list of
// recent ones, and the file that the scene is saved as.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "console.hpp"
#include "live_scene.hpp"
#include "panel/panel_state.hpp"
#include "scene.hpp"
#include "window/file_dialog.hpp"
#include "window/opened_file.hpp"
#include "window/recent_files.hpp"

namespace ocean::app {

/// Returns the first of STEM-1.png, STEM-2.png ... that does not exist: no file is overwritten.
std::string free_name(const std::string& stem, const std::string& ending);

/// The scene of a window as files. It knows whether the take is in a file, because a recording must
/// not be lost with the window.
class SavedScene {
  public:
    /// stem: of the names of the files.
    SavedScene(std::string stem, const OpenedScene& scene);

    const std::string& stem() const { return stem_; }
    /// Writes STEM-changed-1.toml or STEM-performed-1.toml ..., or a file of the requested name if
    /// that is free. Returns the name. Throws Error.
    std::string save(const Subject& scene, const std::string& requested = "");
    /// The scene was read from a file.
    void set_read(const Subject& scene);
    /// Returns whether the scene is a sea with a take or a driven track that no file has.
    bool lacks(const Subject& scene) const;

  private:
    std::string stem_;
    std::string kept_take_;  // as text
    std::vector<std::shared_ptr<const HullTrack>> kept_tracks_;
};

class SessionFiles {
  public:
    /// source: of the scene. All other arguments outlive the object.
    SessionFiles(const SubjectArgument& source, LiveScene& scene, PanelState& state,
                 SavedScene& saved, Console& console);

    /// Opens files: a sea or a terrain, takes for a sea, a sky. One that cannot be opened says why
    /// in the window and on standard error, and changes nothing. The scene before can be brought
    /// back by Undo; a recording that is in no file is saved first.
    void open(const std::vector<std::string>& paths);
    /// Carries out what the panel requested, and reads the answer of a dialog. Returns true if
    /// something has changed.
    bool run(const PanelRequests& requests);
    /// Asks for a path in the dialog of the desktop, or in a field of the panel.
    void ask(FilePurpose purpose);
    bool is_asking() const { return dialog_.is_open(); }

  private:
    bool open_one(const std::string& path);
    void show(const std::string& path, OpenedFile opened);
    void save_as(const std::string& requested, bool may_replace);
    void save_recording();
    void list_recent();
    void remember(const std::string& path);
    void warn(const std::string& message);

    LiveScene& scene_;
    PanelState& state_;
    SavedScene& saved_;
    Console& console_;
    RecentFiles recent_;
    FileDialog dialog_;
    bool warned_of_list_ = false;
};

}  // namespace ocean::app
