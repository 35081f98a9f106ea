// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea as a file: a picture for screens, or the light itself for compositors.
#pragma once

#include <string>

#include "ocean/preview/renderer.hpp"

namespace ocean::app {

/// Throws Error invalid_value, which names the option, of a file that is neither .png nor .exr.
void require_picture_name(const std::string& path, const std::string& option);

/// Throws Error output unless the folder of a picture exists, before it is drawn in vain.
void require_picture_folder(const std::string& path);

/// Of a pixel, so that crests have no steps.
inline constexpr int kSamples = 4;

/// Draws what `options` says, in a canvas of its own and of its width and height, and writes it:
/// .png as a screen shows it; .exr as it is before that, linear, Rec. 709, times the exposure, R,
/// G, B of 32 bits; of so many samples a pixel, fewer if the driver has fewer. Atomic. The context
/// of the renderer must be current, its framebuffer is the window's own afterwards. Throws Error.
void write_picture(const std::string& path, preview::Renderer& renderer,
                   const preview::ShownSea& sea, const preview::Camera& camera,
                   const preview::Look& look, preview::DrawOptions options, int samples);

}  // namespace ocean::app
