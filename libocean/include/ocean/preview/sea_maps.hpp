// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea at a time as the renderer takes it, computed by the GPU or by the sea's own backend.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "ocean/gl/sea_textures.hpp"

namespace ocean::preview {

/// Valid until the maps are those of another time.
struct ShownSea {
    std::span<const gl::CascadeTextures> cascades;
    unsigned cover = 0;  // texture: share of a texel of the patch that foam covers, with mipmaps
    int cover_resolution = 0;
    double period = 0.0;  // m
    double time = 0.0;    // s
    double choppiness = 0.0;
    double foam_threshold = 0.0;  // of the whitecaps
    double foam_width = 1.0;
    double significant_wave_height = 0.0;  // m, asked
    double peak_period = 0.0;              // s, asked; 0: flat
    double mean_square_slope = 0.0;        // asked
    double unresolved_slope = 0.0;         // what of it no map has
};

struct SeaMapsOptions {
    /// By compute shaders in the current context (OpenGL 4.3), else by the backend of the sea.
    bool compute = true;
    int cascade_resolution = 0;  // samples; 0: those of its lattice
    int foam_resolution = 0;     // 0: the default map of the sea
    /// Of computed foam; that of the sea's backend begins as the sea was told.
    FoamStart foam_start = FoamStart::empty;
};

/// Needs the context that was current when it was made to be current in every call, the destructor
/// too. OpenGL 4.1 core, or 4.3 to compute.
class SeaMaps {
  public:
    /// Throws Error no_gpu.
    explicit SeaMaps(const SeaMapsOptions& options = {});
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
