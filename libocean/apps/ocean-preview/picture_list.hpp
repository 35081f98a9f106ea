// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The file of --pictures: many pictures of one sea from one start, because the start takes longer
// than a small picture.
#pragma once

#include <string>
#include <vector>

#include "preview_options.hpp"

namespace ocean::app {

struct ListedPicture {
    std::string path;
    PreviewOptions options;
};

/// Returns the pictures of a file. A line names FILE.png or FILE.exr and options of time, camera,
/// light and picture; other options are those of `words`. Blanks separate words, "..." may contain
/// them, and a word that begins with # starts a comment. Throws Error with the number of the line,
/// or if the file has no picture.
std::vector<ListedPicture> read_picture_list(const std::string& file, const PreviewWords& words);

}  // namespace ocean::app
