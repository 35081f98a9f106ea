// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the preview keeps what is the user's, after the XDG Base Directory Specification.
#pragma once

#include <string>

#include "ocean/preview/renderer.hpp"

namespace ocean::app {

/// Returns a file in $VARIABLE/libocean, or in ~/FALLBACK/libocean; "" without a home. A relative
/// folder in the environment is ignored, as the specification asks.
std::string user_file(const char* variable, const char* fallback, const char* name);

/// Returns the place of the renderer's textures in the user's cache. Errors of the disk are
/// ignored: the textures are made again.
preview::KeptTextures textures_in_cache();

}  // namespace ocean::app
