// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "cover_map.hpp"

#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/gl/textures.hpp"

namespace ocean::preview {

CoverMap::CoverMap()
    : program_({{GL_VERTEX_SHADER, "preview/sky.vert"}, {GL_FRAGMENT_SHADER, "preview/cover.frag"}},
               ""),
      no_vertices_(gl::make_vertex_array()),
      framebuffer_(gl::make_framebuffer()) {}

void CoverMap::make(unsigned foam, int resolution, float fade, double power) {
    if (!map_ || resolution != resolution_) {
        map_ = gl::make_texture(GL_RGBA16F, resolution, gl::Mipmaps::yes);
        resolution_ = resolution;
    }
    GLint viewport[4] = {};
    GLint framebuffer = 0;
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, map_.name(),
                           0);
    glViewport(0, 0, resolution, resolution);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    program_.use();
    program_.set("foam_map", 0);
    program_.set("fade", fade);
    program_.set("cover_power", static_cast<float>(power));
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, 0);
    glBindTexture(GL_TEXTURE_2D, foam);
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    glBindTexture(GL_TEXTURE_2D, map_.name());
    glGenerateMipmap(GL_TEXTURE_2D);
}

}  // namespace ocean::preview
