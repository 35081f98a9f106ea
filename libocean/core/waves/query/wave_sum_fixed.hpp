// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The part of a WaveSum that does not change with time, shared by its copies. k and -k are one
// term, so that half the plane suffices, and only its blocks of neighbouring modes that have waves
// are kept.
#pragma once

#include <cstddef>
#include <vector>

#include "ocean/internal/modes.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

/// Modes are added up side by side in this number of lanes, in an order that no compiler changes.
inline constexpr std::size_t kLanes = 4;

struct WaveSum::Fixed {
    struct Wavenumbers {
        double period;       // m, of the cascade
        int half;            // modes -half .. half - 1
        std::size_t column;  // of n = -half, in the table along x
        std::size_t row;     // of m = 0, in the table along y
    };

    /// Neighbours in a row, a multiple of kLanes; modes without waves between them have h0 = 0.
    struct Run {
        std::size_t begin;  // in the arrays of modes
        std::size_t end;
        std::size_t column;  // of the first mode, in the table along x
        std::size_t row;
    };

    Water water;
    Modes clock;  // without arrays: converts time to tau
    std::vector<Wavenumbers> cascades;
    std::vector<double> kx, ky;  // of the columns and rows of the tables [rad/m]
    std::vector<Run> runs;
    // The modes of all runs, one run after another:
    std::vector<float> h0_re, h0_im, mirror_re, mirror_im;  // [m]
    std::vector<double> rate;                               // turns per unit of tau
    std::vector<float> displacement;                        // coth(kd) / k [m]

    double displacement_rms = 0.0;  // m

    Fixed(const Modes& modes, const Water& water, int resolution);
    std::size_t size() const { return rate.size(); }
    double omega(std::size_t mode) const { return kTwoPi * clock.rate_unit() * rate[mode]; }

  private:
    void add_cascade(const CascadeModes& cascade, double limit);
    void add_row(const CascadeModes& cascade, int m, double limit);
    double mean_square_displacement() const;
};

}  // namespace ocean
