// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rings of equal ratio in the wavenumber plane, and sums over their waves.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ocean/internal/grid.hpp"

namespace ocean {

/// The rings [lowest ratio^i, lowest ratio^(i + 1)) below `end` [rad/m].
struct RingEdges {
    double lowest;
    double end;
    int per_octave;

    int count() const {
        constexpr double kRounding = 1e-9;
        const double rings = std::log2(end / lowest) * per_octave;
        return std::max(1, static_cast<int>(std::ceil(rings - kRounding)));
    }
    /// Returns the ring of a wavenumber, or -1 if no ring has it.
    int ring_of(double k) const {
        if (k < lowest || k >= end) return -1;
        return std::min(static_cast<int>(std::log2(k / lowest) * per_octave), count() - 1);
    }
};

/// Sums over the waves of a ring.
struct RingSums {
    double density = 0.0;
    double log_k = 0.0;
    double weight = 0.0;

    void add(double s, double logarithm, double w) {
        density += w * s;
        log_k += w * logarithm;
        weight += w;
    }
    void add(const RingSums& other) {
        density += other.density;
        log_k += other.log_k;
        weight += other.weight;
    }
};

/// Returns the weights of a Hann window along one side, or 1 everywhere.
inline std::vector<double> taper_weights(int samples, bool hann) {
    std::vector<double> weights(static_cast<std::size_t>(samples), 1.0);
    if (!hann) return weights;
    for (int i = 0; i < samples; ++i) {
        weights[static_cast<std::size_t>(i)] = 0.5 - 0.5 * std::cos(kTwoPi * (i + 0.5) / samples);
    }
    return weights;
}

}  // namespace ocean
