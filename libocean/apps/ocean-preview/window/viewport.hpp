// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The picture behind the panel: the scene as the renderer draws it, or a stage of its transform.
#pragma once

#include <memory>
#include <string>

#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/preview/canvas.hpp"
#include "ocean/internal/preview/renderer.hpp"
#include "panel/panel_state.hpp"
#include "preview_options.hpp"
#include "scene.hpp"
#include "stage_picture.hpp"

namespace ocean::app {

class Viewport {
  public:
    Viewport(const PreviewOptions& options, const gl::ContextInfo& info);

    preview::Renderer& renderer() { return renderer_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Sets the size of the window's framebuffer [pixels].
    void resize(int width, int height);
    /// Draws the view of `state` and copies it into the window's framebuffer, which is bound then.
    /// A stage appears with show_stage. Throws Error.
    void draw(Scene& scene, const preview::Camera& camera, const PanelState& state);
    /// Adds the drawn stage to a frame of ImGui, beside the panel.
    void show_stage(const PanelState& state);
    /// Binds the window's framebuffer, all of it.
    void bind_window() const;
    /// Writes the shown picture to a file that is free, ending .png or .exr (a stage is a .png).
    /// Returns its name. Throws Error.
    std::string save(const std::string& stem, const std::string& ending, const Scene& scene,
                     const preview::Camera& camera, const PanelState& state);

  private:
    preview::DrawOptions draw_options(const PanelState& state) const;
    void draw_stage(Scene& scene, const PanelState& state);

    const PreviewOptions& options_;
    int samples_;
    double scale_;  // drawn pixels over those of the window, along a side
    preview::Renderer renderer_;
    std::unique_ptr<preview::Canvas> canvas_;
    int canvas_width_ = 0, canvas_height_ = 0;
    int width_ = 0, height_ = 0;
    StagePicture stage_;
    gl::Texture stage_texture_;
    float beside_panel_ = 1.0f;  // share of the window's width that the panel left free
};

}  // namespace ocean::app
