// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lands, and the vertices of their pictures as the GPU shows them.
#pragma once

#include <string>
#include <vector>

#include "ground.hpp"
#include "ocean/internal/preview/canvas.hpp"
#include "ocean/internal/preview/renderer.hpp"
#include "ocean/terrain_model.hpp"
#include "shader_text.hpp"

namespace ocean::preview {

inline TerrainModel hills() {
    TerrainModel terrain;
    terrain.resolution = 128;
    terrain.patch_size = 4096.0;
    terrain.rms = 120.0;
    return terrain;
}

inline TerrainModel gullied() {
    TerrainModel terrain = hills();
    terrain.gullies.depth = 0.05;
    terrain.gullies.longest = 900.0;
    return terrain;
}

inline TerrainModel island() {
    TerrainModel terrain = hills();
    terrain.kind = TerrainKind::placed;
    terrain.patch_size = 4000.0;  // not a whole number of patches
    terrain.mean = 150.0;
    terrain.island = 500.0;
    terrain.coast.beach_slope = 1.0 / 30.0;
    return terrain;
}

/// A vertex as the GPU shows it.
struct GpuVertex {
    float position[3];  // relative to the eye's place at height 0 [m]
    float label[2];     // where it stands
    float index[3];     // in spacings of level 0 from the snapped eye; its level
    float place[3];     // where it stands in its node, 0 .. 1; the share of the next level
};

/// Reads the vertices of the last picture back: they are drawn once more, by the vertex shader of
/// the ground with the bindings that the picture has left.
class VertexReader {
  public:
    VertexReader() {
        std::string text = gl::program_text(gl::load_shader("preview/ground.vert"),
                                            ground_defines(2), GL_VERTEX_SHADER);
        const std::string main = "void main() {";
        text.replace(text.find(main), main.size(),
                     "out vec3 own_index;\n" + main +
                         "own_index = vec3(place.xy + (corner + grid) * (1 << place.z), place.z);");
        const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
        const char* const words = text.c_str();
        glShaderSource(shader, 1, &words, nullptr);
        glCompileShader(shader);
        program_ = gl::Program(glCreateProgram());
        glAttachShader(program_.name(), shader);
        const char* const names[] = {"position", "label", "own_index", "detail_place"};
        glTransformFeedbackVaryings(program_.name(), 4, names, GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(program_.name());
        glDeleteShader(shader);
        buffer_ = gl::make_buffer();
    }

    std::vector<GpuVertex> read(const LandStatistics& mesh, GLint heights_unit) {
        const std::size_t count = 3 * mesh.triangles;
        canvas_.bind();
        glUseProgram(program_.name());
        PictureFrame::attach(program_.name());
        attach_block(program_.name(), "LandBlock", BlockBinding::land);
        glUniform1i(glGetUniformLocation(program_.name(), "patch_heights"), heights_unit);
        glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer_.name());
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER,
                     static_cast<GLsizeiptr>(count * sizeof(GpuVertex)), nullptr, GL_STREAM_READ);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_.name());
        glEnable(GL_RASTERIZER_DISCARD);
        glBeginTransformFeedback(GL_TRIANGLES);
        constexpr int kIndices = 8 * 8 * 6;  // of a quarter
        glDrawElementsInstanced(GL_TRIANGLES, kIndices, GL_UNSIGNED_SHORT, nullptr,
                                static_cast<GLsizei>(count / kIndices));
        glEndTransformFeedback();
        glDisable(GL_RASTERIZER_DISCARD);
        std::vector<GpuVertex> vertices(count);
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0,
                           static_cast<GLsizeiptr>(count * sizeof(GpuVertex)), vertices.data());
        return vertices;
    }

  private:
    Canvas canvas_{16, 16, GL_RGBA8};
    gl::Program program_;
    gl::Buffer buffer_;
};

}  // namespace ocean::preview
