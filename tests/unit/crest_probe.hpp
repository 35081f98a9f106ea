// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The highest point of a sea's long waves near one of its crests, by sums over all modes.
#pragma once

#include <cmath>

#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "ocean/parameters.hpp"

namespace ocean::test {

/// Takes the waves away that are shorter than a twelfth of those of a frequency [rad/s].
inline Modes long_waves(Modes modes, const Water& water, double peak_omega) {
    const double limit = 12.0 * Dispersion(water).wavenumber(peak_omega);
    for (CascadeModes& cascade : modes.cascades) {
        const int half = cascade.lattice.resolution / 2;
        for (int m = -half; m < half; ++m) {
            for (int n = -half; n < half; ++n) {
                if (std::hypot(n, m) * cascade.lattice.wavenumber_step() < limit) continue;
                cascade.h0[mode_index(n, m, 2 * half)] = 0.0f;
            }
        }
    }
    return modes;
}

/// The highest displayed point near a crest, searched on ever finer grids of labels and times.
struct Highest {
    double height = -1e9;
    double x = 0.0, y = 0.0, time = 0.0;
};

inline Highest highest_near(const Parameters& parameters, const Modes& modes, const Crest& crest,
                            double reach, double span) {
    WaveSum sea(modes, parameters.water, parameters.grid.resolution);
    Highest best{-1e9, crest.x, crest.y, crest.time};
    for (int level = 0; level < 4; ++level) {
        const Highest centre = best;
        for (int step = -2; step <= 2; ++step) {
            const double time = centre.time + span * step / 2.0;
            sea.set_time(time);
            for (int j = -4; j <= 4; ++j) {
                for (int i = -4; i <= 4; ++i) {
                    const double x = centre.x + reach * i / 4.0;
                    const double y = centre.y + reach * j / 4.0;
                    const double height = sea.at_label(x, y).height;
                    if (height > best.height) best = {height, x, y, time};
                }
            }
        }
        reach /= 4.0;
        span /= 3.0;
    }
    return best;
}

}  // namespace ocean::test
