// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The decay of a wave's motion with depth, shared by queries and gauges.
#pragma once

#include <cmath>

namespace ocean {

/// At z <= 0 above the bottom, z up from still water: cosh k(z+d) / sinh kd for the motion along
/// the wave, and sinh k(z+d) / sinh kd for the motion up and down. k > 0. [Dean and Dalrymple 1991]
/// eq. 3.30. Limits: e^(kz) both in deep water; upright 0 at the bottom.
struct OrbitalDecay {
    double along;
    double upright;
};

/// Returns the decay with only exponents <= 0, so that nothing overflows: cosh k(z+d) / sinh kd =
/// e^(kz) (1 + e^(-2k(z+d))) / (1 - e^(-2kd)), and sinh with a minus sign.
inline OrbitalDecay orbital_decay(double k, double z, double depth) {
    const double part = std::exp(k * z) / -std::expm1(-2.0 * k * depth);
    const double reflected = -2.0 * k * (z + depth);
    return {part * (1.0 + std::exp(reflected)), part * -std::expm1(reflected)};
}

}  // namespace ocean
