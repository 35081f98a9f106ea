// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ground.hpp"

#include <cmath>

#include "texture_units.hpp"
#include "view_table.hpp"

namespace ocean::preview {
namespace {

constexpr int kWaterCells = 32;      // of a level of the water's mesh, which is flat
constexpr double kWaterCell = 0.25;  // the finest [m]

/// Returns the bytes of the maps of a land, with their mipmaps.
std::uint64_t map_bytes(const DrawnLand& land) {
    constexpr std::uint64_t kTexel = 4 * sizeof(float), kMasks = 4;
    const auto side = static_cast<std::uint64_t>(land.image->resolution);
    return side * side * (kTexel + (land.has_masks ? kMasks : 0)) / 3 * 4;
}

}  // namespace

std::string ground_defines(int taps, bool coast) {
    return "#define TAPS " + std::to_string(taps) + "\n#define COAST " + (coast ? "1" : "0") +
           "\n" + view_defines(SceneKind::land);
}

Ground::Ground(const RendererOptions& options)
    : taps_(filter_taps(options)),
      shadow_steps_(options.shadow_steps),
      patches_(options),
      water_(kWaterCells),
      program_(
          {{GL_VERTEX_SHADER, "preview/ground.vert"}, {GL_FRAGMENT_SHADER, "preview/ground.frag"}},
          ground_defines(taps_)),
      water_program_({{GL_VERTEX_SHADER, "preview/land_water.vert"},
                      {GL_FRAGMENT_SHADER, "preview/land_water.frag"}},
                     ground_defines(taps_)),
      sampler_(make_footprint_sampler(taps_)),
      block_(BlockBinding::land) {}

void Ground::show(const DrawnLand& land) {
    land_ = &land;
    map_bytes_ = map_bytes(land);
    patches_.show(land);
    const GLint wrap = land.image->wraps ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glSamplerParameteri(sampler_.name(), GL_TEXTURE_WRAP_S, wrap);
    glSamplerParameteri(sampler_.name(), GL_TEXTURE_WRAP_T, wrap);
}

double Ground::farthest(const PictureFrame& frame) const {
    return patches_.farthest(frame.camera.eye[2]);
}

LandStatistics Ground::statistics() const {
    LandStatistics statistics = patches_.statistics();
    statistics.resident_bytes += map_bytes_;
    return statistics;
}

void Ground::bind_maps(gl::ShaderProgram& program, TextureUnits& units) {
    PictureFrame::attach(program.name());
    attach_block(program.name(), "LandBlock", BlockBinding::land);
    units.bind(program, "ground_map", GL_TEXTURE_2D, land_->texture, sampler_.name());
    units.bind(program, "mask_map", GL_TEXTURE_2D, land_->masks, sampler_.name());
}

void Ground::draw(const PictureFrame& frame) {
    const DrawnLattice lattice = patches_.choose(frame);
    block_.set(make_land_block(*land_, lattice, frame, shadow_steps_));
    // Water first: it hides its bed.
    if (land_->water_level && frame.options.view == View::shaded) draw_water(frame);
    program_.use();
    TextureUnits units(PictureFrame::kSkyUnit + 1);
    bind_maps(program_, units);
    units.bind(program_, "patch_heights", GL_TEXTURE_2D, patches_.heights());
    units.bind(program_, "detail_map", GL_TEXTURE_2D_ARRAY, patches_.slopes());
    patches_.draw();
}

void Ground::draw_water(const PictureFrame& frame) {
    const Camera& camera = frame.camera;
    const double over = camera.eye[2] - *land_->water_level;
    water_program_.use();
    TextureUnits units(PictureFrame::kSkyUnit + 1);
    bind_maps(water_program_, units);
    water_.draw(
        water_program_, glm::dvec3(camera.eye[0], camera.eye[1], over), kWaterCell,
        Frustum(frame.projection.clip_from_world, camera.eye[2]),
        {.sideways = 0.0, .up = std::abs(*land_->water_level) + 0.1, .farthest = farthest(frame)},
        frame.options.wireframe);
}

}  // namespace ocean::preview
