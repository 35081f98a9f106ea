// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A terrain as a texture for the renderer, made by the land's own backend.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ocean/land.hpp"

namespace ocean::preview {

/// One period of a land's ground by samples, which repeats. Immutable once it is shown.
struct LandImage {
    /// Height [m], slope x, slope y and square of the slope of each sample, row-major [j][i].
    std::vector<float> texels;
    int resolution = 0;
    double period = 0.0;  // [m]

    /// Returns the height of the ground that the renderer draws near the eye [m]: a bicubic Hermite
    /// patch with the heights and slopes of its four corners.
    double height_at(double x, double y) const;
};

/// A terrain. Its texture is valid until the next show() of its LandMaps.
struct ShownLand {
    unsigned texture = 0;  // the texels of the image, with mipmaps that are means
    std::shared_ptr<const LandImage> image;
    double mean = 0.0;                       // [m]
    double rms = 0.0;                        // of the heights about the mean [m]
    double rms_slope = 0.0;                  // of the map
    double cell = 0.0;                       // distance of the terrain's own samples [m]
    std::array<double, 2> heights = {0, 0};  // lowest and highest sample [m]
};

/// Returns the distance of the map's samples [m].
double texel_of(const ShownLand& land);

/// Returns the height that the colours of land scale with [m]: its rms height, of flat land 1 m.
double colour_scale(const ShownLand& land);
/// Returns the height above which snow lies on level ground by default [m]: 1.3 colour scales above
/// the mean.
double default_snow_line(const ShownLand& land);

/// Returns the default samples along a side of a terrain's map: twice its own, so that cubic
/// patches follow its shortest waves, up to 4096. `quick`: its own, up to 1024, for machines that
/// draw without a GPU.
int land_map_resolution(const Terrain& terrain, bool quick);

/// Needs the context that was current when it was made to be current in every call, the destructor
/// too. OpenGL 4.1 core.
class LandMaps {
  public:
    LandMaps();
    ~LandMaps();
    LandMaps(const LandMaps&) = delete;
    LandMaps& operator=(const LandMaps&) = delete;

    /// Returns the land by a map of `resolution` samples along a side; makes the map anew only if
    /// the land or the resolution has changed. Throws Error.
    ShownLand show(Land& land, int resolution);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::preview
