// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The clock of a sea: which time a frame shows.
#include "ocean/sea.hpp"

namespace ocean {

Parameters Sea::at(double) const {
    return parameters;
}

double Sea::time_of(double frame) const {
    const Timing& time = parameters.time;
    return time.start + (frame - time.first_frame) / time.fps;
}

}  // namespace ocean
