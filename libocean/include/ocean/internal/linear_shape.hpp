// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The formulas of the linear fields, as one table for every backend without code of its own for
// each.
#pragma once

#include "ocean/channel.hpp"

namespace ocean {

/// The factor by which a field follows from a mode's h or dh/dt:
///     sign * i^odd * kx^x_power * ky^y_power * (coth(kd)/k)^displacement.
/// Multiplications by i k are derivatives; D = -i (k/|k|) coth(kd) h, [Tessendorf 2001] eq. 44.
struct LinearShape {
    int sign;
    bool odd;
    int x_power;
    int y_power;
    bool displacement;
    bool rate;
};

constexpr LinearShape linear_shape(Linear field) {
    constexpr LinearShape kShapes[kLinearCount] = {
        {1, false, 0, 0, false, false},  // height
        {-1, true, 1, 0, true, false},   // displacement_x
        {-1, true, 0, 1, true, false},   // displacement_y
        {1, true, 1, 0, false, false},   // slope_x
        {1, true, 0, 1, false, false},   // slope_y
        {1, false, 2, 0, true, false},   // gradient_xx
        {1, false, 0, 2, true, false},   // gradient_yy
        {1, false, 1, 1, true, false},   // gradient_xy
        {1, false, 0, 0, false, true},   // height_rate
        {-1, true, 1, 0, true, true},    // displacement_x_rate
        {-1, true, 0, 1, true, true},    // displacement_y_rate
    };
    return kShapes[static_cast<int>(field)];
}

}  // namespace ocean
