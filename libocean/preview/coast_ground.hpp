// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bed of a coast as ground under its water: on the lattice of the water's vertices, so that
// both end in one line.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "clipmap.hpp"
#include "drawable.hpp"
#include "land_block.hpp"
#include "ocean/internal/preview/coast_maps.hpp"
#include "ocean/internal/preview/picture.hpp"
#include "texture_units.hpp"

namespace ocean::preview {

/// The uniform block of shaders/preview/coast_block.glsl, which says what each value is.
struct CoastBlock {
    std::array<glm::vec4, kMaxWindows> window{};
    glm::vec4 edge{};
    glm::ivec4 count{};
};
static_assert(sizeof(CoastBlock) == (kMaxWindows + 2) * 16, "std140 has no other padding");

CoastBlock make_coast_block(const DrawnCoast& coast, const Camera& camera);

/// Binds the windows of a coast for the current program, which uses `sampler` for their means.
void bind_coast(gl::ShaderProgram& program, TextureUnits& units, const DrawnCoast& coast,
                GLuint sampler);

class CoastGround {
  public:
    explicit CoastGround(const RendererOptions& options);

    /// Returns the distance beyond which no ground of the coast is seen [m].
    static double farthest(const DrawnCoast& coast, const PictureFrame& frame);
    /// Sets the values of a picture, for the water's program too.
    void prepare(const DrawnCoast& coast, const PictureFrame& frame);
    /// Draws the ground of that picture. mesh, eye, finest: those of the water.
    void draw(const DrawnCoast& coast, const PictureFrame& frame, const Clipmap& mesh,
              const glm::dvec3& eye, double finest);

  private:
    int shadow_steps_;
    gl::ShaderProgram program_;
    gl::Sampler ground_sampler_, sampler_;
    UniformBlock<LandBlock> land_block_;
    UniformBlock<CoastBlock> coast_block_;
};

}  // namespace ocean::preview
