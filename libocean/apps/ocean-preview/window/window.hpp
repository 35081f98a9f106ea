// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The program in a window.
#pragma once

#include "command.hpp"
#include "preview_options.hpp"
#include "scene_argument.hpp"

namespace ocean::app {

/// Blocks until the window is closed. `source` is read again when a person requests it. Throws
/// Error no_gpu if no window with OpenGL 4.1 can be opened.
void run_window(const PreviewOptions& options, const OpenedScene& scene,
                const SubjectArgument& source, const Context& context);

}  // namespace ocean::app
