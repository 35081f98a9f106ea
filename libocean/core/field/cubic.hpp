// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The two cubic kernels for reading maps between their samples. A place lies t of the way, 0 <= t
// <= 1, from the second to the third of four neighbours; each function returns the weights of the
// four, or the derivatives of the weights by t. The weights sum to 1, their derivatives to 0.
//   B-spline     sums coefficients and does not pass through them; two continuous derivatives
//                [Unser 1999]
//   Catmull-Rom  passes through the samples; one continuous derivative [Catmull and Rom 1974]
// Floats and doubles have formulas of their own, because another order of operations would change
// the last bits of every read. Proved in cubic_test.cpp.
#pragma once

#include <array>

namespace ocean {

inline std::array<float, 4> b_spline(float t) {
    const float s = 1.0f - t;
    constexpr float kSixth = 1.0f / 6.0f;
    return {kSixth * s * s * s, kSixth * (t * t * (3.0f * t - 6.0f) + 4.0f),
            kSixth * (s * s * (3.0f * s - 6.0f) + 4.0f), kSixth * t * t * t};
}
inline std::array<float, 4> b_spline_slopes(float t) {
    const float s = 1.0f - t;
    return {-0.5f * s * s, t * (1.5f * t - 2.0f), -s * (1.5f * s - 2.0f), 0.5f * t * t};
}

inline std::array<double, 4> b_spline(double t) {
    const double s = 1.0 - t;
    return {s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
            (1.0 + 3.0 * t + 3.0 * t * t - 3.0 * t * t * t) / 6.0, t * t * t / 6.0};
}
inline std::array<double, 4> b_spline_slopes(double t) {
    const double s = 1.0 - t;
    return {-0.5 * s * s, 0.5 * t * (3.0 * t - 4.0), 0.5 * (1.0 + 2.0 * t - 3.0 * t * t),
            0.5 * t * t};
}

/// The same kernel as polynomials: the weights are the sum of kBSpline[n] t^n. For code that is
/// compiled for one instruction set, which must not share functions with other code.
inline constexpr float kBSpline[4][4] = {{1.0f / 6.0f, 4.0f / 6.0f, 1.0f / 6.0f, 0.0f},
                                         {-0.5f, 0.0f, 0.5f, 0.0f},
                                         {0.5f, -1.0f, 0.5f, 0.0f},
                                         {-1.0f / 6.0f, 0.5f, -0.5f, 1.0f / 6.0f}};

inline std::array<float, 4> catmull_rom(float t) {
    return {-0.5f * t * (1.0f - t) * (1.0f - t), 1.0f + t * t * (1.5f * t - 2.5f),
            t * (0.5f + t * (2.0f - 1.5f * t)), -0.5f * t * t * (1.0f - t)};
}
inline std::array<float, 4> catmull_rom_slopes(float t) {
    return {-0.5f + t * (2.0f - 1.5f * t), t * (4.5f * t - 5.0f), 0.5f + t * (4.0f - 4.5f * t),
            t * (1.5f * t - 1.0f)};
}

}  // namespace ocean
