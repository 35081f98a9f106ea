// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea file, resolved: what a host opens. Self-contained: the chosen buoy record is inside.
#pragma once

#include "ocean/parameters.hpp"

namespace ocean {

struct Sea {
    Parameters parameters;

    /// start + (frame - first_frame) / fps, in seconds; never from the asked range, never summed.
    double time_of(double frame) const;
};

}  // namespace ocean
