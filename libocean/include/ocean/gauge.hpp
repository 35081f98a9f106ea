// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Wave gauges: what one reads in the sea, and what a time series of its elevation says: waves by
// zero crossings, a spectrum by Welch's method, and how far both can be trusted.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ocean/wave_sum.hpp"

namespace ocean {

class SurfaceQuery;

/// At one place of the world and one time.
struct GaugeReading {
    double elevation;         // m, of the shown surface
    double slope_x, slope_y;  // dz/dx, dz/dy of the shown surface, by world coordinates
    WaterMotion water;        // at the gauge's depth
};

/// Exact: sums all modes. A surface that may_fold needs a query of the same modes and time, which
/// knows where its top sheet is; of others there is one sheet. The same bits whatever was read
/// before.
GaugeReading read_gauge(const WaveSum& sea, double choppiness, double x, double y,
                        const WaterLevel& level, const SurfaceQuery* query = nullptr);

/// A value with its 95 % confidence limits.
struct Estimate {
    double value;
    double lower;
    double upper;
};

/// One-sided density of a series' variance at the frequencies i * frequency_step, i = 0 .. up to
/// half the sampling rate, scaled so that the sum of density * frequency_step is the variance.
struct GaugeSpectrum {
    double frequency_step = 0.0;      // Hz
    double degrees_of_freedom = 0.0;  // of each density
    std::vector<double> density;      // m^2/Hz

    double frequency(std::size_t i) const { return frequency_step * static_cast<double>(i); }
    /// The limits of a density of 1, by the chi-squared distribution: those of all are in
    /// proportion.
    Estimate limits() const;
};

/// Samples of a segment: the largest power of two that leaves the series the degrees of freedom
/// asked for, at least 32; 0 if the series is too short.
std::size_t gauge_segment(std::size_t samples, double degrees_of_freedom);
/// Welch's method: segments of gauge_segment samples that overlap by half, Hann windows, the
/// series' mean removed. `rate` in Hz. An empty spectrum for a series that is too short.
GaugeSpectrum estimate_spectrum(std::span<const double> elevation, double rate,
                                double degrees_of_freedom);

/// A wave lasts from one up-crossing of the mean to the next, found between the samples along a
/// straight line; its height is the highest sample less the lowest. All 0 without a whole wave.
struct WaveCount {
    int waves = 0;
    double significant_height = 0.0;  // H1/3, m: mean of the highest third
    double tenth_height = 0.0;        // H1/10
    double mean_height = 0.0;
    double highest_wave = 0.0;        // Hmax
    double highest_crest = 0.0;       // of the series, m above its mean
    Estimate mean_period = {};        // Tz, s: of the zero crossings. Limits NaN below 100 waves
    double significant_period = 0.0;  // T1/3: mean over the highest third
};
WaveCount count_waves(std::span<const double> elevation, double rate);

/// Of the sea, as far as a series of it tells: both values are those of the series; the limits say
/// where the sea's own may lie. They are NaN without a spectrum, and the value itself in still
/// water.
struct SeaEstimate {
    Estimate significant_wave_height;  // 4 sqrt(m0), m
    Estimate zero_crossing_period;     // sqrt(m0/m2), s
};
SeaEstimate estimate_sea(std::span<const double> elevation, double rate,
                         const GaugeSpectrum& spectrum);

}  // namespace ocean
