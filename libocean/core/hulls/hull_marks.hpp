// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The marks of a hull beside its waves at one time: the white water of its turbulent trail, which
// stays where the hull was, and the inside of its water line, where no water is.
#pragma once

#include <vector>

#include "hulls/track_path.hpp"
#include "ocean/parameters.hpp"
#include "ocean/query.hpp"

namespace ocean {

class HullMarks {
  public:
    /// The hull must be valid. loop_period: of the sea.
    HullMarks(const Hull& hull, double loop_period);

    /// Begins a time [s].
    void move_to(double time);

    /// Returns the share of the water at a label that the trail hides, 0 .. 1.
    float trail(WorldPoint label) const;
    /// Returns 1 at a displayed place inside the water line, 0 outside, and 0.5 on the line; it
    /// falls within a tenth of the beam, so that the line can be read between samples.
    float inside(WorldPoint place) const;

  private:
    /// A straight piece of the stern's way.
    struct Piece {
        PathVector from, way;
        double reach;         // length of the way [m]
        double age, seconds;  // at `from`, and of the way [s]
        double astern;        // way from `from` to the stern now [m]
        double share;         // of foam where it is fresh
        double margin;        // half the width of the trail at most [m]
    };
    struct Box {
        PathVector low, high;

        bool holds(WorldPoint place) const {
            return place.x >= low.x && place.x <= high.x && place.y >= low.y && place.y <= high.y;
        }
        void widen(PathVector place, double margin);
    };
    /// Pieces that follow each other, with the box that holds their trail.
    struct Group {
        Box box;
        std::size_t first, end;
    };

    double half_width(double astern) const;
    void gather();

    TrackPath path_;
    double length_, beam_, lifetime_;
    std::vector<Piece> pieces_;
    std::vector<Group> groups_;
    Box all_;  // of the groups
    PathVector place_, heading_;
};

}  // namespace ocean
