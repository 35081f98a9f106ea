// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The scene of pictures without a window, by its kind.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "command.hpp"
#include "ocean/internal/gl/context.hpp"
#include "preview_options.hpp"
#include "scene_argument.hpp"
#include "stage_picture.hpp"
#include "workload.hpp"

namespace ocean::app {

/// The OpenGL context of the constructor must be current in every call, also in the destructor.
class OffscreenScene {
  public:
    virtual ~OffscreenScene() = default;

    /// Returns the time of a picture [s]; 0 for land.
    virtual double time_of(const PreviewOptions& options) const = 0;
    /// Returns the time of a frame [s]; 0 for land.
    virtual double time_of_frame(int frame) const = 0;
    /// Returns the scene of a picture at a time; those of one time share its maps, over a bed those
    /// of one eye. Throws Error.
    virtual const preview::DrawnScene& shown_at(const PreviewOptions& options, double time) = 0;
    /// Returns a stage of the scene at a time. Throws Error.
    virtual StagePicture stage(const PreviewOptions& options, double time) = 0;
    /// Returns the line of a probe. Throws Error.
    virtual std::string probe_line(preview::Renderer& renderer, const PreviewOptions& options,
                                   const std::array<double, 2>& place, double time) = 0;
    /// Returns the camera of a picture, and a warning or "".
    virtual preview::Camera camera_of(const PreviewOptions& options, std::string& warning) = 0;
};

/// Returns the line of a probe of a sea that is shown: "X,Y,NUMBER...". Throws Error.
std::string sea_probe_line(preview::Renderer& renderer, const preview::DrawnSea& shown,
                           const PreviewOptions& options, const std::array<double, 2>& place);

/// Throws Error.
std::unique_ptr<OffscreenScene> make_offscreen_scene(const OpenedScene& scene,
                                                     const PreviewOptions& options,
                                                     const Backend& backend,
                                                     const gl::ContextInfo& info,
                                                     const Context& context);

}  // namespace ocean::app
