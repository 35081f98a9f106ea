// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How much light the surface of water reflects, seen from above.

// Fresnel's reflectance of unpolarised light at cosine c of the angle of incidence, from air to a
// refractive index n.
formula real water_reflectance(real c, real n) {
    real g = sqrt(n * n - real(1.0) + c * c);
    real a = (g - c) / (g + c);
    real b = (c * (g + c) - real(1.0)) / (c * (g - c) + real(1.0));
    return real(0.5) * a * a * (real(1.0) + b * b);
}

// Returns the reflectance of water whose unresolved slopes have that deviation along the view: the
// fit of [Bruneton 2010] to the mean over the facets, c the cosine to the mean normal. At grazing
// angles rough water reflects less, because only slopes towards the viewer are visible.
formula real rough_water_reflectance(real c, real slope_rms) {
    real power = real(5.0) * exp(real(-2.69) * slope_rms);
    real spread = real(1.0) + real(22.7) * slope_rms * sqrt(slope_rms);
    return real(0.02) + real(0.98) * pow(max(real(1.0) - c, real(0.0)), power) / spread;
}
