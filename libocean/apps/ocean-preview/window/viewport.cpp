// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/viewport.hpp"

#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ocean/internal/io/png.hpp"
#include "panel/widgets.hpp"
#include "picture_list.hpp"
#include "scene_argument.hpp"
#include "window/session_files.hpp"
#include "workload.hpp"

namespace ocean::app {
namespace {

preview::RendererOptions live(preview::RendererOptions options) {
    options.live = true;
    return options;
}

}  // namespace

Viewport::Viewport(const PreviewOptions& options, const gl::ContextInfo& info)
    : options_(options),
      samples_(live_samples(options, info)),
      scale_(pixel_scale(info)),
      renderer_(live(renderer_for(options, info, true))) {}

void Viewport::resize(int width, int height) {
    width_ = width;
    height_ = height;
    const int drawn_width = std::max(16, static_cast<int>(std::lround(width * scale_)));
    const int drawn_height = std::max(16, static_cast<int>(std::lround(height * scale_)));
    if (canvas_ && drawn_width == canvas_width_ && drawn_height == canvas_height_) return;
    canvas_ = std::make_unique<preview::Canvas>(drawn_width, drawn_height, GL_RGBA8, samples_);
    canvas_width_ = drawn_width;
    canvas_height_ = drawn_height;
}

void Viewport::draw(Scene& scene, const preview::Camera& camera, const PanelState& state) {
    if (is_stage_picture(state.view)) return draw_stage(scene, state);
    canvas_->bind();
    scene.draw(renderer_, camera, state.look, draw_options(state));
    canvas_->copy_to_window(width_, height_);
}

preview::DrawOptions Viewport::draw_options(const PanelState& state) const {
    preview::DrawOptions options;
    options.width = canvas_width_;
    options.height = canvas_height_;
    options.view = preview::view_of(state.view);
    options.wireframe = state.wireframe;
    options.cascade = state.cascade;
    return options;
}

void Viewport::draw_stage(Scene& scene, const PanelState& state) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    stage_ = laid_out(
        scene.stage(state.view, state.cascade),
        std::max(1, static_cast<int>(std::lround(static_cast<float>(width_) * beside_panel_))),
        height_);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!stage_texture_) stage_texture_ = gl::generate<gl::Texture, &glGenTextures>();
    glBindTexture(GL_TEXTURE_2D, stage_texture_.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, stage_.width, stage_.height, 0, GL_RGB,
                 GL_UNSIGNED_BYTE, stage_.rgb.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void Viewport::show_stage(const PanelState& state) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float left = state.shown ? std::min(panel_length(kPanelWidth), 0.5f * size.x) : 0.0f;
    beside_panel_ = (size.x - left) / size.x;
    if (!is_stage_picture(state.view) || !stage_texture_) return;
    ImGui::GetBackgroundDrawList()->AddImage(
        reinterpret_cast<void*>(static_cast<std::uintptr_t>(stage_texture_.name())), {left, 0.0f},
        size, {0.0f, 1.0f}, {1.0f, 0.0f});
}

void Viewport::bind_window() const {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width_, height_);
}

std::string Viewport::save(const std::string& stem, const std::string& ending, const Scene& scene,
                           const preview::Camera& camera, const PanelState& state) {
    if (is_stage_picture(state.view)) {
        const std::string name = free_name(stem, ".png");
        io::write_png(name, stage_.width, stage_.height, stage_.rgb);
        return name;
    }
    const std::string name = free_name(stem, ending);
    write_picture(name, renderer_, scene, camera, state.look, draw_options(state),
                  options_.samples.value_or(kSamples));
    return name;
}

}  // namespace ocean::app
