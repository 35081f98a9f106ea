// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The displayed surface at one label, and what follows from it: normal and Jacobian.
#pragma once

#include <array>
#include <cmath>

#include "field/jet.hpp"

namespace ocean {

/// The surface at one label. A point is displayed at its label plus (dx, dy).
struct LabelPoint {
    Jet height;  // over still water [m]
    Jet dx, dy;  // offset of the displayed point, choppiness included [m]
};

/// Returns the Jacobian of the displayed surface: below 0 it has folded over.
inline float label_jacobian(const LabelPoint& point) {
    return (1.0f + point.dx.by_x()) * (1.0f + point.dy.by_y()) - point.dx.by_y() * point.dy.by_x();
}

/// Returns the cross product of the tangents of the displayed surface along x and y.
inline std::array<float, 3> label_cross(const LabelPoint& point) {
    const float xx = 1.0f + point.dx.by_x();
    const float yx = point.dy.by_x();
    const float zx = point.height.by_x();
    const float xy = point.dx.by_y();
    const float yy = 1.0f + point.dy.by_y();
    const float zy = point.height.by_y();
    return {yx * zy - zx * yy, zx * xy - xx * zy, xx * yy - yx * xy};
}

/// Returns the unit normal of the displayed surface at a label, on the side seen from above.
inline std::array<float, 3> label_normal(const LabelPoint& point) {
    const auto [nx, ny, nz] = label_cross(point);
    const float length = std::sqrt(nx * nx + ny * ny + nz * nz);
    if (!(length > 0.0f)) return {0.0f, 0.0f, 1.0f};
    const float scale = (nz < 0.0f ? -1.0f : 1.0f) / length;
    return {scale * nx, scale * ny, scale * nz};
}

}  // namespace ocean
