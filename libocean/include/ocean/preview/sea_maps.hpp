// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea at a time as the renderer takes it, computed by the GPU or by the sea's own backend.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "ocean/detail.hpp"
#include "ocean/gl/sea_textures.hpp"

namespace ocean::preview {

/// Cascades of a picture; a sea has at most 5.
inline constexpr std::size_t kMaxCascades = 10;

struct ShownCascade {
    gl::CascadeArrays maps;   // of all cascades of its sea
    int layer = 0;            // of the maps
    double period = 0.0;      // m
    double weight = 1.0;      // of its amplitudes
    double sea_period = 0.0;  // m, a multiple of its own period
    int number = 0;           // in its sea, from 0
};

/// A map with mipmaps: how much of each texel foam covers; that times how thick it is; and how much
/// its breakers have driven bubbles down.
struct ShownCover {
    unsigned texture = 0;
    int resolution = 0;
    double period = 0.0;  // m
    double share = 1.0;
    // Of the pattern, which lies at labels. All the waves have the same one, for it would turn and
    // swell around the origin with a take's wind: that of the sea's parameters before any event.
    double direction = 0.0;  // rad counter-clockwise from +x, along the cells
    double stretch = 1.5;    // length over width of the cells
    double streaks = 0.0;    // share of windrows, 0 .. 1
};

/// Of the mipmaps of a slope tile, those that are read.
inline constexpr std::size_t kTileLevels = 8;

/// Slopes by label of waves that no map of a cascade has, in two floats; see ocean/detail.hpp.
struct ShownTile {
    unsigned texture = 0;  // GL_TEXTURE_2D_ARRAY, of all tiles of its sea
    int layer = 0;
    int samples = 0;
    double tile = 0.0;                          // m
    double shortest_wave = 0.0;                 // m
    double longest_wave = 0.0;                  // m
    SlopeVariance variance;                     // at this time
    std::array<double, kTileLevels> read = {};  // share of it that reads of a level have
    double weight = 1.0;                        // of its amplitudes
};

/// Its textures are valid until the maps are those of another time.
struct ShownSea {
    std::vector<ShownCascade> cascades;
    std::vector<ShownCover> covers;  // one; two of a cross-fade
    bool has_foam = false;           // or had some
    std::vector<ShownTile> tiles;    // none where nobody asked for them
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
    /// For a picture that may not wait some tenths of a second when the waves or the wind change:
    /// the power of the cover is solved in another thread, and the one before holds until it is.
    /// Without it a picture is a function of the sea and the time.
    bool live = false;
    /// The waves too short for the maps too: slope tiles, computed on the CPU.
    bool detail = false;

    bool operator==(const SeaMapsOptions&) const = default;
};

/// What another thread makes for the pictures to come. While it is in work pictures are without it;
/// when it is ready the next one has it.
enum class Pending { nothing, in_work, ready };

/// Needs the context that was current when it was made to be current in every call, the destructor
/// too. OpenGL 4.1 core, or 4.3 to compute.
class SeaMaps {
  public:
    /// after_stage: "cascades", "foam", "cover", "detail". Throws Error no_gpu.
    explicit SeaMaps(const SeaMapsOptions& options = {}, gl::AfterStage after_stage = {});
    ~SeaMaps();
    SeaMaps(const SeaMaps&) = delete;
    SeaMaps& operator=(const SeaMaps&) = delete;

    /// Throws Error.
    ShownSea show(Ocean& sea, double time);
    /// As SeaMapsOptions say, from now on.
    void set_detail(bool on);
    /// The foam from that time on, or all of it, is not that of the sea any more.
    void foam_changed(double from);
    void foam_changed();
    /// Ticks of the foam's clock until foam that began empty is what it always is.
    std::int64_t foam_settling_ticks(const Ocean& sea) const;
    /// Returns whether the same sea at the same time will look otherwise, of live maps: their cover
    /// is solved beside the pictures.
    Pending pending() const;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::preview
