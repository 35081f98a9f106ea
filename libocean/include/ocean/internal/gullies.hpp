// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Gullies: erosion as a function of place, octave by octave along the fall line of a base that has
// long waves alone. The equations are in shaders/land/gullies.glsl. A terrain's shortest waves are
// added after its gullies, because the filter would carve along each of them.
//
// It is not a simulation: no water is routed, valleys do not join to rivers, and closed hollows
// remain.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ocean/terrain_model.hpp"

namespace ocean {

/// One octave of the gullies: for hosts that compute gullies on a GPU.
struct GullyOctave {
    double wavelength = 0.0;  // spacing of its lattice [m]
    std::uint32_t count = 0;  // lattice points of a period; 0: does not repeat
    std::uint32_t key = 0;    // of the octave's hashes
    double weight = 0.0;      // in the masks: 0.6 of the previous octave's weight
};

/// Places and the values there. All spans but empty masks have one size.
struct GullyPoints {
    std::span<const double> x, y;  // [m], within 1e9
    /// Before: height [m] and slopes of the base, finite. After: with gullies. The slopes are
    /// approximate, as the turn of the fall line is left out; differences of heights are exact.
    std::span<float> height, slope_x, slope_y;
    /// Masks, 0 on flats; each may be empty. wear: -1 on floors .. 1 on ridges, the weighted mean
    /// over the octaves. gully and ridge: 0 .. 1, floors and ridges of any octave.
    std::span<float> wear, gully, ridge;
};

/// The filter. Values are a function of settings, place, base and cell: their bits depend neither
/// on the other points nor on the instruction set. Immutable, for any number of threads.
class GullyFilter {
  public:
    /// Throws Error invalid_value for settings out of their ranges.
    explicit GullyFilter(const GullySettings& settings);

    /// Adds gullies to the points. cell [m], 0 or more: the spacing that the values stand for;
    /// octaves shorter than 4 cells fade out by gully_share. Throws Error invalid_value for a
    /// negative cell or spans of unequal size.
    void apply(const GullyPoints& points, double cell) const;

    const GullySettings& settings() const { return settings_; }
    std::span<const GullyOctave> octaves() const { return octaves_; }

  private:
    GullySettings settings_;
    std::vector<GullyOctave> octaves_;
};

/// Returns the share of an octave on samples that lie `cell` apart [m]: 1 from 4 cells a wave on, 0
/// up to 2 cells, t^2 (3 - 2t) with t = wavelength / (2 cell) - 1 between them.
double gully_share(double wavelength, double cell);

/// Returns the mean over a phase of the crease function of ridges. The filter subtracts it, so that
/// gullies move no mean height. crease: 0 .. 1. length: length of the stripes' vector, 0 .. 1,
/// below 1 where stripes cancel.
double gully_crease_mean(double crease, double length = 1.0);

}  // namespace ocean
