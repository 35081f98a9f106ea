// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sums over the modes, by rows in parallel; see mode_sums.hpp.
#include "waves/state/mode_sums.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {

namespace {

/// Returns the exponent p of the smallest map that holds a mode, where `wavenumber` is the larger
/// of its wavenumbers in steps of the map's own lattice.
std::size_t smallest_map(int wavenumber) {
    return static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(wavenumber))) + 1;
}

/// Sums the modes (+-n, m) and (+-n, -m) of a cascade.
ModeSums sum_row(const StateSource& source, std::size_t cascade, const CascadeBand& band, int m) {
    const Parameters& parameters = source.parameters;
    const int half = parameters.grid.resolution / 2;
    const double period = parameters.grid.patch_size / band.divisor;
    const Dispersion dispersion(parameters.water);
    QuadrantVariances variances;
    source.lattice.variances(source.spectrum, cascade, m, variances);
    ModeSums sums;
    sums.ring.resize(static_cast<std::size_t>(half));
    sums.ring_omega.resize(sums.ring.size());
    for (int n = 0; n < half; ++n) {
        const auto at = [&](int quarter) {
            return variances.quarter[quarter][static_cast<std::size_t>(n)];
        };
        const double variance = variances.sum(static_cast<std::size_t>(n));
        if (variance <= 0.0) continue;
        const double length = std::hypot(n, m);
        const double k = kTwoPi / period * length;
        const double omega = dispersion.angular_frequency(k);
        const double off = speed_error(omega, parameters.time.loop_period);
        sums.m0 += variance;
        if (measures_band(band, parameters.grid.resolution, n, m)) sums.measured += variance;
        sums.m1 += omega * variance;
        sums.m_minus1 += variance / omega;
        sums.mean_square_slope += k * k * variance;
        sums.slope_by_map[smallest_map(std::max(n, m) * band.divisor)] += k * k * variance;
        sums.loop_error += off * off * variance;
        sums.direction += std::complex<double>(n * (at(0) - at(1) - at(2) + at(3)),
                                               m * (at(0) + at(1) - at(2) - at(3))) /
                          length;
        const double wavelength = period / length;
        sums.shortest = sums.shortest > 0.0 ? std::min(sums.shortest, wavelength) : wavelength;
        sums.longest = std::max(sums.longest, wavelength);
        const auto ring = static_cast<std::size_t>(std::lround(length));
        if (ring >= sums.ring.size()) continue;
        sums.ring[ring] += variance;
        sums.ring_omega[ring] += variance * omega;
    }
    return sums;
}

}  // namespace

void ModeSums::add(const ModeSums& other) {
    m0 += other.m0;
    measured += other.measured;
    m1 += other.m1;
    m_minus1 += other.m_minus1;
    mean_square_slope += other.mean_square_slope;
    for (std::size_t p = 0; p < other.slope_by_map.size(); ++p) {
        slope_by_map[p] += other.slope_by_map[p];
    }
    direction += other.direction;
    loop_error += other.loop_error;
    longest = std::max(longest, other.longest);
    if (other.shortest > 0.0) {
        shortest = shortest > 0.0 ? std::min(shortest, other.shortest) : other.shortest;
    }
    ring.resize(other.ring.size());
    ring_omega.resize(other.ring.size());
    for (std::size_t i = 0; i < other.ring.size(); ++i) {
        ring[i] += other.ring[i];
        ring_omega[i] += other.ring_omega[i];
    }
}

// A wave keeps its length and makes whole turns: its speed changes in proportion to its frequency.
double speed_error(double omega, double loop_period) {
    if (loop_period <= 0.0) return 0.0;
    return turns_per_loop(omega, loop_period) / (omega * loop_period / kTwoPi) - 1.0;
}

ModeSums sum_modes(const StateSource& source, const DirectionalSpectrum& spectrum,
                   std::size_t cascade, const CascadeBand& band, ThreadPool& pool) {
    // Rows run in parallel, a batch at a time to limit the memory, and are added in order.
    constexpr int kBatch = 64;
    const int half = source.parameters.grid.resolution / 2;
    ModeSums sums;
    for (int begin = 0; begin < half; begin += kBatch) {
        std::vector<ModeSums> rows(static_cast<std::size_t>(std::min(kBatch, half - begin)));
        pool.for_each_range(static_cast<int>(rows.size()), [&](int first, int last) {
            for (int row = first; row < last; ++row) {
                rows[static_cast<std::size_t>(row)] = sum_row(source, cascade, band, begin + row);
            }
        });
        for (const ModeSums& row : rows) sums.add(row);
    }
    const double gain = band_gain(spectrum, source.parameters, band, sums.measured);
    for (double* sum :
         {&sums.m0, &sums.m1, &sums.m_minus1, &sums.mean_square_slope, &sums.loop_error}) {
        *sum *= gain;
    }
    sums.direction *= gain;
    for (double& slope : sums.slope_by_map) slope *= gain;
    for (double& variance : sums.ring) variance *= gain;
    for (double& moment : sums.ring_omega) moment *= gain;
    return sums;
}

}  // namespace ocean
