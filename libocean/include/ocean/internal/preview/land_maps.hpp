// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A terrain for the renderer: the function that gives the patches of the mesh their heights, and
// the textures from which colours, normals and shadows of the ground are read.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "ocean/land_function.hpp"
#include "ocean/terrain.hpp"

namespace ocean::preview {

/// A square of a land's ground as samples: one period, which repeats, or land that exists once,
/// whose edge continues beyond. Immutable once it is shown.
struct LandImage {
    /// Height [m], slope x, slope y and square of the slope of each sample, row-major [j][i].
    std::vector<float> texels;
    int resolution = 0;
    double period = 0.0;             // resolution times the distance of samples [m]
    std::array<double, 2> origin{};  // of sample (0, 0) [m]
    bool wraps = true;

    /// Returns the height of the bicubic Hermite patch with the heights and slopes of its four
    /// corners [m].
    double height_at(double x, double y) const;
};

/// A terrain. Its textures are valid until the next show() of its LandMaps.
struct DrawnLand {
    unsigned texture = 0;  // the texels of the image, with mipmaps that are means
    /// The masks that a material reads, each 0 .. 1, with mipmaps: 0.5 + (beach - cliff)/2,
    /// streambed, deposit, 0.5 + wear/2. A land without masks has one texel.
    unsigned masks = 0;
    bool has_masks = false;
    std::shared_ptr<const LandImage> image;
    std::shared_ptr<const LandFunction> function;
    double mean = 0.0;                       // [m]; above the water if the land has a coast
    double rms = 0.0;                        // of the heights about the mean [m]
    double rms_slope = 0.0;                  // of the map
    double cell = 0.0;                       // distance of the terrain's own samples [m]
    std::array<double, 2> heights = {0, 0};  // lowest and highest sample [m]
    std::optional<double> water_level = {};  // for land with a coast [m]

    /// Returns the height of the ground at a place, by the finest vertices of the mesh [m]. Beyond
    /// land that exists once, it is the height of the edge.
    double ground_at(double x, double y) const;
    /// Returns the height of the ground or of the water over it [m].
    double surface_at(double x, double y) const;
};

/// Returns the distance of the map's samples [m].
double texel_of(const DrawnLand& land);

/// Returns the height that scales the colours of land [m]: the rms height, or 1 m for flat land.
double colour_scale(const DrawnLand& land);
/// Returns the relief that scales the widths of the covers' edges [m]: the rms height, or for a
/// land with a coast a third of the height from water to summit.
double cover_relief(const DrawnLand& land);

/// Heights where the covers of level ground end [m].
struct CoverLines {
    double snow;   // lower limit of snow
    double trees;  // upper limit of trees
};
/// Returns the lines of a land. snow_line: a given one [m]; the default is 1.3 rms heights above
/// the mean, and far above land with a coast, whose trees end half way to the summit.
CoverLines cover_lines(const DrawnLand& land, std::optional<double> snow_line);

/// Returns the default number of samples along a side of a terrain's map: twice the terrain's own,
/// so that cubic patches follow its shortest waves, up to 4096. For a land with erosion, a shore or
/// a place: the terrain's own, up to 2048. `quick`: the terrain's own, up to 1024, for machines
/// that draw without a GPU.
int land_map_resolution(const TerrainModel& terrain, bool quick);

/// Every call, the destructor too, needs the context that was current at construction. OpenGL 4.1
/// core.
class LandMaps {
  public:
    LandMaps();
    ~LandMaps();
    LandMaps(const LandMaps&) = delete;
    LandMaps& operator=(const LandMaps&) = delete;

    /// Returns the land by a map of `resolution` samples along a side; makes the map anew only if
    /// the land or the resolution has changed. Throws Error.
    DrawnLand show(Terrain& land, int resolution);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::preview
