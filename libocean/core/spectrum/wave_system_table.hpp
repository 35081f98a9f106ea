// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One wave system on its way into the table: its frequency density after rescaling, the rows that
// resolve it, and its distribution over directions at each of them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "ocean/parameters.hpp"
#include "ocean/spectrum.hpp"

namespace ocean {

struct WaveSystemTable {
    /// Angular frequencies between which linear interpolation of this system is good enough.
    std::vector<double> rows;
    /// m^2 s/rad of each row; 0 outside them.
    std::vector<double> density;
    int directions = 0;
    /// Exact integral of the density, m^2.
    double m0 = 0.0;
    /// The distribution over `directions` directions of a row: sums to 1 times directions / 2 pi.
    /// Several threads may call it.
    std::function<void(std::size_t row, std::span<double> distribution)> spreading;
};

/// `highest` bounds the frequencies of parametric systems. A flat system has no rows.
WaveSystemTable make_wave_system_table(const WaveSystem& system, const Water& water,
                                       double highest);

/// The values of a wave system's optional parameters while they are unset.
struct NaturalScale {
    double height = 0.0;     // m, significant
    double period = 0.0;     // s, of the peak; NaN for a flat system
    double direction = 0.0;  // degrees
};
NaturalScale natural_scale(const WaveSystem& system, const Water& water, double highest);
NaturalScale natural_measured_scale(const WaveSystem& system);

/// The bound of parametric systems on a grid.
double highest_frequency(const Parameters& parameters);

/// Rescaling of [[waves]]: the period stretches the spectrum at constant energy,
/// S'(omega) = S(omega / r) / r with r = new peak / old peak; the height scales it.
struct Rescaling {
    double stretch = 1.0;
    double energy = 1.0;
};
Rescaling make_rescaling(const WaveSystem& system, double peak, double m0);

/// The measured kind: linear between the record's frequencies, nothing beyond them.
WaveSystemTable make_measured_table(const WaveSystem& system, const Water& water);

}  // namespace ocean
