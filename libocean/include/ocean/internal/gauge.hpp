// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Wave gauges: the readings of one gauge, and estimates from a time series of its elevation: waves
// by zero crossings, a spectrum by Welch's method, and the confidence limits of both.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ocean/internal/surface_query.hpp"
#include "ocean/internal/wave_sum.hpp"

namespace ocean {

class SurfaceQuery;

/// The reading of a gauge at one point of the world and one time.
struct GaugeReading {
    double elevation;         // of the displayed surface [m]
    double slope_x, slope_y;  // dz/dx, dz/dy of the displayed surface, by world coordinates
    WaterMotion water;        // at the gauge's depth
};

/// Returns the reading at (x, y) [m], exact: all modes are summed. If the surface may fold
/// (may_fold), `query` must be a query of the same modes and time, which finds its top sheet; else
/// it may be null. The bits do not depend on earlier readings.
GaugeReading read_gauge(const WaveSum& sea, double choppiness, double x, double y,
                        const WaterLevel& level, const SurfaceQuery* query = nullptr);

/// A value with its 95 % confidence limits.
struct Estimate {
    double value;
    double lower;
    double upper;
};

/// One-sided density of a series' variance at the frequencies i * frequency_step, i = 0 .., up to
/// half the sampling rate. The sum of density * frequency_step is the variance.
struct GaugeSpectrum {
    double frequency_step = 0.0;      // [Hz]
    double degrees_of_freedom = 0.0;  // of each density
    std::vector<double> density;      // [m^2/Hz]

    double frequency(std::size_t i) const { return frequency_step * static_cast<double>(i); }
    /// Returns the limits of a density of 1, by the chi-squared distribution; the limits of another
    /// density are proportional to it.
    Estimate limits() const;
};

/// Returns the samples of a segment: the largest power of two, at least 32, that leaves the series
/// the required degrees of freedom; 0 if the series is too short.
std::size_t gauge_segment(std::size_t samples, double degrees_of_freedom);
/// Returns the spectrum by Welch's method: segments of gauge_segment samples that overlap by half,
/// Hann windows, the mean of the series removed. `rate` in [Hz]. Empty for a series that is too
/// short.
GaugeSpectrum estimate_spectrum(std::span<const double> elevation, double rate,
                                double degrees_of_freedom);

/// Waves counted by zero up-crossings: a wave lasts from one up-crossing of the mean to the next,
/// each interpolated linearly between samples; its height is the highest sample minus the lowest.
/// All members are 0 without a whole wave.
struct WaveCount {
    int waves = 0;
    double significant_height = 0.0;  // H1/3, mean of the highest third [m]
    double tenth_height = 0.0;        // H1/10 [m]
    double mean_height = 0.0;         // [m]
    double highest_wave = 0.0;        // Hmax [m]
    double highest_crest = 0.0;       // of the series, above its mean [m]
    Estimate mean_period = {};        // Tz of the zero crossings [s]; limits NaN below 100 waves
    double significant_period = 0.0;  // T1/3, mean over the highest third [s]
};
/// Returns the waves of a series of elevations [m] sampled at `rate` [Hz].
WaveCount count_waves(std::span<const double> elevation, double rate);

/// Parameters of the sea estimated from a series. The values describe the series; the limits bound
/// the sea's parameters. The limits are NaN without a spectrum, and equal the value in still water.
struct SeaEstimate {
    Estimate significant_wave_height;  // 4 sqrt(m0) [m]
    Estimate zero_crossing_period;     // sqrt(m0/m2) [s]
};
SeaEstimate estimate_sea(std::span<const double> elevation, double rate,
                         const GaugeSpectrum& spectrum);

}  // namespace ocean
