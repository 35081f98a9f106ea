// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What every backend does: from the modes at one time to planes of real, linear fields. The
// nonlinear fields (normal, Jacobian) are combined from these planes in surface.cpp.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "ocean/modes.hpp"
#include "ocean/surface.hpp"

namespace ocean {

class ThreadPool;

/// Linear fields. D is the horizontal excursion, rates are per second.
enum class Linear : int {
    height,
    excursion_x,
    excursion_y,
    slope_x,
    slope_y,
    gradient_xx,  // dDx/dx
    gradient_yy,
    gradient_xy,
    height_rate,
    excursion_x_rate,
    excursion_y_rate,
};
inline constexpr int kLinearCount = 11;

/// Planes of resolution^2 values, row-major [j][i]; empty where not asked for.
template <typename Real>
struct LinearPlanes {
    std::array<std::vector<Real>, kLinearCount> plane;
    const std::vector<Real>& operator[](Linear field) const {
        return plane[static_cast<std::size_t>(field)];
    }
    std::vector<Real>& operator[](Linear field) { return plane[static_cast<std::size_t>(field)]; }
};

struct SynthesisRequest {
    const Modes& modes;
    double time;
    int resolution;  // of the map; may be more or less than that of the modes
    std::vector<Linear> fields;
};

/// How a field follows from a mode's h or dh/dt: it is multiplied by
/// sign * i^odd * kx^x_power * ky^y_power * (coth(kd)/k)^excursion.
/// Multiplications by i k are derivatives; D = -i (k/|k|) coth(kd) h, [Tessendorf 2001] eq. 44.
struct LinearShape {
    int sign;
    bool odd;
    int x_power;
    int y_power;
    bool excursion;
    bool rate;
};

constexpr LinearShape linear_shape(Linear field) {
    constexpr LinearShape kShapes[kLinearCount] = {
        {1, false, 0, 0, false, false},  // height
        {-1, true, 1, 0, true, false},   // excursion_x
        {-1, true, 0, 1, true, false},   // excursion_y
        {1, true, 1, 0, false, false},   // slope_x
        {1, true, 0, 1, false, false},   // slope_y
        {1, false, 2, 0, true, false},   // gradient_xx
        {1, false, 0, 2, true, false},   // gradient_yy
        {1, false, 1, 1, true, false},   // gradient_xy
        {1, false, 0, 0, false, true},   // height_rate
        {-1, true, 1, 0, true, true},    // excursion_x_rate
        {-1, true, 0, 1, true, true},    // excursion_y_rate
    };
    return kShapes[static_cast<int>(field)];
}

/// Half the number of modes a map of `resolution` holds on each axis: wavenumbers -half+1 ..
/// half-1.
inline int half_band(const Modes& modes, int resolution) {
    return std::min(modes.lattice.resolution, resolution) / 2;
}

/// Direct sums along each axis in double: the judge. N^3 work.
LinearPlanes<double> synthesize_dft(const SynthesisRequest& request, ThreadPool& pool);
/// Full complex radix-2 transforms in float, one field at a time: to be read.
LinearPlanes<float> synthesize_radix2(const SynthesisRequest& request, ThreadPool& pool);
/// The default: half spectrum, vectorised across lines, two real rows per complex line.
LinearPlanes<float> synthesize_cpu(const SynthesisRequest& request, ThreadPool& pool);

}  // namespace ocean
