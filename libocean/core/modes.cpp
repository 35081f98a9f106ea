// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the table E(omega, theta) and the seed to the modes: amplitude, noise, phase rate.
#include "ocean/modes.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/dispersion.hpp"
#include "ocean/thread_pool.hpp"
#include "wave.hpp"

namespace ocean {

double turns_per_loop(double omega, double loop_period) {
    return std::max(1.0, std::round(omega * loop_period / kTwoPi));
}

double Modes::tau(double time) const {
    if (loop_period <= 0.0) return time;
    // Rounded to 2^-44 of a loop, so that t and t + T give the same bits after their own rounding.
    constexpr double kGrain = 17592186044416.0;
    const double fraction = std::fmod(time, loop_period) / loop_period;
    const double grains = std::round((fraction - std::floor(fraction)) * kGrain);
    return grains >= kGrain ? 0.0 : grains / kGrain;
}

namespace {

/// S D c_g / k, the variance density over the wavenumber plane, at (n, m) lattice steps; m^4.
double wavenumber_density(const DirectionalSpectrum& spectrum, const Dispersion& dispersion,
                          double step, double n, double m) {
    const double k = step * std::hypot(n, m);
    const double density = spectrum.density(dispersion.angular_frequency(k), std::atan2(m, n));
    return density * dispersion.group_velocity(k) / k;
}

/// Points along each side of a mode's cell, so that they lie 1/128 of a wavenumber and of a radian
/// apart: closer than the narrowest beams and peaks of the table. Farther than 128 steps from the
/// origin the cell itself is as small. Proved by Statistics.EveryRecordKeepsItsEnergyOnEveryPatch.
int samples_per_cell_side(double length) {
    return std::clamp(static_cast<int>(std::ceil(128.0 / length)), 1, 64);
}

}  // namespace

double modal_variance(const DirectionalSpectrum& spectrum, const Parameters& parameters, int n,
                      int m) {
    if (n == 0 && m == 0) return 0.0;
    const double length = std::hypot(n, m);
    const double wavelength = parameters.grid.patch_size / length;
    const SurfaceSettings& band = parameters.surface;
    if (wavelength < band.shortest_wavelength) return 0.0;
    if (band.longest_wavelength > 0.0 && wavelength > band.longest_wavelength) return 0.0;

    const double step = kTwoPi / parameters.grid.patch_size;
    const Dispersion dispersion(parameters.water);
    const int side = samples_per_cell_side(length);
    double sum = 0.0;
    for (int b = 0; b < side; ++b) {
        for (int a = 0; a < side; ++a) {
            sum += wavenumber_density(spectrum, dispersion, step, n + (a + 0.5) / side - 0.5,
                                      m + (b + 0.5) / side - 0.5);
        }
    }
    return sum / (side * side) * step * step;
}

namespace {

struct ModeIndex {
    std::size_t at;
    int n;
    int m;
};

void fill_mode(CascadeModes& cascade, const ModeIndex& index, const DirectionalSpectrum& spectrum,
               const Parameters& parameters) {
    const Dispersion dispersion(parameters.water);
    const double k = cascade.lattice.wavenumber_step() * std::hypot(index.n, index.m);
    const double omega = dispersion.angular_frequency(k);
    const double loop = parameters.time.loop_period;
    const double rate = loop > 0.0 ? turns_per_loop(omega, loop) : omega / kTwoPi;
    cascade.rate_high[index.at] = static_cast<float>(rate);
    cascade.rate_low[index.at] =
        static_cast<float>(rate - static_cast<double>(cascade.rate_high[index.at]));
    cascade.excursion[index.at] = static_cast<float>(dispersion.horizontal_excursion(k) / k);

    const double variance = modal_variance(spectrum, parameters, index.n, index.m);
    if (variance <= 0.0) return;
    const wave::double_precision::Gaussian xi =
        wave::double_precision::gaussian_noise(parameters.seed, 0, index.n, index.m);
    const double amplitude = 0.5 * std::sqrt(variance);
    cascade.h0[index.at] = {static_cast<float>(amplitude * xi.re),
                            static_cast<float>(amplitude * xi.im)};
}

}  // namespace

Modes make_modes(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 ThreadPool& pool) {
    Modes modes;
    modes.lattice = {parameters.grid.resolution, parameters.grid.patch_size};
    modes.loop_period = parameters.time.loop_period;
    CascadeModes& cascade = modes.cascades.emplace_back();
    cascade.lattice = modes.lattice;
    cascade.h0.resize(modes.lattice.size());
    cascade.rate_high.resize(modes.lattice.size());
    cascade.rate_low.resize(modes.lattice.size());
    cascade.excursion.resize(modes.lattice.size());

    const int n = modes.lattice.resolution;
    pool.for_each_range(n, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < n; ++i) {
                if (i == n / 2 || j == n / 2 || (i == 0 && j == 0)) continue;
                const std::size_t at = static_cast<std::size_t>(j) * static_cast<std::size_t>(n) +
                                       static_cast<std::size_t>(i);
                fill_mode(cascade, {at, signed_wavenumber(i, n), signed_wavenumber(j, n)}, spectrum,
                          parameters);
            }
        }
    });
    return modes;
}

}  // namespace ocean
