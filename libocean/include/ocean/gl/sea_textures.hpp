// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as textures, for a renderer in the same context: the small map of each cascade, with
// mipmaps and second moments, and the foam of the whole patch. Nothing comes back to the CPU.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "ocean/foam_clock.hpp"
#include "ocean/parameters.hpp"

namespace ocean {
class Ocean;
}

namespace ocean::gl {

/// The maps of all cascades of a sea as array textures (GL_TEXTURE_2D_ARRAY), a layer for each
/// cascade; the components and mipmaps of a layer are those of CascadeTextures.
struct CascadeArrays {
    int resolution = 0;  // texels along a side of each layer
    unsigned displacement = 0;
    unsigned gradients = 0;
    unsigned moments = 0;

    bool operator==(const CascadeArrays&) const = default;
};

/// Names of textures, which stay their owner's. All are RGBA in float, N x N, repeat, and have
/// mipmaps down to one texel; u = x / period. They share their texels with layers of CascadeArrays.
struct CascadeTextures {
    double period = 0.0;  // m
    int resolution = 0;
    unsigned displacement = 0;  // Dx, Dy at choppiness 1, height [m]; dDx/dy
    unsigned gradients = 0;     // slope x, slope y, dDx/dx, dDy/dy
    /// Slope x ^ 2, slope y ^ 2, slope x * slope y, (dDx/dx + dDy/dy)^2. Their mipmaps less the
    /// squares of those of `gradients` are what a texel's waves vary by: glitter, and whitecaps
    /// that are too small to be seen.
    unsigned moments = 0;
};

/// foam = max(W, fade * texture), with W = surface_whitecap of the interpolated Jacobian: clamp and
/// interpolation do not commute.
struct FoamTexture {
    unsigned texture = 0;  // one float a texel, of the whole patch; 0: there is no foam yet
    int resolution = 0;
    double period = 0.0;  // m
    float fade = 0.0f;
    float threshold = 0.0f;  // of the whitecaps
    float width = 0.0f;
};

/// For who measures: called when the commands of a part of the work have been given, with its name.
using AfterStage = std::function<void(std::string_view stage)>;

struct SeaTextureOptions {
    /// Samples of a cascade's map along a side; 0: those of its lattice.
    int cascade_resolution = 0;
    /// Of the foam; 0: the default map of the sea.
    int foam_resolution = 0;
    FoamStart foam_start = FoamStart::empty;
    /// Of a pre-roll; may throw to stop it.
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress = {};
    AfterStage after_stage = {};  // "foam", "cascades"
};

/// Needs the context that was current when it was made to be current in every call, the destructor
/// too.
class SeaTextures {
  public:
    /// Throws Error no_gpu.
    explicit SeaTextures(SeaTextureOptions options = {});
    ~SeaTextures();
    SeaTextures(const SeaTextures&) = delete;
    SeaTextures& operator=(const SeaTextures&) = delete;

    /// Makes all textures those of a time. The sea is asked for its modes alone, at the ticks of
    /// the foam's clock too; of a sea that was changed or performed foam begins again, or goes on,
    /// as foam_changed() was told. Throws Error; no_gpu if the context was lost too, after which
    /// only the destructor may be called.
    void show(Ocean& sea, double time);
    /// What was followed of the foam is not that of this sea any more, from that time on.
    void foam_changed(double from);
    void foam_changed();

    // Of the last show.
    /// Returns the textures of each cascade: layers of arrays(), in its order.
    std::span<const CascadeTextures> cascades() const;
    CascadeArrays arrays() const;
    const FoamTexture& foam() const;
    std::int64_t foam_settling_ticks() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace ocean::gl
