// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The path of a hull: its place at any time, a smooth curve through the rows of its track.
#pragma once

#include <memory>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

/// A position or a velocity in the plane [m], [m/s].
struct PathVector {
    double x = 0.0;
    double y = 0.0;
};

class TrackPath {
  public:
    /// `track` must be valid. loop_period: 0, or the period of a sea in which the closed track
    /// repeats [s].
    TrackPath(std::shared_ptr<const HullTrack> track, double loop_period);

    /// Returns the place at a time: Hermite's cubic between the rows, with their courses or,
    /// without them, the slopes of parabolas through three rows. At rest before the first row and
    /// after the last.
    PathVector place(double time) const;

    /// Returns the direction of the motion at a time, of length 1; at rest that of its course or,
    /// without courses, of its last motion, before the first motion that of the first. 0 for a hull
    /// that never moves.
    PathVector heading(double time) const;

    /// Returns the time of the first row; minus infinity for a track that repeats.
    double begin() const;
    /// Returns the time after which a track repeats; 0: never.
    double period() const { return period_; }

  private:
    /// Returns the time within the track that a time stands for.
    double track_time(double time) const;

    std::shared_ptr<const HullTrack> track_;
    std::vector<PathVector> velocities_;  // at the rows
    double period_ = 0.0;
};

}  // namespace ocean
