// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How much foam varies from point to point where its cover is even: the rule of docs/foam.md.
#pragma once

#include <algorithm>
#include <cmath>

#include "wave/wave.hpp"

namespace ocean::test {

/// Returns the variance of foam_faded(foam_mask(cover, T, edge of the pixel), cover) over uniform
/// values T. Within half an edge of 0 the mask is a triangle of the height sqrt(2 s / e), whose
/// square has the mean e/3 (2 s / e)^(3/2); further on c - e/6. footprint and cell: [m].
inline double foam_variance(double cover, double edge, double footprint, double cell) {
    namespace formula = wave::double_precision;
    const double e = formula::foam_pixel_edge(edge, footprint, cell);
    const double s = std::min(cover, 1.0 - cover);
    const double square = s < 0.5 * e ? e / 3.0 * std::pow(2.0 * s / e, 1.5) : s - e / 6.0;
    const double shown = 1.0 - formula::foam_fade(footprint, cell);
    return shown * shown * (square - s * s);
}

}  // namespace ocean::test
