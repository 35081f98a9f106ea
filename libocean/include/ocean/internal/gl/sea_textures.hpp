// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as textures, for a renderer in the same context: the small map of each cascade, with
// mipmaps and second moments, and the foam of the whole patch. No data returns to the CPU.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "ocean/internal/foam.hpp"
#include "ocean/parameters.hpp"

namespace ocean {
class OpenSea;
}

namespace ocean::gl {

/// The maps of all cascades of a sea as array textures (GL_TEXTURE_2D_ARRAY), a layer for each
/// cascade. A layer has the components and mipmaps of a CascadeTextures.
struct CascadeArrays {
    int resolution = 0;  // texels along a side of each layer
    unsigned displacement = 0;
    unsigned gradients = 0;
    unsigned moments = 0;

    bool operator==(const CascadeArrays&) const = default;
};

/// The textures of one cascade, by name; SeaTextures owns them. All are RGBA float, N x N, repeat,
/// with mipmaps down to one texel; u = x / period. They share their texels with layers of
/// CascadeArrays.
struct CascadeTextures {
    double period = 0.0;  // [m]
    int resolution = 0;
    unsigned displacement = 0;  // Dx, Dy at choppiness 1, height [m]; dDx/dy
    unsigned gradients = 0;     // slope x, slope y, dDx/dx, dDy/dy
    /// Slope x ^ 2, slope y ^ 2, slope x * slope y, (dDx/dx + dDy/dy)^2. Their mipmaps minus the
    /// squared mipmaps of `gradients` are the variances within a texel: glitter, and whitecaps too
    /// small to be seen.
    unsigned moments = 0;
};

/// The foam of the patch. A map's foam is foam_with_whitecap(W, fade * texture, alone) of
/// wave/foam_cover.glsl, where W = surface_whitecap of the interpolated Jacobian must be computed
/// after the interpolation, since clamping and interpolation do not commute.
struct FoamTexture {
    unsigned texture = 0;    // one float per texel, of the whole patch; 0 = no foam yet
    int map_resolution = 0;  // of the map whose whitecaps lie over the foam
    FoamLattice lattice{};   // the lattice of the foam
    double period = 0.0;     // [m]
    float fade = 0.0f;
    float alone = 1.0f;
    float threshold = 0.0f;  // of the map's whitecaps
    float width = 0.0f;
};

/// Called with the name of a part of the work when its commands have been issued, for measurements.
using AfterStage = std::function<void(std::string_view stage)>;

struct SeaTextureOptions {
    /// Samples of a cascade's map along a side; 0 = the samples of its lattice.
    int cascade_resolution = 0;
    /// Samples along a side of the map whose foam is followed; 0 = the samples of the sea's default
    /// map.
    int foam_resolution = 0;
    FoamStart foam_start = FoamStart::empty;
    /// Called during a pre-roll of the foam; may throw to stop it.
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress = {};
    AfterStage after_stage = {};  // "foam", "cascades"
};

/// Makes and owns the textures. The context that was current at construction must be current in
/// every call and in the destructor.
class SeaTextures {
  public:
    /// Throws Error no_gpu.
    explicit SeaTextures(SeaTextureOptions options = {});
    ~SeaTextures();
    SeaTextures(const SeaTextures&) = delete;
    SeaTextures& operator=(const SeaTextures&) = delete;

    /// Updates all textures to a time [s]. Reads only the modes of the sea, also at the ticks of
    /// the foam's clock. After a change or performance of the sea, foam begins again or continues,
    /// according to the calls of foam_changed(). Throws Error; after no_gpu, also when the context
    /// was lost, only the destructor may be called.
    void show(OpenSea& sea, double time);
    /// Drops the foam that was followed, from a time [s] on, because the sea has changed there.
    void foam_changed(double from);
    /// Drops all foam that was followed.
    void foam_changed();

    // The results of the last show().
    /// Returns the textures of each cascade: layers of arrays(), in its order.
    std::span<const CascadeTextures> cascades() const;
    CascadeArrays arrays() const;
    const FoamTexture& foam() const;
    std::int64_t foam_settling_ticks() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::gl
