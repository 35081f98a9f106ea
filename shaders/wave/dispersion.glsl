// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Linear dispersion of gravity-capillary waves over a flat bottom. One code path: deep water and
// pure gravity waves are its limits. Symbols: k wavenumber [rad/m] > 0, g gravity [m/s^2],
// s surface tension / density [m^3/s^2], depth [m], may be infinite.

// Beyond kd = 20 tanh is 1 to the last bit of a double; the clamp keeps cosh finite in float.
formula real clamped_depth(real k, real depth) {
    return min(k * depth, real(20.0));
}

// omega = sqrt((g k + s k^3) tanh(k d)) [rad/s]. [Lamb 1932] art. 267; [Horvath 2015] eq. 6 to 8.
// Limits: deep sqrt(g k); shallow k sqrt(g d). Proved in dispersion_test.cpp.
formula real angular_frequency(real k, real g, real s, real depth) {
    return sqrt((g * k + s * k * k * k) * tanh(clamped_depth(k, depth)));
}

// c_g = d omega / d k = ((g + 3 s k^2) tanh(kd) + k d (g + s k^2) sech^2(kd)) / (2 omega),
// with one factor k d written as clamped. [Horvath 2015] eq. 13 to 15. Deep limit: g / (2 omega).
formula real group_velocity(real k, real g, real s, real depth) {
    real kd = clamped_depth(k, depth);
    real sech = real(1.0) / cosh(kd);
    real omega = angular_frequency(k, g, s, depth);
    return ((g + real(3.0) * s * k * k) * tanh(kd) + kd * (g + s * k * k) * sech * sech) /
           (real(2.0) * omega);
}

// How far a water particle at the surface moves sideways for one metre of height: coth(k d),
// 1 in deep water. [Dean and Dalrymple 1991] eq. 4.46 at z = 0.
formula real horizontal_displacement(real k, real depth) {
    return real(1.0) / tanh(clamped_depth(k, depth));
}
