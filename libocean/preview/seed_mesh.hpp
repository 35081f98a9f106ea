// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The mesh of the look `seed`: one square grid, drawn as tiles beside each other.
#pragma once

#include <glm/glm.hpp>
#include <map>

#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/gl/shader_program.hpp"
#include "water_program.hpp"

namespace ocean::preview {

class SeedMesh {
  public:
    /// Draws the tiles with the current program and sets its uniform `tiles`. period: side of a
    /// tile [m]. finest: side of the sea's finest texel [m], and of the smallest cell.
    void draw(gl::ShaderProgram& program, const glm::dvec3& eye, double period, double finest);

  private:
    struct Tile {
        gl::Buffer vertices, indices;
        gl::VertexArray array;
        GLsizei count = 0;
    };
    static Tile make_tile(int cells);

    std::map<int, Tile> tiles_;  // by the cells along a side
};

}  // namespace ocean::preview
