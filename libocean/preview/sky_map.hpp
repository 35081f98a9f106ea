// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An environment as the texture of shaders/preview/sky.glsl.
#pragma once

#include <memory>

#include "ocean/gl/objects.hpp"
#include "ocean/preview/environment.hpp"

namespace ocean::preview {

class SkyMap {
  public:
    SkyMap();
    /// Uploads it, but where it is the one of before; none: a texel of black.
    void hold(const std::shared_ptr<const Environment>& environment);
    unsigned texture() const { return texture_.name(); }

  private:
    std::shared_ptr<const Environment> held_;
    gl::Texture texture_;
};

}  // namespace ocean::preview
