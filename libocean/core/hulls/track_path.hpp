// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The path of a hull: its place at any time, a smooth curve through the rows of its track.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

/// A position or a velocity in the plane [m], [m/s].
struct PathVector {
    double x = 0.0;
    double y = 0.0;
    bool operator==(const PathVector&) const = default;
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

    /// Returns the velocity at a time [m/s], at a row that of the leg after it; 0 before the first
    /// row and from the last one on.
    PathVector velocity(double time) const;
    /// Returns the velocities at the rows [m/s].
    const std::vector<PathVector>& velocities() const { return velocities_; }

    /// Returns the time up to which two paths are one [s]: that of their last common row. Minus
    /// infinity if they have none, infinity if they are the same.
    double same_until(const TrackPath& other) const;

    /// Returns the time of the first row; minus infinity for a track that repeats.
    double begin() const;
    /// Returns the time after which a track repeats; 0: never.
    double period() const { return period_; }

  private:
    /// Returns the time within the track that a time stands for.
    double track_time(double time) const;

    /// A leg between two rows, and the share of it that has passed.
    struct Leg {
        std::size_t row;  // its first
        double seconds;
        double u;
    };
    /// Returns the leg of a time of the track from the first row to before the last.
    Leg leg_at(double time) const;

    std::shared_ptr<const HullTrack> track_;
    std::vector<PathVector> velocities_;  // at the rows
    double period_ = 0.0;
};

}  // namespace ocean
