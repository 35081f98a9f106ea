// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea of second order is eta1 + eta2, where each pair of waves binds two more, with the sum and
// the difference of its wavenumbers:
//     eta2 = sum over pairs a1 a2 (K- cos(psi1 - psi2) + K+ cos(psi1 + psi2)),
// [Longuet-Higgins 1963b], [Sharma and Dean 1981], here for depth = infinity. Its skewness
// is 3 <eta1^2 eta2> / m0^1.5 = 3 m0^0.5 E[K- + K+], the mean over pairs drawn by energy.
//
// The kernels belong to no product of fields, so that a sum over all pairs would be needed. The
// products of the horizontal displacement D = -i k/|k| h with
//     eta2^ = -1/2 [p k_i k_j / |k| + (1 - p) |k| delta_ij] (D_i D_j)^,   p = 0.8,
// have other kernels, whose mean is that of theory: within 0.3 % for long-crested seas, 3 % for
// seas as broad as cos^8 and 4.5 % for crossing ones. Limits: K+ = k for a wave with itself, which
// is Stokes' k a^2 / 2; K- + K+ = min(k1, k2) for two waves of one direction. Tests:
// SecondOrder.*
#include "ocean/internal/second_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {

namespace {

constexpr double kSteepestSecondOrder = 0.2;
constexpr double kMuchOfSkewness = 0.9;

/// Returns |k1 + sign k2|.
double bound_wavenumber(double k1, double k2, double cosine, double sign) {
    return std::sqrt(std::max(k1 * k1 + k2 * k2 + 2.0 * sign * k1 * k2 * cosine, 0.0));
}

double of_theory(double k1, double k2, double cosine, double sign) {
    const double beat = std::sqrt(k1) + sign * std::sqrt(k2);
    const double resonance = beat * beat - bound_wavenumber(k1, k2, cosine, sign);
    const double d = std::abs(resonance) > 1e-12 * (k1 + k2)
                         ? 2.0 * beat * beat * k1 * k2 * (cosine - sign) / resonance
                         : 0.0;
    return 0.5 * ((d - k1 * k2 * (cosine - sign)) / std::sqrt(k1 * k2) + k1 + k2);
}

double of_products(double k1, double k2, double cosine, double sign) {
    const double k = bound_wavenumber(k1, k2, cosine, sign);
    if (k <= 1e-12 * (k1 + k2)) return 0.0;
    const double along = (k1 + sign * k2 * cosine) * (k1 * cosine + sign * k2) / k;
    return 0.5 * sign * (kBoundAlong * along + (1.0 - kBoundAlong) * k * cosine);
}

}  // namespace

BoundPair bound_pair_of_theory(double k1, double k2, double cosine) {
    return {of_theory(k1, k2, cosine, -1.0), of_theory(k1, k2, cosine, 1.0)};
}

BoundPair bound_pair_of_products(double k1, double k2, double cosine) {
    return {of_products(k1, k2, cosine, -1.0), of_products(k1, k2, cosine, 1.0)};
}

double binding_limit(const DirectionalSpectrum& spectrum, const Parameters& parameters) {
    constexpr double kEnergy = 0.995;
    if (!parameters.surface.second_order) return 0.0;
    const Grid& grid = parameters.grid;
    const SurfaceSettings& limits = parameters.surface;
    const auto held = [&](double k) {
        return spectrum.variance(parameters.water, kTwoPi / k, limits.longest_wavelength);
    };
    const double step = kTwoPi / grid.patch_size;
    const double energy = kEnergy * spectrum.variance(parameters.water, limits.shortest_wavelength,
                                                      limits.longest_wavelength);
    if (energy <= 0.0) return 0.0;
    double below = step;
    double above = step * std::floor(0.5 * grid.resolution / kSamplesPerBinding);
    if (held(above) <= energy) return above;
    while (above - below > 1e-6 * above) {
        const double middle = 0.5 * (below + above);
        (held(middle) < energy ? below : above) = middle;
    }
    return above;
}

