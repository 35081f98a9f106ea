// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes of a WaveSum, row by row in blocks; see wave_sum_fixed.hpp.
#include "waves/query/wave_sum_fixed.hpp"

#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>

namespace ocean {

namespace {

/// A mode (n, m) and its mirror, in the form that the sum reads.
struct ModePair {
    std::complex<float> h0;
    std::complex<float> mirror;
    std::size_t at;
    bool empty() const { return h0 == 0.0f && mirror == 0.0f; }
};

ModePair mode_pair(const CascadeModes& cascade, int n, int m, double limit) {
    const int size = cascade.lattice.resolution;
    const int half = size / 2;
    const bool upper = m > 0 || (m == 0 && n > 0);
    const bool held = std::abs(n) * cascade.divisor < limit && m * cascade.divisor < limit;
    if (!upper || !held || n == -half) return {};
    const std::size_t at = mode_index(n, m, size);
    return {cascade.h0[at], cascade.h0[mode_index(-n, -m, size)], at};
}

}  // namespace

WaveSum::Fixed::Fixed(const Modes& modes, const Water& sea_water, int resolution)
    : water(sea_water) {
    clock.loop_period = modes.loop_period;
    const double limit = resolution > 0 ? 0.5 * resolution : std::numeric_limits<double>::max();
    for (const CascadeModes& cascade : modes.cascades) add_cascade(cascade, limit);
    displacement_rms = std::sqrt(mean_square_displacement());
}

void WaveSum::Fixed::add_cascade(const CascadeModes& cascade, double limit) {
    const int half = cascade.lattice.resolution / 2;
    const double step = cascade.lattice.wavenumber_step();
    cascades.push_back({cascade.lattice.period, half, kx.size(), ky.size()});
    for (int n = -half; n < half; ++n) kx.push_back(step * n);
    for (int m = 0; m < half; ++m) {
        ky.push_back(step * m);
        add_row(cascade, m, limit);
    }
}

// In blocks of kLanes: blocks without waves are dropped, and neighbouring blocks become one run.
void WaveSum::Fixed::add_row(const CascadeModes& cascade, int m, double limit) {
    const Wavenumbers& wavenumbers = cascades.back();
    std::size_t next_column = 0;  // column after the last kept block
    for (int n0 = -wavenumbers.half; n0 < wavenumbers.half; n0 += static_cast<int>(kLanes)) {
        ModePair block[kLanes];
        bool empty = true;
        for (std::size_t l = 0; l < kLanes; ++l) {
            block[l] = mode_pair(cascade, n0 + static_cast<int>(l), m, limit);
            empty = empty && block[l].empty();
        }
        if (empty) continue;
        const std::size_t column =
            wavenumbers.column + static_cast<std::size_t>(n0 + wavenumbers.half);
        if (runs.empty() || column != next_column || runs.back().row != ky.size() - 1) {
            runs.push_back({size(), size(), column, ky.size() - 1});
        }
        for (const ModePair& pair : block) {
            h0_re.push_back(pair.h0.real());
            h0_im.push_back(pair.h0.imag());
            mirror_re.push_back(pair.mirror.real());
            mirror_im.push_back(pair.mirror.imag());
            rate.push_back(static_cast<double>(cascade.rate_high[pair.at]) +
                           cascade.rate_low[pair.at]);
            displacement.push_back(cascade.displacement[pair.at]);
        }
        next_column = column + kLanes;
        runs.back().end = size();
    }
}

double WaveSum::Fixed::mean_square_displacement() const {
    double sum = 0.0;
    for (const Run& run : runs) {
        for (std::size_t i = run.begin; i < run.end; ++i) {
            const double factor = std::hypot(kx[run.column + i - run.begin], ky[run.row]) *
                                  static_cast<double>(displacement[i]);
            const std::complex<double> h0(h0_re[i], h0_im[i]);
            const std::complex<double> mirror(mirror_re[i], mirror_im[i]);
            sum += 2.0 * (std::norm(h0) + std::norm(mirror)) * factor * factor;
        }
    }
    return sum;
}

}  // namespace ocean
