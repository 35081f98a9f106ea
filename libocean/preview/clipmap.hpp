// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The mesh of the water: nested levels of a square grid around the eye, each twice as coarse as the
// one inside it. A level stands on a lattice of its own that never moves, and is morphed into the
// next one where it ends [Losasso and Hoppe 2004], so that water neither swims nor jumps.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "ocean/gl/objects.hpp"
#include "ocean/gl/shader_program.hpp"

namespace ocean::preview {

/// What of the world is in the picture; planes point inwards, relative to the eye's place on the
/// still water.
struct Frustum {
    std::array<glm::dvec4, 4> planes;  // the sides alone

    /// Of a matrix from places relative to the eye.
    Frustum(const glm::mat4& clip_from_world, double eye_height);
    bool touches(const glm::dvec3& least, const glm::dvec3& most) const;
};

/// How far the surface may be from a label.
struct Reach {
    double sideways;  // m
    double up;        // m, and down
    double farthest;  // m, that is drawn
};

class Clipmap {
  public:
    /// cells: RendererOptions::cells.
    explicit Clipmap(int cells);

    /// Draws what the frustum touches, with the current program, whose uniforms `level` and `morph`
    /// it sets. finest: m, of a cell of the finest level, a power of two. Returns the triangles.
    std::size_t draw(gl::ShaderProgram& program, const glm::dvec3& eye, double finest,
                     const Frustum& frustum, const Reach& reach) const;

  private:
    /// Squares of 1/8 of a level's side, which are drawn or left out.
    static constexpr int kBlocks = 8;
    struct Block {
        int first_index = 0;
        int indices = 0;
    };
    using Blocks = std::array<Block, kBlocks * kBlocks>;

    /// A level with a hole for the level inside it, whose centre is (x, y) cells from its own; the
    /// innermost one has none.
    Blocks add_blocks(std::vector<unsigned>& indices, bool hole, int x, int y) const;

    int cells_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    gl::VertexArray array_;
    Blocks whole_;
    std::array<Blocks, 4> ring_;  // x + 2 y
};

}  // namespace ocean::preview
