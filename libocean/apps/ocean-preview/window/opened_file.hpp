// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that a window opens, recognised by their content: a sea, a take of the shown sea, or a
// sky.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "ocean/preview/environment.hpp"
#include "ocean/sea.hpp"

namespace ocean::app {

/// A sea file, or a baked file with its sea.
struct OpenedSea {
    Sea sea;
};
/// The shown sea with another take.
struct OpenedTake {
    Sea sea;
};
/// A panorama in place of the computed sky.
struct OpenedSky {
    std::shared_ptr<const preview::Environment> environment;
};
using OpenedFile = std::variant<OpenedSea, OpenedTake, OpenedSky>;

/// Reads a file; `shown` is the sea that a take is for. Throws Error with the reason why the file
/// cannot be opened, safe on hostile files.
OpenedFile read_opened_file(const std::string& path, const Sea& shown);

}  // namespace ocean::app
