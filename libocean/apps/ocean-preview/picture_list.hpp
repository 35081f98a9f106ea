// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The file of --pictures: many pictures of one sea from one start, for most of what a small picture
// takes is the start.
#pragma once

#include <string>
#include <vector>

#include "preview_options.hpp"

namespace ocean::app {

struct ListedPicture {
    std::string path;
    PreviewOptions options;
};

/// Reads FILE.png or FILE.exr and options of when, camera, light and picture from each line of a
/// file; what a line does not name is as `words` have it. Blanks separate, "..." holds them
/// together, and the rest of a line from a word that begins with # on is a comment. Throws Error
/// with the number of the line, and if there is no picture in the file.
std::vector<ListedPicture> read_picture_list(const std::string& file, const PreviewWords& words);

}  // namespace ocean::app
