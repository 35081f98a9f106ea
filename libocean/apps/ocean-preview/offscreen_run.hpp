// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Probes, a picture, a sequence of pictures: what needs no window.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "ocean/sea.hpp"
#include "picture_list.hpp"
#include "preview_options.hpp"

namespace ocean::app {

/// "storm" of "seas/storm.toml" and of "preset:storm".
std::string stem_of(const std::string& source);

/// Throws Error.
void run_offscreen(const PreviewOptions& options, const std::vector<ListedPicture>& pictures,
                   const Sea& sea, const std::string& source, const Context& context);

}  // namespace ocean::app
