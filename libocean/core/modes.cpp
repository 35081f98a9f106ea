// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the table E(omega, theta) and the seed to the modes: amplitude, noise, phase rate.
#include "ocean/modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "ocean/dispersion.hpp"
#include "ocean/thread_pool.hpp"
#include "wave.hpp"

namespace ocean {

double turns_per_loop(double omega, double loop_period) {
    return std::max(1.0, std::round(omega * loop_period / kTwoPi));
}

double loop_fraction(double time, double loop_period) {
    constexpr double kGrain = 17592186044416.0;  // 2^44
    const double fraction = std::fmod(time, loop_period) / loop_period;
    const double grains = std::round((fraction - std::floor(fraction)) * kGrain);
    return grains >= kGrain ? 0.0 : grains / kGrain;
}

double Modes::tau(double time) const {
    return loop_period > 0.0 ? loop_fraction(time, loop_period) : time;
}

GradientCovariance& GradientCovariance::operator+=(const GradientCovariance& other) {
    aa += other.aa;
    bb += other.bb;
    cc += other.cc;
    ab += other.ab;
    ac += other.ac;
    bc += other.bc;
    return *this;
}

GradientCovariance& GradientCovariance::operator*=(double factor) {
    for (double* value : {&aa, &bb, &cc, &ab, &ac, &bc}) *value *= factor;
    return *this;
}

GradientCovariance Modes::gradient_covariance(int resolution) const {
    GradientCovariance sum;
    for (const CascadeModes& cascade : cascades) {
        for (std::size_t s = 0; s < cascade.shell_covariance.size(); ++s) {
            if (s * static_cast<std::size_t>(2 * cascade.divisor) >=
                static_cast<std::size_t>(resolution)) {
                break;
            }
            sum += cascade.shell_covariance[s];
        }
    }
    return sum;
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
                      int m, const CascadeBand& band) {
    if ((n == 0 && m == 0) || !band.contains(n, m)) return 0.0;
    const double length = std::hypot(n, m);
    const double period = parameters.grid.patch_size / band.divisor;
    const double wavelength = period / length;
    const SurfaceSettings& limits = parameters.surface;
    if (wavelength < limits.shortest_wavelength) return 0.0;
    if (limits.longest_wavelength > 0.0 && wavelength > limits.longest_wavelength) return 0.0;

    const double step = kTwoPi / period;
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

bool measures_band(const CascadeBand& band, int resolution, int n, int m) {
    const std::int64_t half = resolution / 2;
    return band.contains(n, m) && std::int64_t{n} * n + std::int64_t{m} * m < half * half;
}

double band_gain(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 const CascadeBand& band, double variance) {
    const Grid& grid = parameters.grid;
    if (grid.cascades == 1 || variance <= 0.0) return 1.0;
    const SurfaceSettings& limits = parameters.surface;
    const double outer = std::min(band.outer, 0.5 * grid.resolution * band.divisor);
    const double shortest = std::max(limits.shortest_wavelength, grid.patch_size / outer);
    double longest = band.inner > 0.0 ? grid.patch_size / band.inner : 0.0;
    if (limits.longest_wavelength > 0.0) {
        longest = longest > 0.0 ? std::min(longest, limits.longest_wavelength)
                                : limits.longest_wavelength;
    }
    // A band of a few modes may hold them by chance or not.
    return std::clamp(spectrum.moments(parameters.water, shortest, longest).m0 / variance, 0.5,
                      2.0);
}

namespace {

struct ModeIndex {
    std::size_t at;
    int n;
    int m;
};

/// Fills the cascades of a sea, row by row.
class ModesBuilder {
  public:
    ModesBuilder(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 ThreadPool& pool)
        : spectrum_(spectrum),
          parameters_(parameters),
          dispersion_(parameters.water),
          pool_(pool) {}

    CascadeModes cascade(const CascadeBand& band, std::uint32_t number) {
        const int size = parameters_.grid.resolution;
        CascadeModes cascade;
        cascade.divisor = band.divisor;
        cascade.lattice = {size, parameters_.grid.patch_size / band.divisor};
        cascade.h0.resize(cascade.lattice.size());
        cascade.rate_high.resize(cascade.lattice.size());
        cascade.rate_low.resize(cascade.lattice.size());
        cascade.excursion.resize(cascade.lattice.size());
        cascade.shell_covariance.resize(static_cast<std::size_t>(size / 2));
        double measured = 0.0;
        // A batch of rows at a time bounds the memory of their shells, which are added in order:
        // the same bits for any number of threads.
        constexpr int kBatch = 64;
        for (int begin = -size / 2 + 1; begin < size / 2; begin += kBatch) {
            std::vector<Row> rows(static_cast<std::size_t>(std::min(kBatch, size / 2 - begin)));
            pool_.for_each_range(static_cast<int>(rows.size()), [&](int first, int last) {
                for (int row = first; row < last; ++row) {
                    rows[static_cast<std::size_t>(row)] =
                        fill_row(band, number, begin + row, cascade);
                }
            });
            for (const Row& row : rows) {
                measured += row.measured;
                for (std::size_t s = 0; s < row.shells.size(); ++s) {
                    cascade.shell_covariance[s] += row.shells[s];
                }
            }
        }
        scale(cascade, band_gain(spectrum_, parameters_, band, measured));
        return cascade;
    }

  private:
    struct Row {
        double measured = 0.0;  // variance
        std::vector<GradientCovariance> shells;
    };

    static void scale(CascadeModes& cascade, double gain) {
        if (gain == 1.0) return;
        const auto amplitude = static_cast<float>(std::sqrt(gain));
        for (std::complex<float>& h0 : cascade.h0) h0 *= amplitude;
        for (GradientCovariance& shell : cascade.shell_covariance) shell *= gain;
    }

    Row fill_row(const CascadeBand& band, std::uint32_t number, int m, CascadeModes& cascade) {
        const int size = cascade.lattice.resolution;
        const auto row =
            static_cast<std::size_t>(fft_index(m, size)) * static_cast<std::size_t>(size);
        Row filled;
        filled.shells.resize(static_cast<std::size_t>(size / 2));
        for (int n = -size / 2 + 1; n < size / 2; ++n) {
            if (n == 0 && m == 0) continue;
            const ModeIndex index{row + static_cast<std::size_t>(fft_index(n, size)), n, m};
            const double variance = fill_mode(band, number, index, cascade);
            if (variance <= 0.0) continue;
            if (measures_band(band, size, n, m)) filled.measured += variance;
            const double step = cascade.lattice.wavenumber_step();
            const double excursion = static_cast<double>(cascade.excursion[index.at]);
            const double a = step * n * step * n * excursion;
            const double b = step * m * step * m * excursion;
            const double c = step * n * step * m * excursion;
            filled.shells[static_cast<std::size_t>(std::max(std::abs(n), std::abs(m)))] +=
                {variance * a * a, variance * b * b, variance * c * c,
                 variance * a * b, variance * a * c, variance * b * c};
        }
        return filled;
    }

    /// Returns the variance of the mode.
    double fill_mode(const CascadeBand& band, std::uint32_t number, const ModeIndex& index,
                     CascadeModes& cascade) const {
        const double k = cascade.lattice.wavenumber_step() * std::hypot(index.n, index.m);
        const double omega = dispersion_.angular_frequency(k);
        const double loop = parameters_.time.loop_period;
        const double rate = loop > 0.0 ? turns_per_loop(omega, loop) : omega / kTwoPi;
        cascade.rate_high[index.at] = static_cast<float>(rate);
        cascade.rate_low[index.at] =
            static_cast<float>(rate - static_cast<double>(cascade.rate_high[index.at]));
        cascade.excursion[index.at] = static_cast<float>(dispersion_.horizontal_excursion(k) / k);

        const double variance = modal_variance(spectrum_, parameters_, index.n, index.m, band);
        if (variance <= 0.0) return 0.0;
        const wave::double_precision::Gaussian xi =
            wave::double_precision::gaussian_noise(parameters_.seed, number, index.n, index.m);
        const double amplitude = 0.5 * std::sqrt(variance);
        cascade.h0[index.at] = {static_cast<float>(amplitude * xi.re),
                                static_cast<float>(amplitude * xi.im)};
        return variance;
    }

    const DirectionalSpectrum& spectrum_;
    const Parameters& parameters_;
    Dispersion dispersion_;
    ThreadPool& pool_;
};

/// The wind that makes the whitecaps: the strongest.
double strongest_wind(const Parameters& parameters) {
    double strongest = 0.0;
    for (const WaveSystem& system : parameters.waves) {
        strongest = std::max(strongest, system.wind_speed);
    }
    return strongest;
}

}  // namespace

Modes make_modes(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 ThreadPool& pool) {
    Modes modes;
    modes.lattice = {parameters.grid.resolution, parameters.grid.patch_size};
    modes.loop_period = parameters.time.loop_period;
    modes.wind_speed = strongest_wind(parameters);
    ModesBuilder builder(spectrum, parameters, pool);
    for (const CascadeBand& band : cascade_bands(parameters.grid)) {
        const auto number = static_cast<std::uint32_t>(modes.cascades.size());
        modes.cascades.push_back(builder.cascade(band, number));
    }
    return modes;
}

}  // namespace ocean
