// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An environment as the texture of shaders/preview/sky.glsl.
#pragma once

#include <memory>

#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/preview/environment.hpp"

namespace ocean::preview {

class SkyMap {
  public:
    SkyMap();
    /// Uploads an environment unless it is already held; null: one black texel. Binds textures to
    /// the current unit.
    void hold(const std::shared_ptr<const Environment>& environment);
    unsigned texture() const { return texture_.name(); }

  private:
    std::shared_ptr<const Environment> held_;
    gl::Texture texture_;
};

}  // namespace ocean::preview
