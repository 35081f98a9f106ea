// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures as files; and the file of --pictures: many pictures of one sea from one start, because
// the start takes longer than a small picture.
#pragma once

#include <string>
#include <vector>

#include "ocean/internal/preview/renderer.hpp"
#include "preview_options.hpp"
#include "scene.hpp"

namespace ocean::app {

/// Throws Error invalid_value, which names the option, unless the file ends in .png or .exr.
void require_picture_name(const std::string& path, const std::string& option);

/// Throws Error output unless the folder of a picture exists, so that no picture is drawn in vain.
void require_picture_folder(const std::string& path);

/// Samples of a pixel by default, so that crests have no steps.
inline constexpr int kSamples = 4;

/// Draws a picture as `options` say into a canvas of its own and writes it atomically: .png as a
/// screen shows it; .exr linear, Rec. 709, times the exposure, R, G, B of 32 bits. samples: of a
/// pixel, up to the driver's limit. The renderer's context must be current; its framebuffer is the
/// window's afterwards. Throws Error.
void write_picture(const std::string& path, preview::Renderer& renderer, const Scene& scene,
                   const preview::Camera& camera, const preview::Look& look,
                   preview::DrawOptions options, int samples);

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
