// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A picture: the values that all drawables share, the sky, then the drawables in front of it.
#include "ocean/internal/preview/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "drawable.hpp"
#include "frame_block.hpp"
#include "ground.hpp"
#include "ocean/error.hpp"
#include "sky_map.hpp"
#include "view_table.hpp"
#include "water.hpp"

namespace ocean::preview {

struct Renderer::Impl {
    explicit Impl(const RendererOptions& its_options)
        : options(its_options),
          frame_block(BlockBinding::frame),
          sky({{GL_VERTEX_SHADER, "preview/sky.vert"}, {GL_FRAGMENT_SHADER, "preview/sky.frag"}},
              ""),
          no_vertices(gl::make_vertex_array()),
          water(options) {}

    RendererOptions options;
    UniformBlock<FrameBlock> frame_block;
    gl::ShaderProgram sky;
    SkyMap sky_map;
    gl::VertexArray no_vertices;
    std::vector<std::shared_ptr<Drawable>> added;
    Water water;
    std::optional<Ground> ground;  // made for the first picture of land
    bool shows_land = false;       // the last picture does

    void done(std::string_view stage) const {
        if (options.after_stage) options.after_stage(stage);
    }

    void bind_frame(const Drawable& subject, const PictureFrame& frame) {
        double farthest = subject.farthest(frame);
        for (const auto& drawable : added) {
            farthest = std::max(farthest, drawable->farthest(frame));
        }
        FrameBlock block =
            make_frame_block(frame.camera, frame.look, frame.options, frame.projection, farthest);
        block.view.y = &subject == &water ? 1 : 0;
        frame_block.set(block);
        sky_map.hold(frame.look.environment);
        glActiveTexture(GL_TEXTURE0 + PictureFrame::kSkyUnit);
        glBindTexture(GL_TEXTURE_2D, sky_map.texture());
        glBindSampler(PictureFrame::kSkyUnit, 0);
    }

    static void clear(const PictureFrame& frame) {
        glViewport(0, 0, frame.options.width, frame.options.height);
        glDisable(GL_BLEND);
        glDisable(GL_CULL_FACE);
        glDepthMask(GL_TRUE);
        const bool fog = is_seed(frame.look, frame.options);
        const glm::vec4 behind = fog ? glm::vec4(kSeedFog, 1.0f) : glm::vec4(0.0f);
        glClearColor(behind.r, behind.g, behind.b, behind.a);
        glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
    }

    void draw_sky() {
        glDisable(GL_DEPTH_TEST);
        sky.use();
        PictureFrame::attach(sky.name());
        glBindVertexArray(no_vertices.name());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        done("sky");
    }

    void draw_scene(Drawable& subject, const PictureFrame& frame) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        if (frame.options.wireframe) {
            glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            glEnable(GL_BLEND);
            glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE,
                                GL_ONE_MINUS_SRC_ALPHA);
        }
        for (const auto& drawable : added) drawable->draw(frame);
        subject.draw(frame);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        glDisable(GL_BLEND);
    }

    /// subject: the water or the ground, whose name is `stage`.
    void draw(Drawable& subject, const char* stage, const PictureFrame& frame, bool has_sky) {
        bind_frame(subject, frame);
        clear(frame);
        if (has_sky && !is_seed(frame.look, frame.options)) draw_sky();
        draw_scene(subject, frame);
        done(stage);
        if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
            throw Error(ErrorKind::no_gpu,
                        "OpenGL error " + std::to_string(error) + " while drawing the " + stage);
        }
    }

    void draw(const DrawnSea& sea, const PictureFrame& frame, bool has_sky) {
        water.show(sea);
        shows_land = false;
        draw(water, "water", frame, has_sky);
    }

    void draw(const DrawnLand& land, const PictureFrame& frame, bool has_sky) {
        if (row_of(frame.options.view).glsl_of(SceneKind::land).empty()) {
            throw Error(ErrorKind::invalid_value,
                        "land has no view " + std::string(word_of(frame.options.view)));
        }
        if (!ground) ground.emplace(options);
        ground->show(land);
        shows_land = true;
        if (frame.look.kind == LookKind::physical) return draw(*ground, "land", frame, has_sky);
        Look physical = frame.look;  // land has no other look
        physical.kind = LookKind::physical;
        draw(*ground, "land", {frame.camera, physical, frame.options, frame.projection}, has_sky);
    }

    template <typename Shown>
    void draw_perspective(const Shown& shown, const Camera& camera, const Look& look,
                          const DrawOptions& draw_options) {
        const Projection projection = perspective(camera, draw_options.width, draw_options.height);
        draw(shown, PictureFrame{camera, look, draw_options, projection},
             row_of(draw_options.view).use == ViewUse::picture);
    }
};

Renderer::Renderer(const RendererOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Renderer::~Renderer() = default;

void Renderer::add(std::shared_ptr<Drawable> drawable) {
    impl_->added.push_back(std::move(drawable));
}

Pending Renderer::pending() const {
    return impl_->shows_land ? impl_->ground->pending() : impl_->water.pending();
}

LandStatistics Renderer::land_statistics() const {
    return impl_->ground ? impl_->ground->statistics() : LandStatistics{};
}

LeftOut Renderer::left_out() const {
    return impl_->water.left_out();
}

void Renderer::draw(const DrawnSea& sea, const Camera& camera, const Look& look,
                    const DrawOptions& options) {
    impl_->draw_perspective(sea, camera, look, options);
}

void Renderer::draw(const DrawnLand& land, const Camera& camera, const Look& look,
                    const DrawOptions& options) {
    impl_->draw_perspective(land, camera, look, options);
}

void Renderer::draw_from_above(const DrawnSea& sea, const Camera& camera, double x, double y,
                               double metres, const DrawOptions& options) {
    const Look look;
    const Projection projection = from_above(camera, x, y, metres, sea.significant_wave_height);
    impl_->draw(sea, {camera, look, options, projection}, false);
}

void Renderer::draw_from_above(const DrawnLand& land, const Camera& camera, double x, double y,
                               double metres, const DrawOptions& options) {
    const Look look;
    const double highest = std::max(std::abs(land.heights[0]), std::abs(land.heights[1]));
    const Projection projection = from_above(camera, x, y, metres, highest);
    impl_->draw(land, {camera, look, options, projection}, false);
}

std::string text(const LeftOut& left_out) {
    if (!left_out.foam_pattern && !left_out.near_detail) return "";
    const std::string parts =
        left_out.foam_pattern && left_out.near_detail
            ? "the pattern of the foam and near detail are"
            : (left_out.near_detail ? "near detail is" : "the pattern of the foam is");
    return parts + " left out: the water needs " + std::to_string(left_out.required_units) +
           " texture units in a fragment shader; this driver has " +
           std::to_string(left_out.available_units);
}

}  // namespace ocean::preview
