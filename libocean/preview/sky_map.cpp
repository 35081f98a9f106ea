// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "sky_map.hpp"

namespace ocean::preview {
namespace {

gl::Texture make_texture(int width, int height, const float* rgb) {
    gl::Texture texture = gl::generate<gl::Texture, &glGenTextures>();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, width, height, 0, GL_RGB, GL_FLOAT, rgb);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

gl::Texture black() {
    constexpr float kBlack[] = {0.0f, 0.0f, 0.0f};
    return make_texture(1, 1, kBlack);
}

}  // namespace

SkyMap::SkyMap() : texture_(black()) {}

void SkyMap::hold(const std::shared_ptr<const Environment>& environment) {
    if (environment == held_) return;
    texture_ = environment
                   ? make_texture(environment->width, environment->height, environment->rgb.data())
                   : black();
    held_ = environment;
}

}  // namespace ocean::preview
