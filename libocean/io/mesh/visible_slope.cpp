// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What waves too small for the mesh do to the light. Seen at a grazing angle, a rough surface shows
// the facets that lean towards the eye and hides the others; a horizon drawn with the mean normal
// is a mirror of the palest sky, and far too bright.
//
// Let u = -slope towards the eye, the lean of a facet; Gaussian with variance s^2. Let t be the
// tangent of the eye's elevation above the mean surface. Per area of mean surface the eye sees of a
// facet max(0, t + u) cos(elevation); shadowing by other facets hardly depends on u [Smith 1967],
// [Ross 2005], so the leans that are seen have the density
//     p(u) max(0, t + u) / E[max(0, t + u)].
// With a = t/s, phi and Phi the normal density and distribution:
//     E[max(0, t + u)]   = t Phi(a) + s phi(a)
//     E[u max(0, t + u)] = s^2 Phi(a)                       (Stein: E[u f(u)] = s^2 E[f'(u)])
// and their ratio is the mean lean that is seen, s / (a + phi(a) / Phi(a)).
// Limits: t -> 0 gives s sqrt(pi/2); t >> s gives s^2 / t, nothing in the end; t << -s gives -t,
// just the lean that is needed to be seen at all. In two dimensions, with slope covariance V and e
// the horizontal direction to the eye, the same steps give s^2 = e.V e and the vector V e / s^2
// times that mean. [Bruneton 2010] carries the same variance into a BRDF; a mesh has only normals.
// Test: VisibleSlope.EqualsMonteCarlo.
#include "ocean/io/visible_slope.hpp"

#include <cmath>

#include "ocean/grid.hpp"

namespace ocean::io {
namespace {

// a + phi(a)/Phi(a). Far below zero both terms cancel: there its asymptotic series, right to 1e-5:
// phi/Phi(-b) = b + 1/b - 2/b^3 + 10/b^5 - ... [Abramowitz and Stegun 1964] 26.2.12.
double excess_over_mills(double a) {
    if (a < -12.0) return (-1.0 + (2.0 - 10.0 / (a * a)) / (a * a)) / a;
    const double density = std::exp(-0.5 * a * a) / std::sqrt(kTwoPi);
    const double distribution = 0.5 * std::erfc(-a / std::sqrt(2.0));
    return a + density / distribution;
}

}  // namespace

double mean_visible_slope(double slope_rms, double elevation_slope) {
    if (slope_rms <= 0.0) return 0.0;
    return slope_rms / excess_over_mills(elevation_slope / slope_rms);
}

}  // namespace ocean::io
