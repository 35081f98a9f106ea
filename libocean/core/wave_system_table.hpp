// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One wave system on its way into the table: its frequency density after rescaling, the rows that
// resolve it, and its directional density at any of the rows of all systems together.
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
    int directions = 0;
    /// Exact integral of the density, m^2.
    double m0 = 0.0;
    /// m^2 s/rad at any omega, 0 outside the support.
    std::function<double(double omega)> density;
    /// The distribution over directions at omega: sums to 1 times `row.size()` / 2 pi.
    std::function<void(double omega, std::span<double> row)> spreading;
};

/// `highest` bounds the frequencies of parametric systems. A flat system has no rows.
WaveSystemTable make_wave_system_table(const WaveSystem& system, const Water& water,
                                       double highest);

/// What a wave system's optional parameters stand for while they are unset.
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
