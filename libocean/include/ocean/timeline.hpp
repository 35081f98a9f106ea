// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The times of frames.
#pragma once

namespace ocean {

struct Sea;

/// The times of a subject's frames. The default is the timeline of a subject that does not move.
struct Timeline {
    bool moves = false;
    double start = 0.0;  // of the first frame [s]
    int first_frame = 1;
    double frame_rate = 24.0;  // [1/s]
    /// True: parameters change with time, so that maps of different times differ in more than the
    /// phase of their waves.
    bool plays_take = false;

    /// Returns the time of a frame [s]: 0 for a subject that does not move.
    double time_of(double frame) const {
        return moves ? start + (frame - first_frame) / frame_rate : 0.0;
    }
};
/// Returns the timeline of a sea.
Timeline timeline_of(const Sea& sea);

}  // namespace ocean
