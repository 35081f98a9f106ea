// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "uploaded_maps.hpp"

#include "ocean/internal/cascades.hpp"
#include "ocean/internal/gl/textures.hpp"

namespace ocean::preview {

UploadedCascades::UploadedCascades(int resolution, std::size_t cascades)
    : resolution_(resolution),
      cascades_(cascades),
      displacement_(array()),
      gradients_(array()),
      moments_(array()),
      displacement_image_(texels()),
      gradients_image_(texels()),
      moments_image_(texels()) {}

void UploadedCascades::make(OpenSea& sea, double time) {
    for (std::size_t c = 0; c < cascades_; ++c) make_layer(sea, time, c);
    for (const gl::Texture* texture : {&displacement_, &gradients_, &moments_}) {
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture->name());
        glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    }
}

void UploadedCascades::make_layer(OpenSea& sea, double time, std::size_t cascade) {
    using enum Linear;
    MapOutput outputs[2] = {{displacement_image_.data(), 4, {}}, {gradients_image_.data(), 4, {}}};
    outputs[0].component = {{{displacement_x}, {displacement_y}, {height}, {gradient_xy}}};
    outputs[1].component = {{{slope_x}, {slope_y}, {gradient_xx}, {gradient_yy}}};
    sea.evaluate_cascade_into(cascade, time, outputs, resolution_);
    for (std::size_t i = 0; i < gradients_image_.size(); i += 4) {
        const float* g = &gradients_image_[i];
        float* m = &moments_image_[i];
        m[0] = g[0] * g[0];
        m[1] = g[1] * g[1];
        m[2] = g[0] * g[1];
        m[3] = (g[2] + g[3]) * (g[2] + g[3]);
    }
    const auto layer = static_cast<GLint>(cascade);
    upload(displacement_, layer, displacement_image_);
    upload(gradients_, layer, gradients_image_);
    upload(moments_, layer, moments_image_);
}

gl::Texture UploadedCascades::array() const {
    return gl::make_texture_array(GL_RGBA32F, resolution_, static_cast<int>(cascades_),
                                  gl::Mipmaps::yes);
}

void UploadedCascades::upload(const gl::Texture& texture, int layer,
                              const std::vector<float>& image) const {
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, resolution_, resolution_, 1, GL_RGBA,
                    GL_FLOAT, image.data());
}

void UploadedMaps::show(OpenSea& sea, double time) {
    glActiveTexture(GL_TEXTURE0);
    const int foam_resolution =
        foam_resolution_ > 0 ? foam_resolution_ : default_map_resolution(sea.parameters().grid);
    find_threshold(sea, time, foam_resolution);
    const Modes& modes = sea.modes(time);
    // All cascades have the resolution of the sea's grid.
    const std::size_t count = modes.cascades.size();
    const int resolution =
        cascade_resolution_ > 0 ? cascade_resolution_ : modes.cascades.front().lattice.resolution;
    if (!cascades_ || !cascades_->fits(resolution, count)) cascades_.emplace(resolution, count);
    cascades_->make(sea, time);
    if (after_stage_) after_stage_("cascades");
    make_foam(sea, time, foam_resolution);
    if (after_stage_) after_stage_("foam");
}

/// Sets the threshold of the whitecaps of a map of so many samples.
void UploadedMaps::find_threshold(OpenSea& sea, double time, int resolution) {
    const Modes& modes = sea.modes(time);
    const SurfaceSettings settings = sea.sea().at(time).surface;
    if (modes.revision == threshold_revision_ && settings == given_) return;
    const SurfaceSettings found = with_threshold(settings, modes, resolution);
    foam_.threshold = found.foam_threshold;
    foam_.width = found.foam_width;
    threshold_revision_ = modes.revision;
    given_ = settings;
}

void UploadedMaps::make_foam(OpenSea& sea, double time, int resolution) {
    foam_.lattice = foam_lattice(sea.parameters(), resolution);
    const int side = foam_.lattice.resolution;
    foam_image_.resize(Lattice{side, 1.0}.size());
    sea.lattice_foam_into(time, foam_.lattice, foam_image_);
    if (!foam_texture_ || side != texture_resolution_) {
        foam_texture_ = gl::make_texture(GL_R32F, side);
        texture_resolution_ = side;
    }
    foam_.texture = foam_texture_.name();
    glBindTexture(GL_TEXTURE_2D, foam_.texture);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, side, side, GL_RED, GL_FLOAT, foam_image_.data());
}

}  // namespace ocean::preview
