// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where programs keep what is the user's, after the XDG Base Directory Specification.
#pragma once

#include <string>

namespace ocean::app {

/// Returns a file of libocean's folder in $XDG_STATE_HOME or ~/.local/state; "" without a home. A
/// relative folder in the environment is ignored, as the specification asks.
std::string state_file(const std::string& name);
/// Returns likewise one in $XDG_CACHE_HOME or ~/.cache, where it may be deleted at any time.
std::string cache_file(const std::string& name);

}  // namespace ocean::app
