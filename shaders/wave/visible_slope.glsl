// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The effect of waves too small to be displayed on light. Seen at a grazing angle, a rough surface
// shows the facets that lean towards the eye and hides the others; a horizon drawn with the mean
// normal mirrors the palest part of the sky and is far too bright.
//
// Let u = -slope towards the eye, the lean of a facet; Gaussian with variance s^2. Let t be the
// tangent of the eye's elevation above the mean surface. Per area of mean surface the eye sees
// max(0, t + u) cos(elevation) of a facet; shadowing by other facets hardly depends on u [Smith
// 1967], [Ross 2005], so the visible leans have the density
//     p(u) max(0, t + u) / E[max(0, t + u)].
// With a = t/s, phi and Phi the normal density and distribution:
//     E[max(0, t + u)]   = t Phi(a) + s phi(a)
//     E[u max(0, t + u)] = s^2 Phi(a)                       (Stein: E[u f(u)] = s^2 E[f'(u)])
// and their ratio is the mean visible lean, s / (a + phi(a) / Phi(a)).
// Limits: t -> 0 gives s sqrt(pi/2); t >> s gives s^2 / t, which tends to 0; t << -s gives -t, just
// the lean that is visible at all. In two dimensions, with slope covariance V and e the horizontal
// direction to the eye, the same steps give s^2 = e.V e and the vector V e / s^2 times that mean.
// Test: VisibleSlope.EqualsMonteCarlo.
//
// C++ has erfc in its library; GLSL takes it from wave/erfc.glsl.

formula real normal_density(real a) {
    return exp(real(-0.5) * a * a) * real(0.398942280401432678);
}

formula real normal_distribution(real a) {
    return real(0.5) * erfc(a * real(-0.707106781186547524));
}

// a + phi(a)/Phi(a). Far below zero both terms cancel: there its asymptotic series, right to 1e-5:
// phi/Phi(-b) = b + 1/b - 2/b^3 + 10/b^5 - ... [Abramowitz and Stegun 1964] 26.2.12.
formula real excess_over_mills(real a) {
    if (a < real(-12.0)) {
        return (real(-1.0) + (real(2.0) - real(10.0) / (a * a)) / (a * a)) / a;
    }
    return a + normal_density(a) / normal_distribution(a);
}

// Mean lean towards the eye of the facets that it sees.
formula real visible_lean(real slope_rms, real elevation_slope) {
    if (slope_rms <= real(0.0)) return real(0.0);
    return slope_rms / excess_over_mills(elevation_slope / slope_rms);
}

// E[max(0, t + u)]: area of the facets that the eye sees over cos(elevation), per area of mean
// surface; t where the surface is smooth.
formula real visible_area(real slope_rms, real elevation_slope) {
    if (slope_rms <= real(0.0)) return max(elevation_slope, real(0.0));
    real a = elevation_slope / slope_rms;
    return elevation_slope * normal_distribution(a) + slope_rms * normal_density(a);
}

// Variance of the leans that are seen: E[u^2 max(0, t + u)] = s^2 (t Phi(a) + 2 s phi(a)). Far
// below zero the leans are those of an exponential's tail.
formula real visible_lean_variance(real slope_rms, real elevation_slope) {
    if (slope_rms <= real(0.0)) return real(0.0);
    real a = elevation_slope / slope_rms;
    real variance = slope_rms * slope_rms;
    if (a < real(-8.0)) return real(2.0) * variance / (a * a);
    real area = a * normal_distribution(a) + normal_density(a);
    real lean = normal_distribution(a) / area;
    return variance * (real(1.0) + normal_density(a) / area - lean * lean);
}
