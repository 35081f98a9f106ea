// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea at a time as textures for the renderer, computed by the GPU or by the sea's own backend.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ocean/detail.hpp"
#include "ocean/internal/gl/sea_textures.hpp"
#include "ocean/internal/preview/coast_maps.hpp"

namespace ocean::preview {

/// Cascades of a picture; a sea has at most 5.
inline constexpr std::size_t kMaxCascades = 10;

struct DrawnCascade {
    gl::CascadeArrays maps;   // of all cascades of its sea
    int layer = 0;            // of the maps
    double period = 0.0;      // [m]
    double weight = 1.0;      // factor of its amplitudes
    double sea_period = 0.0;  // [m], a multiple of its own period
    int number = 0;           // in its sea, from 0
};

/// A map of foam with mipmaps: the covered share of each texel, that share times its thickness, and
/// the amount of bubbles that breakers have driven down.
struct DrawnCover {
    unsigned texture = 0;
    int resolution = 0;
    double period = 0.0;  // m
    double share = 1.0;
    // The pattern, which lies at labels. It follows the sea's parameters before any event of its
    // take: with the wind of a take it would turn and swell around the origin.
    double direction = 0.0;  // [rad] counter-clockwise from +x, along the cells
    double stretch = 1.5;    // length/width of the cells
    double streaks = 0.0;    // share of windrows, 0 .. 1
};

/// Levels of the mipmaps of a slope tile that are read.
inline constexpr std::size_t kTileLevels = 8;

/// Slopes by label, two floats a texel, of waves that no map of a cascade has; see
/// ocean/detail.hpp.
struct DrawnTile {
    unsigned texture = 0;  // GL_TEXTURE_2D_ARRAY, of all tiles of its sea
    int layer = 0;
    int samples = 0;
    double tile = 0.0;                          // side [m]
    double shortest_wave = 0.0;                 // [m]
    double longest_wave = 0.0;                  // [m]
    SlopeVariance variance;                     // at this time
    std::array<double, kTileLevels> read = {};  // share of it that reads of a level have
    double weight = 1.0;                        // factor of its amplitudes
};

/// A sea at a time. Its textures are valid until the next show() of its SeaMaps.
struct DrawnSea {
    std::vector<DrawnCascade> cascades;
    std::vector<DrawnCover> covers;           // one, or two in a cross-fade
    bool has_foam = false;                    // or has had some
    std::vector<DrawnTile> tiles;             // empty without SeaMapsOptions::detail
    std::shared_ptr<const DrawnCoast> coast;  // null: the sea has no bed
    double period = 0.0;                      // [m]
    double time = 0.0;                        // [s]
    double choppiness = 0.0;
    double foam_threshold = 0.0;  // of the whitecaps
    double foam_width = 1.0;
    // By the spectrum, whether or not the maps hold all of its waves.
    double significant_wave_height = 0.0;  // [m]
    double peak_period = 0.0;              // [s]; 0: flat water
    double mean_square_slope = 0.0;
};

/// Returns the side of a texel of its finest map [m]: no mesh is finer.
double finest_texel(const DrawnSea& sea);

/// Returns two seas at once, faded by `share` 0 .. 1 from the first one to the second. Independent
/// seas have amplitudes a and b with a^2 + b^2 = 1, because their energies add up; with a
/// correlation of their heights, see height_correlation(), both are smaller, so that the wave
/// height is the same blend.
DrawnSea cross_fade(const DrawnSea& from, const DrawnSea& to, double share,
                    double correlation = 0.0);

struct SeaMapsOptions {
    /// True: compute shaders in the current context make the maps (OpenGL 4.3); else the backend of
    /// the sea does.
    bool compute = true;
    int cascade_resolution = 0;  // samples along a side; 0: those of the sea's grid
    int foam_resolution = 0;     // 0: the sea's default for maps
    /// Start of the foam that compute shaders make; the foam of the sea's backend starts as the
    /// options of the Ocean say.
    FoamStart foam_start = FoamStart::empty;
    /// True: when waves or wind change, the power of the cover is solved in another thread for some
    /// tenths of a second, and the previous one is used meanwhile. Else the picture waits, and is a
    /// function of the sea and the time.
    bool live = false;
    /// Adds the waves too short for the maps, as slope tiles that the CPU computes.
    bool detail = false;
    /// The windows over a bed, which the CPU computes; the maps are those of the open sea.
    CoastMapsOptions coast = {};

    bool operator==(const SeaMapsOptions&) const = default;
};

/// State of a result that another thread computes for the pictures to come: they go without it
/// while it is in work, and the next one has it when it is ready.
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

    /// Returns the sea at a time [s]; overwrites the textures of the DrawnSea before. eye: of a sea
    /// over a bed, the place that the windows of its coast surround [m]; nothing: the coast is in
    /// work, and the open sea is shown before its ground. Throws Error.
    DrawnSea show(Ocean& sea, double time,
                  const std::optional<std::array<double, 3>>& eye = std::array{0.0, 0.0, 0.0});
    /// Blends the coast of another sea into that of the last show(), with the share 1 - `share`.
    DrawnSea fade_from(const DrawnSea& before, double share);
    /// Sets SeaMapsOptions::detail.
    void set_detail(bool on);
    /// Discards the foam from a time on [s], or all of it, after a change of the sea.
    void foam_changed(double from);
    void foam_changed();
    /// Returns the ticks of the foam's clock until foam that began empty has settled.
    std::int64_t foam_settling_ticks(const Ocean& sea) const;
    /// Returns whether the same sea at the same time would change if it were shown again: live maps
    /// solve their cover in another thread.
    Pending pending() const;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::preview
