// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a machine can compute and draw in time.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "live_sea.hpp"
#include "ocean/gl/context.hpp"
#include "ocean/preview/renderer.hpp"
#include "preview_options.hpp"

namespace ocean::app {

/// gl, which leaves everything on the GPU; cpu; and radix2, dft and thesis to compare with.
std::span<const Backend> preview_backends();
/// One of those, or nothing for "auto". Throws Error.
std::optional<Backend> preview_backend(const std::string& name);
/// Whether it needs a context that computes.
bool computes_by_shaders(const Backend& backend);
/// Why a backend cannot compute a sea in a context; empty: it can.
std::string why_not(const Backend& backend, const Sea& sea, const gl::ContextInfo& context);
/// gl where the sea can be computed in that context, and fast; else cpu.
const Backend& best_backend(const gl::ContextInfo& context);

/// Maps as the options say, or such as the machine can make in time, live. Throws Error
/// invalid_value where the backend cannot.
Computing computing_for(const Backend& backend, const PreviewOptions& options, const Sea& sea,
                        const gl::ContextInfo& context);
preview::RendererOptions renderer_for(const PreviewOptions& options,
                                      const gl::ContextInfo& context);
/// Of a pixel that is drawn again and again.
int live_samples(const PreviewOptions& options, const gl::ContextInfo& context);
/// Of a window's pixels along a side, those that are drawn.
double pixel_scale(const gl::ContextInfo& context);

}  // namespace ocean::app
