// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea at a time as the renderer takes it, computed by the GPU or by the sea's own backend.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ocean/gl/sea_textures.hpp"

namespace ocean::preview {

/// Of a picture; a sea has at most 5.
inline constexpr std::size_t kMostCascades = 10;

struct ShownCascade : gl::CascadeTextures {
    double weight = 1.0;      // of its amplitudes
    double sea_period = 0.0;  // m, a multiple of its own period
    int number = 0;           // in its sea, from 0
};

/// A map of how much of each texel foam covers, with mipmaps.
struct ShownCover {
    unsigned texture = 0;
    int resolution = 0;
    double period = 0.0;  // m
    double share = 1.0;
};

/// Its textures are valid until the maps are those of another time.
struct ShownSea {
    std::vector<ShownCascade> cascades;
    std::vector<ShownCover> covers;  // one; two of a cross-fade
    double period = 0.0;             // m
    double time = 0.0;               // s
    double choppiness = 0.0;
    double foam_threshold = 0.0;  // of the whitecaps
    double foam_width = 1.0;
    double significant_wave_height = 0.0;  // m, asked
    double peak_period = 0.0;              // s, asked; 0: flat
    double mean_square_slope = 0.0;        // asked
};

/// m, of the finest of its maps: no water is shown finer.
double finest_texel(const ShownSea& sea);

/// Two seas at once. Of two that know nothing of each other the amplitudes a and b have
/// a^2 + b^2 = 1, for their energies add up; with a correlation of their heights, as of
/// height_correlation(), both are less, so that the height is that blend too. share: 0 .. 1, from
/// one to the other.
ShownSea cross_fade(const ShownSea& from, const ShownSea& to, double share,
                    double correlation = 0.0);

struct SeaMapsOptions {
    /// By compute shaders in the current context (OpenGL 4.3), else by the backend of the sea.
    bool compute = true;
    int cascade_resolution = 0;  // samples; 0: those of its lattice
    int foam_resolution = 0;     // 0: the default map of the sea
    /// Of computed foam; that of the sea's backend begins as the sea was told.
    FoamStart foam_start = FoamStart::empty;

    bool operator==(const SeaMapsOptions&) const = default;
};

/// Needs the context that was current when it was made to be current in every call, the destructor
/// too. OpenGL 4.1 core, or 4.3 to compute.
class SeaMaps {
  public:
    /// after_stage: "cascades", "foam", "cover". Throws Error no_gpu.
    explicit SeaMaps(const SeaMapsOptions& options = {}, gl::AfterStage after_stage = {});
    ~SeaMaps();
    SeaMaps(const SeaMaps&) = delete;
    SeaMaps& operator=(const SeaMaps&) = delete;

    /// Throws Error.
    ShownSea show(Ocean& sea, double time);
    /// The foam from that time on, or all of it, is not that of the sea any more.
    void foam_changed(double from);
    void foam_changed();
    /// Ticks of the foam's clock until foam that began empty is what it always is.
    std::int64_t foam_settling_ticks(const Ocean& sea) const;

    class Source;

  private:
    std::unique_ptr<Source> source_;
};

}  // namespace ocean::preview
