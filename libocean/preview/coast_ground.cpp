// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast_ground.hpp"

#include <algorithm>
#include <cmath>

#include "ground.hpp"
#include "texture_units.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {

CoastBlock make_coast_block(const DrawnCoast& coast, const Camera& camera) {
    CoastBlock block;
    for (std::size_t w = 0; w < coast.windows.size(); ++w) {
        const CoastWindow& window = coast.windows[w].window;
        const auto place = [&](std::size_t axis) {
            return camera.eye[axis] / window.cell - static_cast<double>(window.corner[axis]);
        };
        block.window[w] = glm::vec4(place(0), place(1), 1.0 / window.cell, window.samples);
    }
    const Domain& area = coast.area;
    const double west = area.origin[0] - camera.eye[0], south = area.origin[1] - camera.eye[1];
    block.edge = glm::vec4(west, south, west + area.size[0], south + area.size[1]);
    block.count = glm::ivec4(static_cast<int>(coast.windows.size()), coast.bed ? 1 : 0, 0, 0);
    return block;
}

using wave::double_precision::horizon_distance;

void bind_coast(gl::ShaderProgram& program, TextureUnits& units, const DrawnCoast& coast,
                GLuint sampler) {
    units.bind(program, "coast_shapes", GL_TEXTURE_2D_ARRAY, coast.shape);
    units.bind(program, "coast_traces", GL_TEXTURE_2D_ARRAY, coast.traces, sampler);
    units.bind(program, "coast_gradients", GL_TEXTURE_2D_ARRAY, coast.gradients, sampler);
    units.bind(program, "coast_moments", GL_TEXTURE_2D_ARRAY, coast.moments, sampler);
}

CoastGround::CoastGround(const RendererOptions& options)
    : shadow_steps_(options.shadow_steps),
      program_(
          {{GL_VERTEX_SHADER, "preview/bed.vert"}, {GL_FRAGMENT_SHADER, "preview/ground.frag"}},
          ground_defines(filter_taps(options), true)),
      ground_sampler_(make_footprint_sampler(filter_taps(options))),
      sampler_(make_footprint_sampler(filter_taps(options))),
      land_block_(BlockBinding::land),
      coast_block_(BlockBinding::coast) {
    glSamplerParameteri(ground_sampler_.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(ground_sampler_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

double CoastGround::farthest(const DrawnCoast& coast, const PictureFrame& frame) {
    const double highest = coast.bed ? std::max(coast.ground.heights[1], 0.1) : coast.highest;
    return 1.05 * (horizon_distance(frame.camera.eye[2]) + horizon_distance(highest));
}

void CoastGround::prepare(const DrawnCoast& coast, const PictureFrame& frame) {
    coast_block_.set(make_coast_block(coast, frame.camera));
    if (!coast.bed) return;
    land_block_.set(make_land_block(coast.ground, {}, frame, shadow_steps_));
}

void CoastGround::draw(const DrawnCoast& coast, const PictureFrame& frame, const Clipmap& mesh,
                       const glm::dvec3& eye, double finest) {
    program_.use();
    PictureFrame::attach(program_.name());
    attach_block(program_.name(), "LandBlock", BlockBinding::land);
    attach_block(program_.name(), "CoastBlock", BlockBinding::coast);
    TextureUnits units(PictureFrame::kSkyUnit + 1);
    units.bind(program_, "ground_map", GL_TEXTURE_2D, coast.ground.texture, ground_sampler_.name());
    units.bind(program_, "mask_map", GL_TEXTURE_2D, coast.ground.masks, ground_sampler_.name());
    units.bind(program_, "coast_shapes", GL_TEXTURE_2D_ARRAY, coast.shape);
    units.bind(program_, "coast_traces", GL_TEXTURE_2D_ARRAY, coast.traces, sampler_.name());
    const double up =
        std::max(std::abs(coast.ground.heights[0]), std::abs(coast.ground.heights[1]));
    mesh.draw(program_, eye, finest, Frustum(frame.projection.clip_from_world, frame.camera.eye[2]),
              {.sideways = 0.0, .up = up + 0.1, .farthest = farthest(coast, frame)},
              frame.options.wireframe);
}

}  // namespace ocean::preview
