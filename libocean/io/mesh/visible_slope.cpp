// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See visible_slope.hpp; shaders/wave has the formula and its derivation.
#include "ocean/internal/io/visible_slope.hpp"

#include "wave/wave.hpp"

namespace ocean::io {

double mean_visible_slope(double slope_rms, double elevation_slope) {
    return wave::double_precision::visible_lean(slope_rms, elevation_slope);
}

}  // namespace ocean::io
