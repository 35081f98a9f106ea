// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that a window writes: seas, terrains and pictures, under names that are free.
#pragma once

#include <string>

#include "scene.hpp"

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
    /// Returns whether the scene is a sea with a take that no file has.
    bool lacks(const Subject& scene) const;

  private:
    std::string stem_;
    std::string kept_take_;  // as text
};

}  // namespace ocean::app
