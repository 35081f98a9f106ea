// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea file, resolved: what a host opens. Self-contained: the chosen buoy record is inside.
#pragma once

#include "ocean/parameters.hpp"
#include "ocean/take.hpp"

namespace ocean {

struct Sea {
    Parameters parameters;
    Take take = {};

    /// The parameters at a time: those of the file, and the take's changes up to then, each gliding
    /// to its value by a one-pole filter of time.glide seconds. A pure function: any frame alone.
    Parameters at(double time) const;

    /// start + (frame - first_frame) / fps, in seconds; never from the asked range, never summed.
    double time_of(double frame) const;
};

}  // namespace ocean
