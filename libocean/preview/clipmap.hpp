// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The mesh of water: nested levels of a square grid around the eye, each twice as coarse
// as the one inside it. A level stands on a lattice of its own that never moves, and is morphed
// into the next one where it ends [Losasso and Hoppe 2004], so that water neither swims nor jumps.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/gl/shader_program.hpp"

namespace ocean::preview {

/// The part of the world that is in the picture, by planes that point inwards, relative to the
/// eye's place on the still water.
struct Frustum {
    std::array<glm::dvec4, 4> planes;  // the four sides, without near and far

    /// clip_from_world: of positions relative to the eye. eye_height: over still water [m].
    Frustum(const glm::mat4& clip_from_world, double eye_height);
    /// Returns whether a box with these corners may be in the picture.
    bool touches(const glm::dvec3& min, const glm::dvec3& max) const;
};

/// The greatest distances of the surface from its labels, and of its end from the eye.
struct Reach {
    double sideways;  // [m]
    double up;        // [m], and down
    double farthest;  // [m] from the eye
};

class Clipmap {
  public:
    /// cells: RendererOptions::cells.
    explicit Clipmap(int cells);

    /// Draws the blocks that the frustum touches with the current program, and sets its uniforms
    /// `level` and `morph`. eye: its place, and the shortest distance of the surface from it.
    /// finest: side of a cell of the finest level [m], a power of two.
    /// only_lines: of a wireframe, whose lines fade before they fill the picture. Returns the
    /// number of triangles.
    std::size_t draw(gl::ShaderProgram& program, const glm::dvec3& eye, double finest,
                     const Frustum& frustum, const Reach& reach, bool only_lines = false) const;

  private:
    /// Blocks along a level's side: each is drawn or culled as a whole.
    static constexpr int kBlocks = 8;
    struct Block {
        int first_index = 0;
        int indices = 0;
    };
    using Blocks = std::array<Block, kBlocks * kBlocks>;

    /// Appends a level, with or without a hole for the level inside it, whose centre lies (x, y)
    /// cells from its own.
    Blocks add_blocks(std::vector<unsigned>& indices, bool hole, int x, int y) const;

    int cells_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    gl::VertexArray array_;
    Blocks whole_;
    std::array<Blocks, 4> ring_;  // x + 2 y
};

}  // namespace ocean::preview
