// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the table E(omega, theta) and the seed to the modes: amplitude, noise, phase rate.
#include "ocean/internal/modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "ocean/internal/dispersion.hpp"
#include "waves/modes/mode_lattice.hpp"

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

double energy(const Modes& modes) {
    double sum = 0.0;
    for (const CascadeModes& cascade : modes.cascades) {
        for (const std::complex<float>& h0 : cascade.h0) sum += std::norm(std::complex<double>(h0));
    }
    return sum;
}

/// Returns the turns since time 0, without whole turns.
double turns(const CascadeModes& cascade, std::size_t i, double tau) {
    const double high = static_cast<double>(cascade.rate_high[i]) * tau;
    return high - std::floor(high) + static_cast<double>(cascade.rate_low[i]) * tau;
}

/// Returns Re sum h_a conj h_b over the modes that both cascades have.
double shared_energy(const CascadeModes& a, double tau_a, const CascadeModes& b, double tau_b) {
    const int half = std::min(a.lattice.resolution, b.lattice.resolution) / 2;
    double sum = 0.0;
    for (int m = 1 - half; m < half; ++m) {
        for (int n = 1 - half; n < half; ++n) {
            const std::size_t i = mode_index(n, m, a.lattice.resolution);
            const std::size_t j = mode_index(n, m, b.lattice.resolution);
            const std::complex<double> product =
                std::complex<double>(a.h0[i]) * std::conj(std::complex<double>(b.h0[j]));
            if (product == 0.0) continue;
            const double between = turns(a, i, tau_a) - turns(b, j, tau_b);
            sum += between == 0.0 ? std::real(product)
                                  : std::real(product * std::polar(1.0, -kTwoPi * between));
        }
    }
    return sum;
}

}  // namespace

double height_correlation(const Modes& a, double time_a, const Modes& b, double time_b) {
    const double whole = std::sqrt(energy(a) * energy(b));
    if (whole == 0.0) return 0.0;
    double shared = 0.0;
    for (const CascadeModes& of_a : a.cascades) {
        for (const CascadeModes& of_b : b.cascades) {
            if (of_a.lattice.period != of_b.lattice.period) continue;
            shared += shared_energy(of_a, a.tau(time_a), of_b, b.tau(time_b));
        }
    }
    return shared / whole;
}

namespace {

/// Returns S D c_g / k, the variance density over the wavenumber plane [m^4], at (n, m) lattice
/// steps.
double wavenumber_density(const DirectionalSpectrum& spectrum, const Dispersion& dispersion,
                          double step, double n, double m) {
    const double k = step * std::hypot(n, m);
    const double density = spectrum.density(dispersion.angular_frequency(k), std::atan2(m, n));
    return density * dispersion.group_velocity(k) / k;
}

}  // namespace

int samples_per_cell_side(double length) {
    return length < 96.0 ? 2 * std::clamp(static_cast<int>(std::ceil(48.0 / length)), 1, 32) : 1;
}

double sample_offset(int sample, int side) {
    if (side == 1) return 0.0;
    constexpr double kGauss = 0.5773502691896258;  // 1 / sqrt(3), in units of half a part
    const double part = 2.0 / side;
    const double centre = (sample / 2 + 0.5) * part - 0.5;
    return centre + (sample % 2 == 0 ? -0.5 : 0.5) * kGauss * part;
}

BandSide band_side(const Parameters& parameters, const CascadeBand& band, int n, int m) {
    if (n == 0 && m == 0) return BandSide::too_long;
    const double length = std::hypot(n, m);
    if (!band.contains(n, m)) {
        return band.is_inside(n, m) ? BandSide::too_long : BandSide::too_short;
    }
    const double wavelength = parameters.grid.patch_size / band.divisor / length;
    const SurfaceSettings& limits = parameters.surface;
    if (wavelength < limits.shortest_wavelength) return BandSide::too_short;
    if (limits.longest_wavelength > 0.0 && wavelength > limits.longest_wavelength) {
        return BandSide::too_long;
    }
    return BandSide::inside;
}

double modal_variance(const DirectionalSpectrum& spectrum, const Parameters& parameters, int n,
                      int m, const CascadeBand& band) {
    if (band_side(parameters, band, n, m) != BandSide::inside) return 0.0;
    const double length = std::hypot(n, m);
    const double step = kTwoPi / (parameters.grid.patch_size / band.divisor);
    const Dispersion dispersion(parameters.water);
    const int side = samples_per_cell_side(length);
    double sum = 0.0;
    for (int b = 0; b < side; ++b) {
        for (int a = 0; a < side; ++a) {
            sum += wavenumber_density(spectrum, dispersion, step, n + sample_offset(a, side),
                                      m + sample_offset(b, side));
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
    // A band with few modes may hold or miss them by chance.
    return std::clamp(spectrum.variance(parameters.water, shortest, longest) / variance, 0.5, 2.0);
}

std::optional<double> strongest_wind(const Parameters& parameters) {
    std::optional<double> strongest;
    // An unset wind compares less than any value.
    for (const WaveSystem& system : parameters.waves) {
        strongest = std::max(strongest, system.wind_above());
    }
    return strongest;
}

}  // namespace ocean
