// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The window: GLFW's, with the panel in it.
#pragma once

#include "command.hpp"
#include "ocean/sea.hpp"
#include "preview_options.hpp"
#include "sea_argument.hpp"

namespace ocean::app {

/// Until it is closed. `source` is read again where a person asks for it. Throws Error no_gpu where
/// no window or no OpenGL 4.1 can be had.
void run_window(const PreviewOptions& options, const Sea& sea, const SeaArgument& source,
                const Context& context);

}  // namespace ocean::app
