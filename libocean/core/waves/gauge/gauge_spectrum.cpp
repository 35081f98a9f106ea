// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spectrum of a series by Welch's method; see gauge.hpp. [Welch 1967].
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numeric>

#include "ocean/internal/fft.hpp"
#include "ocean/internal/gauge.hpp"
#include "waves/gauge/chi_squared.hpp"
#include "waves/gauge/series_moments.hpp"

namespace ocean {
namespace {

constexpr std::size_t kShortestSegment = 32;
constexpr std::size_t kLongestSegment = 1 << 20;  // limited by the transform

/// Returns the number of segments that fit into the series; each begins half a segment after the
/// previous one.
std::size_t segments_of(std::size_t samples, std::size_t segment) {
    return samples < segment ? 0 : (samples - segment) / (segment / 2) + 1;
}

/// Returns the degrees of freedom. Neighbouring Hann windows share 1/36 of their information.
/// [Percival and Walden 1993] eq. 292b, [Welch 1967].
double freedom_of(std::size_t segments) {
    const auto n = static_cast<double>(segments);
    return segments == 0 ? 0.0 : 36.0 * n * n / (19.0 * n - 1.0);
}

std::vector<double> hann(std::size_t n) {
    std::vector<double> window(n);
    for (std::size_t i = 0; i < n; ++i) {
        window[i] = 0.5 - 0.5 * std::cos(kTwoPi * static_cast<double>(i) / static_cast<double>(n));
    }
    return window;
}

}  // namespace

Estimate GaugeSpectrum::limits() const {
    const double nu = degrees_of_freedom;
    return {1.0, nu / chi_squared_quantile(0.975, nu), nu / chi_squared_quantile(0.025, nu)};
}

std::size_t gauge_segment(std::size_t samples, double degrees_of_freedom) {
    std::size_t segment = std::min(std::bit_floor(samples), kLongestSegment);
    while (segment >= kShortestSegment) {
        if (freedom_of(segments_of(samples, segment)) >= degrees_of_freedom) return segment;
        segment /= 2;
    }
    return 0;
}

GaugeSpectrum estimate_spectrum(std::span<const double> elevation, double rate,
                                double degrees_of_freedom) {
    const std::size_t length = gauge_segment(elevation.size(), degrees_of_freedom);
    if (length == 0) return {};
    const std::size_t segments = segments_of(elevation.size(), length);
    GaugeSpectrum spectrum;
    spectrum.frequency_step = rate / static_cast<double>(length);
    spectrum.degrees_of_freedom = freedom_of(segments);
    spectrum.density.resize(length / 2 + 1);

    const auto [mean, variance] = moments_of(elevation);
    const std::vector<double> window = hann(length);
    const Radix2Fft<double> fft(static_cast<int>(length));
    std::vector<std::complex<double>> work(length);
    for (std::size_t s = 0; s < segments; ++s) {
        const std::span<const double> part = elevation.subspan(s * length / 2, length);
        for (std::size_t i = 0; i < length; ++i) work[i] = window[i] * (part[i] - mean);
        fft.transform(work.data(), 1, FftDirection::forward);
        for (std::size_t k = 0; k <= length / 2; ++k) {
            const bool alone = k == 0 || k == length / 2;  // this frequency has no negative twin
            spectrum.density[k] += (alone ? 1.0 : 2.0) * std::norm(work[k]);
        }
    }
    const double power = std::accumulate(spectrum.density.begin(), spectrum.density.end(), 0.0);
    const double scale = power > 0.0 ? variance / (power * spectrum.frequency_step) : 0.0;
    for (double& density : spectrum.density) density *= scale;
    return spectrum;
}

}  // namespace ocean
