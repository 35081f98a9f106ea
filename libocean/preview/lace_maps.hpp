// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The textures of the foam's pattern, ocean/internal/foam_texture.hpp, for pixels of any size.
// Means of their values tend to 1/2, so that foam of a small cover would vanish before its pattern
// does. Each level of the mipmaps therefore has a table of the share of its reads below a value,
// which makes the reads uniform in [0, 1] again.
#pragma once

#include <array>
#include <future>
#include <utility>
#include <vector>

#include "ocean/internal/foam_texture.hpp"
#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/preview/renderer.hpp"
#include "ocean/internal/preview/sea_maps.hpp"

namespace ocean::preview {

inline constexpr int kLaceShares = 1024;  // values of a table, for reads of 0 .. 1
inline constexpr int kMaxLaceLevels = 8;

/// A level of the mipmaps and its table.
struct LaceLevel {
    int size;                   // texels a side
    std::vector<float> means;   // size^2 means of the finest level
    std::vector<float> shares;  // share of the bilinear reads below i / (kLaceShares - 1)
};
/// Returns the levels of a texture, the finest first, down to 32 texels a side.
std::vector<LaceLevel> lace_levels(const FoamTextureSettings& settings, ThreadPool& pool);

/// The levels of each kind of texture.
using LaceTextures = std::array<std::vector<LaceLevel>, kFoamTextures.size()>;
/// Returns the levels that pictures show, all zero.
LaceTextures empty_lace();

class LaceMaps {
  public:
    /// waits: the first call of ready() makes the textures itself, half a second on two cores; else
    /// another thread makes them. kept: those of an earlier run.
    LaceMaps(bool waits, KeptTextures kept) : waits_(waits), kept_(std::move(kept)) {}

    /// Returns whether the textures are ready; the first call begins to make them.
    bool ready();
    /// Returns whether another thread is making them, or has them ready for the next call of
    /// ready().
    Pending pending() const;
    unsigned texture(FoamTextureKind kind) const {
        return textures_[static_cast<std::size_t>(kind)].name();
    }
    /// Returns the texture of the tables: kMaxLaceLevels rows for each texture of a pattern.
    unsigned shares() const { return shares_.name(); }

  private:
    static LaceTextures make(int threads, const KeptTextures& kept);

    bool waits_;
    KeptTextures kept_;
    bool ready_ = false;
    std::future<LaceTextures> making_;
    std::array<gl::Texture, kFoamTextures.size()> textures_;
    gl::Texture shares_;
};

}  // namespace ocean::preview
