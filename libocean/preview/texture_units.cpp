// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "texture_units.hpp"

#include "ocean/internal/gl/context.hpp"

namespace ocean::preview {

/// llvmpipe 22.3 does not come back from compiling its own filter of long footprints.
int filter_taps(const RendererOptions& options) {
    if (options.taps > 0) return options.taps;
    const bool fits =
        epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") || epoxy_gl_version() >= 46;
    return fits && !gl::context_info().software ? 0 : 2;
}

gl::Sampler make_footprint_sampler(int taps) {
    gl::Sampler sampler = gl::generate<gl::Sampler, &glGenSamplers>();
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    if (taps == 0) glSamplerParameterf(sampler.name(), GL_TEXTURE_MAX_ANISOTROPY_EXT, 16.0f);
    return sampler;
}

}  // namespace ocean::preview
