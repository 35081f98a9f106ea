// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The textures of foam in detail, ocean/foam_texture.hpp, for pixels of any size. A mean of their
// values is 1/2 everywhere in the end, and foam of a small cover would vanish before its pattern
// does: of each level of the mipmaps a table says what share of its reads is lower, and by that the
// reads are uniform in [0, 1] again.
#pragma once

#include <array>
#include <future>
#include <vector>

#include "ocean/foam_texture.hpp"
#include "ocean/gl/objects.hpp"
#include "ocean/preview/sea_maps.hpp"

namespace ocean::preview {

inline constexpr int kLaceShares = 1024;  // values of a table, of the reads 0 .. 1
inline constexpr int kMostLaceLevels = 8;

/// A mipmap and its table.
struct LaceLevel {
    int size;                   // texels a side
    std::vector<float> means;   // size^2, of the finest
    std::vector<float> shares;  // of bilinear reads below i / (kLaceShares - 1)
};
/// The finest first, down to 32 texels a side.
std::vector<LaceLevel> lace_levels(const FoamTextureSettings& settings, ThreadPool& pool);

class LaceMaps {
  public:
    /// waits: the first call of ready() makes them, half a second on two cores; else another
    /// thread.
    explicit LaceMaps(bool waits) : waits_(waits) {}

    /// Whether they are there; begins to make them.
    bool ready();
    /// Returns whether another thread makes them, or has and the next call of ready() takes them.
    Pending pending() const;
    unsigned texture(FoamTextureKind kind) const {
        return textures_[static_cast<std::size_t>(kind)].name();
    }
    /// kMostLaceLevels rows for each texture.
    unsigned shares() const { return shares_.name(); }

  private:
    using Levels = std::array<std::vector<LaceLevel>, kFoamTextures.size()>;
    static Levels make(int threads);

    bool waits_;
    bool ready_ = false;
    std::future<Levels> making_;
    std::array<gl::Texture, kFoamTextures.size()> textures_;
    gl::Texture shares_;
};

}  // namespace ocean::preview
