// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One wave system on its way into the table: its frequency density after rescaling, the rows that
// resolve it, and its distribution over directions at each of them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "ocean/internal/spectrum.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

struct WaveSystemTable {
    /// Angular frequencies between which linear interpolation of this system is accurate enough.
    std::vector<double> rows;
    /// Density of each row [m^2 s/rad]; 0 outside the rows.
    std::vector<double> density;
    int directions = 0;
    /// Exact integral of the density [m^2].
    double m0 = 0.0;
    /// Writes the distribution over `directions` directions of a row: its sum times 2 pi /
    /// directions is 1. Several threads may call it.
    std::function<void(std::size_t row, std::span<double> distribution)> spreading;
};

/// Returns the table of a wave system. `highest` bounds the frequencies of parametric systems. A
/// flat system has no rows.
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

/// Returns the bound of the frequencies of parametric systems on a grid [rad/s].
double highest_frequency(const Parameters& parameters);

/// Rescaling of [[waves]]: the period stretches the spectrum at constant energy,
/// S'(omega) = S(omega / r) / r with r = new peak / old peak; the height scales it.
struct Rescaling {
    double stretch = 1.0;
    double energy = 1.0;
};
Rescaling make_rescaling(const WaveSystem& system, double peak, double m0);

/// Returns the table of a measured system: linear between the record's frequencies, 0 beyond them.
WaveSystemTable make_measured_table(const WaveSystem& system, const Water& water);

}  // namespace ocean
