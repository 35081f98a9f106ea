// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Statistics of the waves in a series of elevations, and estimates of the sea; see gauge.hpp.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "ocean/internal/gauge.hpp"
#include "waves/gauge/chi_squared.hpp"
#include "waves/gauge/series_moments.hpp"

namespace ocean {
namespace {

struct Wave {
    double height;
    double period;
};

std::vector<Wave> waves_between_crossings(std::span<const double> elevation, double mean,
                                          double rate) {
    std::vector<Wave> waves;
    std::optional<double> start;  // in samples
    double crest = 0.0;
    double trough = 0.0;
    for (std::size_t i = 0; i < elevation.size(); ++i) {
        const double now = elevation[i] - mean;
        const double before = i > 0 ? elevation[i - 1] - mean : 0.0;
        if (before < 0.0 && now >= 0.0) {
            const double crossing = static_cast<double>(i) - now / (now - before);
            if (start) waves.push_back({crest - trough, (crossing - *start) / rate});
            start = crossing;
            crest = trough = 0.0;
        }
        crest = std::max(crest, now);
        trough = std::min(trough, now);
    }
    return waves;
}

/// Returns the mean over the first 1/part of the waves, at least one wave. Waves sorted by height
/// give the mean of the highest.
double mean_of_first(std::span<const Wave> waves, int part, double Wave::*member) {
    const double share = static_cast<double>(waves.size()) / part;
    const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(share)));
    double sum = 0.0;
    for (const Wave& wave : waves.first(count)) sum += wave.*member;
    return sum / static_cast<double>(count);
}

// Divides the series into twenty runs of waves, far longer than waves are correlated: the mean
// periods of the runs are independent, and the error of the overall mean is their standard error
// times Student's t of 19 degrees of freedom. [Bendat and Piersol 2010] section 4.5.
Estimate mean_period_of(std::span<const Wave> waves) {
    constexpr std::size_t kRuns = 20;
    constexpr double kStudent975 = 2.093024054408263;
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const double period = mean_of_first(waves, 1, &Wave::period);
    const std::size_t length = waves.size() / kRuns;
    if (length < 5) return {period, kNaN, kNaN};
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t run = 0; run < kRuns; ++run) {
        const double mean =
            mean_of_first(waves.subspan(run * length, length), 1, &Wave::period) - period;
        sum += mean;
        squares += mean * mean;
    }
    const double variance = (squares - sum * sum / kRuns) / (kRuns - 1);
    const double limit = kStudent975 * std::sqrt(std::max(variance, 0.0) / kRuns);
    return {period, period - limit, period + limit};
}

}  // namespace

WaveCount count_waves(std::span<const double> elevation, double rate) {
    const double mean = moments_of(elevation).mean;
    std::vector<Wave> waves = waves_between_crossings(elevation, mean, rate);
    if (waves.empty()) return {};
    WaveCount count;
    count.mean_period = mean_period_of(waves);
    std::ranges::stable_sort(waves, std::greater<>(), &Wave::height);
    count.waves = static_cast<int>(waves.size());
    count.significant_height = mean_of_first(waves, 3, &Wave::height);
    count.tenth_height = mean_of_first(waves, 10, &Wave::height);
    count.mean_height = mean_of_first(waves, 1, &Wave::height);
    count.highest_wave = waves.front().height;
    count.highest_crest = *std::ranges::max_element(elevation) - mean;
    count.significant_period = mean_of_first(waves, 3, &Wave::period);
    return count;
}

// For a Gaussian series of length T with the density S(f), moments m_j = sum of f^j S df over it
// have the covariances (1/T) int f^(i+j) S^2 df. [Bendat and Piersol 2010] section 8.2. So m0
// scatters like a chi-squared variable of 2 T m0^2 / int S^2 df degrees of freedom, and r = m0/m2
// has the relative variance (1/T) int S^2 (1/m0 - f^2/m2)^2 df; the period is sqrt(r), its
// logarithm has half the deviation. The mean square of an estimated density is too large by the
// factor (1 + 2 / degrees of freedom), which is divided out.
SeaEstimate estimate_sea(std::span<const double> elevation, double rate,
                         const GaugeSpectrum& spectrum) {
    constexpr double kNormal975 = 1.959963984540054;
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const double m0 = moments_of(elevation).variance;
    const double height = 4.0 * std::sqrt(m0);
    if (m0 == 0.0) return {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    if (spectrum.density.empty()) return {{height, kNaN, kNaN}, {kNaN, kNaN, kNaN}};

    const double df = spectrum.frequency_step;
    double m2 = 0.0;
    for (std::size_t i = 0; i < spectrum.density.size(); ++i) {
        m2 += std::pow(spectrum.frequency(i), 2) * spectrum.density[i] * df;
    }
    double variance_m0 = 0.0;     // times T
    double variance_ratio = 0.0;  // relative, times T
    for (std::size_t i = 0; i < spectrum.density.size(); ++i) {
        const double squared =
            std::pow(spectrum.density[i], 2) / (1.0 + 2.0 / spectrum.degrees_of_freedom) * df;
        variance_m0 += squared;
        variance_ratio += squared * std::pow(1.0 / m0 - std::pow(spectrum.frequency(i), 2) / m2, 2);
    }
    const double duration = static_cast<double>(elevation.size()) / rate;
    const double freedom = std::max(1.0, 2.0 * duration * m0 * m0 / variance_m0);
    const double period = std::sqrt(m0 / m2);
    const double spread = std::exp(0.5 * kNormal975 * std::sqrt(variance_ratio / duration));
    return {{height, height * std::sqrt(freedom / chi_squared_quantile(0.975, freedom)),
             height * std::sqrt(freedom / chi_squared_quantile(0.025, freedom))},
            {period, period / spread, period * spread}};
}

}  // namespace ocean
