// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The backends, and the work that a machine can do within a frame.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "live_sea.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/preview/renderer.hpp"
#include "preview_options.hpp"

namespace ocean::app {

/// Returns gl, which leaves everything on the GPU, cpu, and radix2, dft and thesis for comparison.
std::span<const Backend> preview_backends();
/// Returns the backend of a name, or nothing for "auto". Throws Error.
std::optional<Backend> preview_backend(const std::string& name);
/// Returns whether the backend needs OpenGL 4.3.
bool computes_by_shaders(const Backend& backend);
/// Returns why a backend cannot compute a sea in a context, or "" if it can.
std::string why_not(const Backend& backend, const Sea& sea, const gl::ContextInfo& context);
/// Returns gl for a GPU with OpenGL 4.3, else cpu.
const Backend& best_backend(const gl::ContextInfo& context);

/// The backend that a person has chosen for the scenes of a context.
struct ChosenBackend {
    Backend chosen;
    gl::ContextInfo info;
    /// Called with the reason when the best backend takes the place of the chosen one; empty: an
    /// Error says it.
    std::function<void(const std::string& reason)> fell_back = {};

    /// Returns the backend for a model. why_not: why the chosen one cannot compute it, for example
    /// because a grid has grown too large for it; "": it can. Throws Error invalid_value.
    const Backend& fitting(const std::string& why_not);
};

/// Returns live maps of the requested sizes, or of sizes that the machine can make within a frame.
/// Throws Error invalid_value if the backend cannot compute the sea.
Computing computing_for(const Backend& backend, const PreviewOptions& options, const Sea& sea,
                        const gl::ContextInfo& context);
/// Returns the samples along a side of a terrain's map: the requested ones, or as many as the
/// machine can make within a tenth of a second. live: the map follows a slider.
int land_map_for(const PreviewOptions& options, const TerrainModel& terrain,
                 const gl::ContextInfo& context, bool live);
/// Returns why a backend cannot compute a terrain in a context, or "" if it can.
std::string why_not(const Backend& backend, const TerrainModel& terrain,
                    const gl::ContextInfo& context);
/// live: pictures follow each other in a window.
preview::RendererOptions renderer_for(const PreviewOptions& options, const gl::ContextInfo& context,
                                      bool live);
/// Returns the samples of a pixel in a window.
int live_samples(const PreviewOptions& options, const gl::ContextInfo& context);
/// Returns the drawn pixels over the window's pixels, along a side.
double pixel_scale(const gl::ContextInfo& context);

}  // namespace ocean::app
