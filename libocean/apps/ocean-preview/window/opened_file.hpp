// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that a window opens, recognised by their content: a sea, a terrain, a take of the shown
// sea, or a sky.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "ocean/internal/preview/environment.hpp"
#include "scene.hpp"

namespace ocean::app {

struct OpenedFile {
    OpenedScene scene = {};  // from its own file or from a baked one; null: the file is a sky
    std::optional<std::size_t> take_changes = {};  // the scene is the shown sea with another take
    std::shared_ptr<const preview::Environment> sky = {};  // in place of the computed one
};

/// Reads a file; `shown` is the scene that a take is for. Throws Error with the reason why the file
/// cannot be opened, safe on hostile files.
OpenedFile read_opened_file(const std::string& path, const Subject& shown);

}  // namespace ocean::app
