// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures of patches: heights, a patch in each row, and slopes, a patch in each layer.
#pragma once

#include <cstdint>

#include "ocean/internal/gl/objects.hpp"
#include "patch_slots.hpp"

namespace ocean::preview {

/// The heights of make_patch_heights().
class PatchRows {
  public:
    /// vertices: of a patch.
    explicit PatchRows(int vertices);
    /// Uploads a patch. A patch for which there is no room is left out.
    void add(const PatchMaker::Made& made);

    GLuint texture() const { return texture_.name(); }
    std::uint64_t bytes() const;
    PatchSlots slots;

  private:
    int vertices_;
    gl::Texture texture_;
};

/// The slopes of make_patch_slopes(). Their texture is made for the first patch.
class PatchLayers {
  public:
    /// side: of the finest mipmap [texels].
    explicit PatchLayers(int side);
    void add(const PatchMaker::Made& made);

    /// Returns 0 while there are no patches.
    GLuint texture() const { return texture_.name(); }
    std::uint64_t bytes() const;
    PatchSlots slots;

  private:
    void make_texture();

    int side_;
    gl::Texture texture_;
};

}  // namespace ocean::preview
