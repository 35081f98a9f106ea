// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Polynomials that rise from 0 at t = 0 to 1 at t = 1. Real is a float, a double, or a number that
// carries derivatives (jet.hpp). The polynomials do not clamp t.
#pragma once

#include <algorithm>

namespace ocean {

/// Returns 3 t^2 - 2 t^3, whose slope is 0 at both ends.
template <typename Real>
Real ease_cubic(const Real& t) {
    return t * t * (Real(3.0) - Real(2.0) * t);
}

/// Returns 10 t^3 - 15 t^4 + 6 t^5, whose slope and curvature are 0 at both ends.
template <typename Real>
Real ease_quintic(const Real& t) {
    return t * t * t * (t * (Real(6.0) * t - Real(15.0)) + Real(10.0));
}

/// Returns 0 up to x = a, 1 from b on, and ease_quintic between them. a may exceed b.
inline double ease(double a, double b, double x) {
    return ease_quintic(std::clamp((x - a) / (b - a), 0.0, 1.0));
}

/// Returns the integral of ease(0, 1, t) from 0 to t.
inline double ease_integral(double t) {
    if (t <= 0.0) return 0.0;
    if (t >= 1.0) return t - 0.5;
    return t * t * t * t * (t * (t - 3.0) + 2.5);
}

}  // namespace ocean
