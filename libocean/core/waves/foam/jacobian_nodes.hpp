// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The distribution of the Jacobian at a label: the gradients as sums of independent normal numbers,
// and nodes over two of them at which J is linear in the third.
#pragma once

#include <vector>

#include "ocean/internal/modes.hpp"

namespace ocean {

/// Returns the angle from +x of the axis along which waves compress the surface most [rad]; along
/// the perpendicular axis they compress it least.
double principal_angle(const GradientCovariance& covariance);

/// a, b and c as sums of three standard normals: b = b1 x, c = c1 x + c2 y, a = a1 x + a2 y + a3 z.
/// A direction without variance has a factor of 0.
struct GradientFactors {
    double b1, c1, c2, a1, a2, a3;

    explicit GradientFactors(const GradientCovariance& covariance);
};

/// With x and y given, J = (1 - C a)(1 - C b) - C^2 c^2 is mean + slope z: Gaussian.
struct JacobianNode {
    double x, y;
    double mean, slope;
    double weight;  // of (x, y); the weights sum to 1
};

/// Returns the nodes of the trapezoid rule over x and y, which converges faster than any power of
/// its spacing, as long as the deviation of J spans a few of them. If `a` alone hardly varies (two
/// crossing swells), the nodes are closer. `covariance` must be in its principal axes.
std::vector<JacobianNode> jacobian_nodes(const GradientCovariance& covariance, double choppiness);

/// Returns the covariance seen from axes turned to the principal direction of the waves. J is a
/// determinant and does not change; a long-crested sea becomes a sea of `a` alone.
GradientCovariance in_principal_axes(const GradientCovariance& covariance);

}  // namespace ocean
