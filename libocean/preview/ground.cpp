// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ground.hpp"

#include <algorithm>
#include <cmath>

#include "filter_taps.hpp"
#include "view_table.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

/// Cells of the finest level along a texel: patches are curved within one.
constexpr double kCellsOfTexel = 8.0;

/// Returns how far the ground is from height 0, and where it ends: the highest summit beyond the
/// horizon of an eye over the lowest ground.
Reach reach_of(const ShownLand& land, double eye_height) {
    using wave::double_precision::horizon_distance;
    const auto [low, high] = land.heights;
    return {.sideways = 0.0,
            .up = std::max({std::abs(low), std::abs(high), 0.1}),
            .farthest = 1.05 * (horizon_distance(eye_height - low) + horizon_distance(high - low)) +
                        land.image->period};
}

}  // namespace

std::string ground_defines(int taps) {
    return "#define TAPS " + std::to_string(taps) + "\n" + view_defines(SceneKind::land);
}

Ground::Ground(const RendererOptions& options)
    : taps_(filter_taps(options)),
      shadow_steps_(options.shadow_steps),
      clipmap_(options.land_cells),
      lines_(std::min(options.cells, options.land_cells)),
      program_(
          {{GL_VERTEX_SHADER, "preview/ground.vert"}, {GL_FRAGMENT_SHADER, "preview/ground.frag"}},
          ground_defines(taps_)),
      sampler_(make_footprint_sampler(taps_)),
      block_(BlockBinding::land) {}

double Ground::farthest(const PictureFrame& frame) const {
    return reach_of(*land_, frame.camera.eye[2]).farthest;
}

void Ground::draw(const PictureFrame& frame) {
    const Camera& camera = frame.camera;
    block_.set(make_land_block(*land_, camera, frame.look, frame.options, shadow_steps_));
    program_.use();
    PictureFrame::attach(program_.name());
    attach_block(program_.name(), "LandBlock", BlockBinding::land);
    TextureUnits units(PictureFrame::kSkyUnit + 1);
    units.bind(program_, "ground_map", GL_TEXTURE_2D, land_->texture, sampler_.name());
    // No ground is nearer than the highest summit below the eye.
    const double clearance = std::max(camera.eye[2] - land_->heights[1], 0.0);
    const bool only_lines = frame.options.wireframe;
    const Clipmap& mesh = only_lines ? lines_ : clipmap_;
    mesh.draw(program_, glm::dvec3(camera.eye[0], camera.eye[1], clearance),
              std::exp2(std::floor(std::log2(texel_of(*land_) / kCellsOfTexel))),
              Frustum(frame.projection.clip_from_world, camera.eye[2]),
              reach_of(*land_, camera.eye[2]), only_lines);
}

}  // namespace ocean::preview
