// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parameters that define a terrain, as one plain value, which terrain file, panel and slider
// set and the mathematics reads. The table of terrain_table.hpp states the unit, range, label and
// help of each member; the initialisers here are the defaults.
//
//     TerrainModel hills;
//     hills.resolution = 1024;
//     hills.patch_size = 4000.0;
//     hills.beta = 2.2;
//     hills.rms = 60.0;
//     hills.gullies = {.longest = 900.0, .depth = 0.05};
//     validate(hills);  // terrain_table.hpp
//     Terrain terrain(hills);
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ocean {

struct MeasuredRings;
struct TerrainBase;

/// How a terrain lies in the world. tile: a square that repeats. placed: a rectangle that exists
/// once.
enum class TerrainKind { tile, placed };

inline constexpr double kDefaultTerrainRms = 10.0;  // [m]

inline constexpr int kMaxGullyOctaves = 12;

/// Erosion by gullies; see gullies.hpp.
struct GullySettings {
    double longest = 1500.0;  // wavelength of the first octave [m], above 0; each next one has half
    int octaves = 6;          // 1 .. kMaxGullyOctaves
    double depth = 0.055;     // half of the height between floor and ridge over wavelength, 0 .. 1
    double crease = 0.7;      // of the ridges: 0 round, 1 sharp
    double flat = 0.2;        // slope at which gullies have half of their depth, above 0
    std::uint32_t seed = 1;
    double period = 0.0;  // [m], at least 4 longest; 0: does not repeat

    bool operator==(const GullySettings&) const = default;
};

/// Erosion by streams; see stream_power.hpp.
struct StreamSettings {
    double exponent = 0.45;         // m of the drainage area, 0 .. 1
    double hillslope_area = 1.2e4;  // [m2]; smaller areas erode as this one
    double slope = 0.62;            // at the hillslope area where uplift is 1
    double max_slope = 0.8;         // of hillsides
    double age = 1.0;               // share of the time after which the last slope is steady, 0..1
    double creep = 55.0;            // reach of soil creep between channels [m]; 0: none
    std::uint32_t seed = 1;         // of the valleys' turns within the grid

    bool operator==(const StreamSettings&) const = default;
};

/// The shore of a land, see shoreline_profile.hpp. All numbers but the level must be positive.
struct ShorelineSettings {
    double level = 0.0;               // height of the water [m]
    double beach_slope = 1.0 / 30.0;  // of the bed where the shore is sheltered
    double berm = 2.2;                // height of the beach above the level [m]
    double face = 0.1;                // slope of the beach at the water line
    double closure = 9.0;             // depth to which beach_slope reaches [m]
    double shelf = 45.0;              // depth of the shelf [m]
    double smooth = 40.0;             // deviation of the Gaussian that smooths the shore line [m]
    double shelter = 450.0;           // deviation of the Gaussian of the land share [m]
    double width = 130.0;             // of the beach on land [m]
    double beaches = 0.0;             // less land around a shore suffices for a beach, as a share
};

/// A further tile over the first one, with its own period and noise. It has the same law, so that
/// its waves add energy at the same wavelengths.
struct TerrainLayer {
    double period = 0.0;  // [m]; a whole part of patch_size
    double gain = 1.0;    // of its amplitudes, relative to the first tile
    std::uint32_t seed = 2;

    bool operator==(const TerrainLayer&) const = default;
};

/// A fractional Brownian surface: a sum of waves whose amplitudes fall as k^-beta, so that the
/// density over (kx, ky) falls as k^-2beta. Hurst exponent H = beta - 1, fractal dimension of the
/// surface D = 4 - beta, both for 1 < beta < 2.
struct TerrainModel {
    TerrainKind kind = TerrainKind::tile;
    int resolution = 512;
    double patch_size = 1000.0;
    std::uint32_t seed = 1;
    double beta = 2.0;
    /// Unset means kDefaultTerrainRms, or with `measured` the rms of the measured spectrum.
    std::optional<double> rms;
    std::vector<double> range;  // min and max height [m]; empty: rms decides
    double mean = 0.0;
    double outer_scale = 0.0;
    std::vector<std::array<double, 2>> breaks;  // wavelength [m], exponent of shorter waves
    double ridge_wavelength = 0.0;              // 0: no ridge
    double ridge_gain = 4.0;
    double ridge_width = 0.5;
    std::optional<double> ridge_direction;
    double ridge_spread = 2.0;
    double longest_wavelength = 0.0;
    double shortest_wavelength = 0.0;
    double anisotropy = 1.0;
    double direction = 0.0;
    std::string measured;
    std::vector<double> origin;        // south-west corner of a placed land [m]; empty: (0, 0)
    std::vector<double> size;          // its sides [m]; empty: patch_size, or the sides of `base`
    double island = 0.0;               // fall of the heights from the middle to the border [m]
    std::string base;                  // the file of an elevation model that is the land
    std::optional<double> base_error;  // [m]; unset: a tenth of its slope times its cell
    std::optional<double> detail_wavelength;  // [m]; unset: a thirtieth of the base's cell
    std::vector<TerrainLayer> layers;
    GullySettings gullies{.depth = 0.0};          // depth 0: none
    StreamSettings stream{.slope = 0.0};          // slope 0: none
    ShorelineSettings coast{.beach_slope = 0.0};  // beach_slope 0: none
    std::optional<double> coast_level;            // [m]; unset: 0

    /// The rings of `measured`, read by ocean::seafile. Shared and never modified. The table has no
    /// row for them.
    std::shared_ptr<const MeasuredRings> rings;
    /// The elevation model of `base` and the rings measured in it, read and shared like `rings`.
    std::shared_ptr<const TerrainBase> base_model;

    bool has_gullies() const { return gullies.depth > 0.0; }
    bool has_streams() const { return stream.slope > 0.0; }
    bool has_coast() const { return coast.beach_slope > 0.0; }
    bool is_placed() const { return kind == TerrainKind::placed; }
    /// Returns true if the land is a function of the place and not only a sum of waves that
    /// repeats.
    bool is_shaped() const { return is_placed() || has_gullies(); }

    /// Returns true if the heights keep the rms of the measured spectrum.
    bool has_measured_rms() const { return rings != nullptr && !rms && range.empty(); }
};
inline constexpr std::size_t kMaxTerrainLayers = 8;

}  // namespace ocean
