// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The lean of the facets that are seen: the formula and its derivation are shaders/wave's.
#include "ocean/io/visible_slope.hpp"

#include "wave/wave.hpp"

namespace ocean::io {

double mean_visible_slope(double slope_rms, double elevation_slope) {
    return wave::double_precision::visible_lean(slope_rms, elevation_slope);
}

}  // namespace ocean::io
