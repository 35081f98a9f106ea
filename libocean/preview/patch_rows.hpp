// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Heights of patches in a texture, a patch in each row; the one that was not drawn for longest makes
// room for another.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "ocean/gl/objects.hpp"
#include "patch_maker.hpp"

namespace ocean::preview {

class PatchRows {
  public:
    /// vertices: of a patch.
    explicit PatchRows(int vertices);

    /// Forgets all patches.
    void clear();
    /// Returns true if the patch is resident, and keeps it for this picture.
    bool hold(const PatchKey& key);
    bool contains(const PatchKey& key) const { return rows_.contains(key); }
    /// Returns the row of a resident patch.
    int row(const PatchKey& key) const { return rows_.at(key); }
    /// Uploads a patch. A patch for which all rows are held is left out.
    void add(const PatchMaker::Made& made);
    /// Begins a picture: patches that none of its calls holds may make room.
    void begin_picture() { ++picture_; }

    GLuint texture() const { return texture_.name(); }
    std::uint64_t bytes() const;  // of all rows
    int capacity() const { return capacity_; }

  private:
    void make_room();

    int vertices_, capacity_;
    gl::Texture texture_;
    std::unordered_map<PatchKey, int, PatchHash> rows_;
    std::vector<std::uint64_t> held_;  // the picture for which each row was held last
    std::vector<int> free_;
    std::uint64_t picture_ = 1;
};

}  // namespace ocean::preview
