// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A hull that a hand drives: from the speed and the heading that it wants follow the rows of the
// hull's track. A row is final once it is written, so that the past of the wake stays as it was.
#pragma once

#include <memory>

#include "ocean/parameters.hpp"

namespace ocean {

class HullDrive {
  public:
    /// Goes on from a time [s] where the track of a hull is then; a track that is over, or has not
    /// begun, is at rest. The track may have one row. Throws Error invalid_value for a time that
    /// require_time() refuses.
    HullDrive(const Hull& hull, double time);

    /// Sets the speed [m/s] that the hull takes up and the heading [degrees] that it turns to, each
    /// as fast as it can. Values beyond what a track may have are clamped. Throws Error
    /// invalid_value for NaN.
    void want(const TrackCourse& course);
    const TrackCourse& wanted() const { return wanted_; }
    /// Steers by hand for so many seconds: faster and left are -1 .. 1. A rudder that comes back to
    /// 0 holds the heading.
    void steer(double faster, double left, double seconds);

    /// Writes rows until one is at a time or after it. Returns true if there are new ones. A time
    /// before the last row adds none.
    bool advance(double time);

    /// Returns the track, and beyond it the way that the hull will go if nothing is steered: the
    /// wake looks some seconds ahead.
    std::shared_ptr<const HullTrack> planned() const;
    /// Returns the track alone.
    std::shared_ptr<const HullTrack> driven() const {
        return std::make_shared<const HullTrack>(track_);
    }

    /// Returns place and course at a time within the last second.
    struct Pose {
        double x, y;         // [m]
        TrackCourse course;  // at the last row
    };
    Pose pose(double time) const;

  private:
    struct Motion {
        TrackRow row;
        TrackCourse course;
    };
    /// Returns the hull's motion at a later time.
    Motion after(const Motion& at, double time) const;
    double last_time() const { return track_.rows.back().time; }
    Motion last() const { return {track_.rows.back(), track_.courses.back()}; }

    double length_;  // of the hull [m]
    HullTrack track_;
    TrackCourse wanted_{};
    double rudder_ = 0.0;  // 0: the wanted heading
};

/// Returns a hull as one that is driven: with no file of its track, and with a wake whose size does
/// not follow the highest speed of the track, which is not known yet.
Hull hull_to_drive(Hull hull, const Water& water);

}  // namespace ocean