namespace {

/// A part of the sea's energy, of one wavenumber and direction.
struct EnergyPart {
    double k;  // [rad/m]
    double direction;
    double variance;  // [m^2]
};

/// Returns the sea's energy within its limits, in cells that grow with the frequency.
std::vector<EnergyPart> energy_parts(const DirectionalSpectrum& spectrum,
                                     const Parameters& parameters) {
    constexpr int kFrequencies = 40;
    constexpr int kDirections = 36;
    constexpr double kNone = 1e-5;  // of the variance
    const Dispersion dispersion(parameters.water);
    const SurfaceSettings& limits = parameters.surface;
    const double longest = limits.longest_wavelength;
    const double m0 = spectrum.variance(parameters.water, limits.shortest_wavelength, longest);
    const auto omega_of = [&](double share) {
        // The frequency below which this share of the energy lies.
        double low = spectrum.angular_frequencies().front();
        double high = spectrum.angular_frequencies().back();
        for (int step = 0; step < 50; ++step) {
            const double middle = 0.5 * (low + high);
            const double shorter = kTwoPi / dispersion.wavenumber(middle);
            (spectrum.variance(parameters.water, shorter, longest) < share * m0 ? low : high) =
                middle;
        }
        return high;
    };
    const double first = omega_of(kNone);
    const double ratio = omega_of(1.0 - kNone) / first;
    std::vector<EnergyPart> parts;
    for (int i = 0; i < kFrequencies; ++i) {
        const double below = first * std::pow(ratio, static_cast<double>(i) / kFrequencies);
        const double above = first * std::pow(ratio, (i + 1.0) / kFrequencies);
        const double omega = std::sqrt(below * above);
        const double variance =
            spectrum.variance(parameters.water, kTwoPi / dispersion.wavenumber(above),
                              kTwoPi / dispersion.wavenumber(below));
        std::array<double, kDirections> density;
        double sum = 0.0;
        for (std::size_t j = 0; j < kDirections; ++j) {
            sum += density[j] =
                spectrum.density(omega, kTwoPi * static_cast<double>(j) / kDirections);
        }
        for (int j = 0; j < kDirections && sum > 0.0; ++j) {
            const double part = variance * density[static_cast<std::size_t>(j)] / sum;
            if (part <= kNone * kNone * m0) continue;
            parts.push_back({dispersion.wavenumber(omega), kTwoPi * j / kDirections, part});
        }
    }
    return parts;
}

/// Returns 3 m0^-1.5 times the sum of K- + K+ over all pairs.
template <typename Pair>
double skewness(const std::vector<EnergyPart>& parts, const Pair& pair_of) {
    double sum = 0.0;
    double m0 = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const EnergyPart& a = parts[i];
        m0 += a.variance;
        for (std::size_t j = 0; j <= i; ++j) {
            const EnergyPart& b = parts[j];
            const BoundPair pair = pair_of(a.k, b.k, std::cos(a.direction - b.direction));
            sum += (i == j ? 1.0 : 2.0) * a.variance * b.variance * (pair.difference + pair.sum);
        }
    }
    return m0 > 0.0 ? 3.0 * sum / std::pow(m0, 1.5) : 0.0;
}

}  // namespace

void add_second_order(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                      SeaState& state) {
    const double limit = binding_limit(spectrum, parameters);
    if (limit == 0.0) return;
    const std::vector<EnergyPart> parts = energy_parts(spectrum, parameters);
    const Dispersion dispersion(parameters.water);
    const SpectralMoments moments =
        spectrum.moments(parameters.water, parameters.surface.shortest_wavelength,
                         parameters.surface.longest_wavelength);
    SecondOrderSummary summary;
    summary.skewness_of_theory = skewness(parts, bound_pair_of_theory);
    summary.skewness = skewness(parts, [limit](double k1, double k2, double cosine) {
        return std::max(k1, k2) <= limit ? bound_pair_of_products(k1, k2, cosine)
                                         : BoundPair{0.0, 0.0};
    });
    summary.shortest_binding_wave = kTwoPi / limit;
    summary.steepness =
        0.5 * moments.significant_wave_height() * dispersion.wavenumber(moments.peak_omega);
    state.second_order = summary;
    const auto warn = [&](std::string text) { state.warnings.push_back(std::move(text)); };
    if (summary.steepness > kSteepestSecondOrder) {
        warn("waves as steep as k_p Hs / 2 = " + fixed_text(summary.steepness, 2) +
             " are beyond second order, which describes them up to " +
             fixed_text(kSteepestSecondOrder, 2) +
             ": make the waves lower or longer, or surface.second_order = false");
    }
    if (summary.skewness < kMuchOfSkewness * summary.skewness_of_theory) {
        warn("this grid makes a skewness of " + fixed_text(summary.skewness, 3) + ", theory of " +
             fixed_text(summary.skewness_of_theory, 3) + ": waves shorter than " +
             fixed_text(summary.shortest_binding_wave, 1) +
             " m bind no others; a finer grid.resolution or a smaller grid.patch_size has more");
    }
}

}  // namespace ocean
