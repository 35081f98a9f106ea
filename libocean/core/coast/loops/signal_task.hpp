// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of the loop that reads the signal of one band and sector at places: plain data, so that
// the files compiled for one instruction set need nothing of the standard library.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/simd/simd_level.hpp"

namespace ocean {

/// The outputs of a read, a value for each place. nullptr: not requested.
struct SignalOutputs {
    float* re = nullptr;  // [m]
    float* im = nullptr;
    float* re_x = nullptr;  // the gradient, [m/m]
    float* im_x = nullptr;
    float* re_y = nullptr;
    float* im_y = nullptr;
    float* re_t = nullptr;  // the rate [m/s]
    float* im_t = nullptr;

    bool has_value() const { return re != nullptr || im != nullptr; }
    bool has_gradient() const {
        return re_x != nullptr || im_x != nullptr || re_y != nullptr || im_y != nullptr;
    }
    bool has_rate() const { return re_t != nullptr || im_t != nullptr; }
};

/// Coefficients of a spline in rows of `pitch` complex numbers: one before the first column, all
/// columns, three after the last, so that the four beside a place are neighbours.
struct SignalMap {
    const float* values;
    std::size_t pitch;
};

struct SignalTask {
    std::size_t count;
    const double* x;  // finite places [m]
    const double* y;
    double cells_per_metre[2];
    std::uint32_t mask[2];  // the columns and the rows, powers of two, less 1
    double half_turns[2];   // of the carrier, along x and y [1/m]
    SignalMap value;
    SignalMap rate;  // not read unless a rate is requested
    SignalOutputs out;
};

using SignalLoop = void (*)(const SignalTask&);

/// Returns the loop of an instruction set that is compiled in. All give the same bits.
SignalLoop signal_loop(SimdLevel level);

}  // namespace ocean
