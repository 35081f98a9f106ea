// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that a window opens, recognised by their content: a sea, a terrain, a take of the shown
// sea, or a sky.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "ocean/internal/preview/environment.hpp"
#include "scene_argument.hpp"

namespace ocean::app {

/// A sea or a terrain, from its own file or from a baked file.
struct OpenedModel {
    OpenedScene scene;
};
/// The shown sea with another take.
struct OpenedTake {
    Sea sea;
};
/// A panorama in place of the computed sky.
struct OpenedSky {
    std::shared_ptr<const preview::Environment> environment;
};
using OpenedFile = std::variant<OpenedModel, OpenedTake, OpenedSky>;

/// Reads a file; `shown` is the scene that a take is for. Throws Error with the reason why the file
/// cannot be opened, safe on hostile files.
OpenedFile read_opened_file(const std::string& path, const OpenedScene& shown);

}  // namespace ocean::app
