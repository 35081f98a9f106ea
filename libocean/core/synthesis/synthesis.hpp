// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What every backend does: from the modes at one time to planes of real, linear fields. The
// nonlinear fields (normal, Jacobian) are combined from these planes in surface.cpp.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "ocean/modes.hpp"
#include "ocean/surface.hpp"

namespace ocean {

class ThreadPool;

/// The modes of a map: those of a whole sea, or of one of its cascades over its own period.
struct SynthesisRequest {
    std::span<const CascadeModes> cascades;
    double period;     // of the map, m
    int divisor;       // patch_size / period
    double tau;        // of Modes
    double rate_unit;  // of Modes
    int resolution;    // of the map; may be more or less than that of the modes
    std::vector<Linear> fields;

    double wavenumber_step() const { return kTwoPi / period; }
    /// Mode (n, m) of a cascade is mode (n, m) * stride(cascade) of the map.
    int stride(const CascadeModes& cascade) const { return cascade.divisor / divisor; }
    /// The map holds the modes -half + 1 .. half - 1 of a cascade along each axis.
    int half(const CascadeModes& cascade) const {
        const int below_nyquist = (resolution / 2 - 1) / stride(cascade) + 1;
        return std::min(cascade.lattice.resolution / 2, below_nyquist);
    }
    /// Of the map itself: its modes beyond -half_band + 1 .. half_band - 1 are zero.
    int half_band() const {
        int half_band = 0;
        for (const CascadeModes& cascade : cascades) {
            half_band = std::max(half_band, (half(cascade) - 1) * stride(cascade) + 1);
        }
        return half_band;
    }
};

/// All modes of a sea.
inline SynthesisRequest synthesis_request(const Modes& modes, double time, int resolution,
                                          std::vector<Linear> fields) {
    return {modes.cascades, modes.lattice.period, 1, modes.tau(time), modes.rate_unit(),
            resolution,     std::move(fields)};
}

/// How a field follows from a mode's h or dh/dt: it is multiplied by
/// sign * i^odd * kx^x_power * ky^y_power * (coth(kd)/k)^displacement.
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

/// Direct sums along each axis in double: the judge. N^3 work.
LinearPlanes<double> synthesize_dft(const SynthesisRequest& request, ThreadPool& pool);
/// Full complex radix-2 transforms in float, one field at a time: to be read.
LinearPlanes<float> synthesize_radix2(const SynthesisRequest& request, ThreadPool& pool);
/// The default: half spectrum, vectorised across lines, two real rows per complex line.
LinearPlanes<float> synthesize_cpu(const SynthesisRequest& request, ThreadPool& pool);

}  // namespace ocean
