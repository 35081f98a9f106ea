// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of one sea at halving resolutions, sampled at any point with any spacing: the mip chain of
// the horizon mesh. It is band-limited by construction: a coarser map is a sum of fewer waves, not
// an average.
#pragma once

#include <span>
#include <vector>

#include "ocean/surface.hpp"

namespace ocean::io {

/// The second moments of the slopes of a set of waves, by label.
struct SlopeVariance {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
};

/// The surface at a label: offsets [m], the normal of the displaced surface, and the variance of
/// the slopes of the waves that the requested spacing leaves out.
struct PyramidSample {
    double dx, dy, height;
    double normal_x, normal_y, normal_z;  // a unit vector
    SlopeVariance left_out;
};

/// Immutable; any thread may read. The surfaces must outlive it.
class MapPyramid {
  public:
    /// Throws Error invalid_value unless each level has half the resolution of the previous one,
    /// and the same period and time.
    explicit MapPyramid(std::span<const Surface> levels);

    /// Returns the surface of the waves longer than twice `spacing` [m], blended between two
    /// levels; beyond the coarsest level the sea fades to still water.
    PyramidSample sample(double x, double y, double spacing) const;

  private:
    struct Blend {
        std::size_t fine, coarse;  // levels_.size() = still water
        double weight;             // of the coarse level
    };
    Blend blend(double spacing) const;

    std::span<const Surface> levels_;
    std::vector<SlopeVariance> variance_;  // of each level, then 0 for still water
};

}  // namespace ocean::io
