// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures as files: colours for screens, or linear light for compositors.
#pragma once

#include <string>

#include "ocean/internal/preview/renderer.hpp"
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

}  // namespace ocean::app
