// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures of patches: heights, a patch in each row, and slopes, a patch in each layer.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "ocean/internal/gl/objects.hpp"
#include "patch_maker.hpp"

namespace ocean::preview {

/// Which patches are resident, and where: the ones that were not drawn for longest make room for
/// new ones.
class PatchSlots {
  public:
    explicit PatchSlots(int capacity);

    void clear();
    /// Begins a picture: patches that none of its calls holds may make room.
    void begin_picture() { ++picture_; }
    /// Returns true if the patch is resident, and keeps it for this picture.
    bool hold(const PatchKey& key);
    bool contains(const PatchKey& key) const { return slots_.contains(key); }
    /// Returns the slot of a patch, or nothing if it is not resident.
    std::optional<int> find(const PatchKey& key) const;
    /// Returns a slot for a patch, which is held; nothing if it has one or all others are held.
    std::optional<int> add(const PatchKey& key);
    int capacity() const { return capacity_; }

  private:
    void make_room();

    int capacity_;
    std::unordered_map<PatchKey, int, PatchHash> slots_;
    std::vector<std::uint64_t> held_;  // the picture for which each slot was held last
    std::vector<int> free_;
    std::uint64_t picture_ = 1;
};

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
