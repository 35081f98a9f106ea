// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bound waves of one time at any label: splines as of other waves (waves/query/spline_map.hpp), and
// the sum over all of them in double.
#pragma once

#include <optional>

#include "ocean/internal/wave_sum.hpp"
#include "waves/bound/bound_waves.hpp"
#include "waves/query/spline_map.hpp"
#include "waves/query/spline_strips.hpp"

namespace ocean {

/// The height, slopes and rate that bound waves add at a label.
struct BoundSample {
    double height = 0.0;  // [m]
    double slope_x = 0.0;
    double slope_y = 0.0;
    double height_rate = 0.0;  // [m/s]
};

class BoundSplines {
  public:
    /// Begins a time. `shown`: samples of the map whose waves count. sums: exactly_at() is allowed.
    /// Does nothing for a sea that is linear.
    void begin(const Modes& sea, double choppiness, const Water& water, double time, int shown,
               bool sums, ThreadPool& pool);
    bool has_waves() const { return maps_.has_value(); }
    /// Returns the bound waves at a label [m]; nothing in a linear sea. Several threads may call it
    /// at once.
    BoundSample at(double x, double y) const;
    BoundSample exactly_at(double x, double y) const;

    /// Returns an upper bound of the bytes that begin() needs for a sea of such a grid.
    static std::uint64_t bytes(int grid_resolution);

  private:
    struct Maps {
        Maps(const Modes& modes, int samples, const ModeFactor& factor, ThreadPool& pool)
            : strips(modes, samples, factor, pool), spline({samples, modes.lattice.period}, pool) {}

        SplineStrips strips;
        SplineMap spline;
    };
    BoundWaves waves_;
    std::optional<Maps> maps_;  // of the time that has begun; none in a linear sea
    std::optional<WaveSum> sums_;
};

}  // namespace ocean
