// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the label shown at a place: solves a - C D(a) = x for the label a, where C is the
// choppiness and D the horizontal displacement. A surface without a fold has one solution, a folded
// one three or more. The signs of their Jacobians add up to 1, so that one of them has J < 0.
//
// A source is any function that returns, at a label (x, y), a DisplacementSample or more.
#pragma once

#include <algorithm>
#include <cmath>

#include "ocean/internal/wave_sum.hpp"

namespace ocean {

struct InversionTarget {
    double x, y;  // m, the place
    double choppiness;
    double reach;      // max distance of a label from its shown point [m]
    double tolerance;  // m, residual of a solution

    /// Returns the target at a point. `reach` must be positive in a sea that moves.
    static InversionTarget at(double x, double y, double choppiness, double reach) {
        return {x, y, choppiness, reach, kTolerance * reach};
    }
    /// Relative to the reach: the accuracy of a displacement in single precision, with a margin.
    static constexpr double kTolerance = 2e-6;
};

struct ShownLabel {
    double x, y;      // m
    double jacobian;  // of the displayed surface
    bool converged;
};

/// Returns a solution near one start, by Newton's method; where it wanders or meets a fold, by the
/// damped fixed point a <- a - (a - C D(a) - x) / 2 and then Newton's method again. Evaluates the
/// source at most 40 times. If no label was good enough, returns the last one, which is finite.
template <typename Source>
ShownLabel find_label(const Source& source, const InversionTarget& target, double start_x,
                      double start_y) {
    constexpr int kSteps = 40;
    constexpr int kPatience = 12;   // Newton steps before and after the fixed point
    constexpr double kFlat = 0.01;  // |J| below which Newton's step is not trusted
    const double longest_step = 0.5 * target.reach;
    const double c = target.choppiness;
    ShownLabel label{start_x, start_y, 1.0, false};
    for (int step = 1;; ++step) {
        const auto displacement = source(label.x, label.y);
        const double fx = label.x - c * displacement.displacement_x - target.x;
        const double fy = label.y - c * displacement.displacement_y - target.y;
        const double xx = 1.0 - c * displacement.gradient_xx;
        const double yy = 1.0 - c * displacement.gradient_yy;
        const double xy = c * displacement.gradient_xy;
        label.jacobian = xx * yy - xy * xy;
        label.converged = fx * fx + fy * fy <= target.tolerance * target.tolerance;
        if (label.converged || step == kSteps) return label;

        const bool wandering = step > kPatience && step <= kSteps - kPatience;
        double dx = 0.5 * fx;
        double dy = 0.5 * fy;
        if (!wandering && std::abs(label.jacobian) > kFlat) {
            dx = (yy * fx + xy * fy) / label.jacobian;
            dy = (xy * fx + xx * fy) / label.jacobian;
        }
        const double limit = std::min(1.0, longest_step / std::sqrt(dx * dx + dy * dy));
        label.x -= limit * dx;
        label.y -= limit * dy;
    }
}

}  // namespace ocean
