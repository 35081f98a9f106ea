// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How a driver filters long footprints, TAPS of shaders/preview/footprint.glsl.
#pragma once

#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/preview/renderer.hpp"

namespace ocean::preview {

/// Returns the samples along a footprint; 0: the driver's anisotropic filter fits it.
int filter_taps(const RendererOptions& options);
/// Returns a sampler through all mipmaps for these taps.
gl::Sampler make_footprint_sampler(int taps);

}  // namespace ocean::preview
