// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Seas and measures that several tests share.
#pragma once

#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/ocean.hpp"
#include "ocean/surface.hpp"
#include "testing.hpp"

namespace ocean::test {

/// Threads for all that needs some and does not depend on their number.
inline ThreadPool& pool() {
    static ThreadPool threads(2);
    return threads;
}

/// In what a wind sea differs.
struct SeaChanges {
    std::optional<double> wind = {}, height = {}, period = {};
    double direction = 30.0, fetch = 100000.0;
    SpectrumKind spectrum = SpectrumKind::jonswap;
    double choppiness = 1.0;
    double depth = std::numeric_limits<double>::infinity();
    double loop = 0.0;
    int cascades = 1;
};

/// One JONSWAP wind sea: U10 10 m/s, fetch 100 km, Hs 2.0131 m, of waves of 57 m.
inline Parameters wind_sea(int resolution = 128, double patch_size = 400.0,
                           const SeaChanges& changes = {}) {
    Parameters parameters;
    parameters.grid.resolution = resolution;
    parameters.grid.patch_size = patch_size;
    parameters.grid.cascades = changes.cascades;
    parameters.surface.choppiness = changes.choppiness;
    parameters.water.depth = changes.depth;
    parameters.time.loop_period = changes.loop;
    WaveSystem& system = parameters.waves.front();
    system.spectrum = changes.spectrum;
    system.spreading = SpreadingKind::hasselmann;
    system.wind_speed = changes.wind;
    system.fetch = changes.fetch;
    system.wind_direction = changes.direction;
    system.significant_wave_height = changes.height;
    system.peak_period = changes.period;
    return parameters;
}

/// A stronger one, whose crests foam by a threshold.
inline Parameters foaming_sea() {
    Parameters parameters = wind_sea(128, 200.0, {.wind = 15.0});
    parameters.surface.foam_coverage = FoamCoverage::threshold;
    return parameters;
}

inline Modes modes_of(const Parameters& parameters, int threads = 2) {
    ThreadPool pool(threads);
    return make_modes(make_directional_spectrum(parameters), parameters, pool);
}

inline SeaState state_of(const Parameters& parameters) {
    ThreadPool pool(2);
    return sea_state(make_directional_spectrum(parameters), parameters, pool);
}

/// Returns what a sea answers at some points.
inline std::vector<QuerySample> query(Ocean& sea, double time, std::span<const WorldPoint> points,
                                      const QueryOptions& options = {}) {
    std::vector<QuerySample> samples(points.size());
    sea.query(time, points, samples, options);
    return samples;
}

/// Returns one channel of a map.
inline std::vector<float> values_of(const Surface& map, Channel channel = Channel::height) {
    return {map.channel(channel).begin(), map.channel(channel).end()};
}

/// Returns the channels that a map has.
inline std::vector<Channel> channels_of(const Surface& map) {
    std::vector<Channel> channels;
    for (int c = 0; c < kChannelNumbers; ++c) {
        if (map.has(static_cast<Channel>(c))) channels.push_back(static_cast<Channel>(c));
    }
    return channels;
}

/// Returns whether all values of a map are numbers.
inline testing::AssertionResult is_finite(const Surface& map) {
    for (const Channel channel : channels_of(map)) {
        const auto finite = [](float value) { return std::isfinite(value); };
        if (!std::ranges::all_of(map.channel(channel), finite)) {
            return testing::AssertionFailure() << "in " << channel_info(channel).name;
        }
    }
    return testing::AssertionSuccess();
}

/// Returns whether both maps have the same bits in each channel of the second.
inline testing::AssertionResult same_bits(const Surface& a, const Surface& b) {
    for (const Channel channel : channels_of(b)) {
        const std::span<const float> x = a.channel(channel), y = b.channel(channel);
        if (x.size() != y.size() || std::memcmp(x.data(), y.data(), x.size_bytes()) != 0) {
            return testing::AssertionFailure() << channel_info(channel).name << " differs";
        }
    }
    return testing::AssertionSuccess();
}

template <typename Values>
double rms(const Values& values) {
    double sum = 0.0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Returns the differences of two lists of equal length.
template <typename A, typename B>
std::vector<double> difference(const A& a, const B& b) {
    std::vector<double> result;
    for (std::size_t i = 0; i < a.size(); ++i) {
        result.push_back(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    }
    return result;
}

/// Returns the largest magnitude of a difference.
template <typename A, typename B>
double largest_difference(const A& a, const B& b) {
    double largest = 0.0;
    for (const double d : difference(a, b)) {
        largest = std::isnan(d) ? std::numeric_limits<double>::infinity()
                                : std::max(largest, std::abs(d));
    }
    return largest;
}

/// Returns the angles [degrees] that 50, 90 and 99 % of slopes do not exceed.
inline std::array<double, 3> slope_angles(std::vector<double> slopes) {
    std::ranges::sort(slopes);
    const auto angle = [&](double share) {
        return std::atan(slopes[static_cast<std::size_t>(share *
                                                         static_cast<double>(slopes.size() - 1))]) *
               360.0 / kTwoPi;
    };
    return {angle(0.5), angle(0.9), angle(0.99)};
}

/// Sums of a line y(x) that is fitted to points by least squares.
struct LineFit {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;

    void add(double at_x, double at_y, double weight = 1.0) {
        n += weight;
        x += weight * at_x;
        y += weight * at_y;
        xx += weight * at_x * at_x;
        yy += weight * at_y * at_y;
        xy += weight * at_x * at_y;
    }
    double slope() const { return (n * xy - x * y) / (n * xx - x * x); }
    double correlation() const {
        return (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y));
    }
};

/// The mean of numbers that are drawn at random, and its standard error.
struct SampleMean {
    double count = 0.0, sum = 0.0, squares = 0.0;

    void add(double value) {
        count += 1.0;
        sum += value;
        squares += value * value;
    }
    double mean() const { return sum / count; }
    double error() const { return std::sqrt((squares / count - mean() * mean()) / (count - 1.0)); }
};

inline double mean(std::span<const float> values) {
    double sum = 0.0;
    for (const float value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

inline double variance(std::span<const float> values) {
    const double centre = mean(values);
    double sum = 0.0;
    for (const float value : values) sum += (value - centre) * (value - centre);
    return sum / static_cast<double>(values.size());
}

/// rms of the error over rms of the reference about its mean.
inline double relative_error(std::span<const float> values, std::span<const float> reference) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double difference = static_cast<double>(values[i]) - reference[i];
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(values.size()) / variance(reference));
}

/// The same for a vector field: the errors and variances of its channels add.
template <typename Maps, typename Channels>
double vector_error(const Maps& maps, const Maps& reference, const Channels& channels) {
    double error = 0.0, spread = 0.0;
    for (const auto channel : channels) {
        const auto value = maps.channel(channel), exact = reference.channel(channel);
        error += std::pow(relative_error(value, exact), 2) * variance(exact);
        spread += variance(exact);
    }
    return std::sqrt(error / spread);
}

/// Spectrum of a map: coefficients of exp(i k x), in FFT order, in double.
inline std::vector<std::complex<double>> coefficients(const Surface& surface, Channel channel) {
    const std::span<const float> map = surface.channel(channel);
    std::vector<std::complex<double>> data(map.begin(), map.end());
    Radix2Fft<double>(surface.resolution()).transform_2d(data, FftDirection::forward);
    for (auto& value : data) value /= static_cast<double>(data.size());
    return data;
}

/// A sea of one wave: h0 at (n, m) alone, amplitude 1/2, so that h = cos(k x - omega t).
inline Modes single_wave(const Parameters& parameters, int n, int m) {
    ThreadPool pool(1);
    Modes modes = make_modes(make_directional_spectrum(parameters), parameters, pool);
    CascadeModes& cascade = modes.cascades.front();
    const int size = cascade.lattice.resolution;
    std::fill(cascade.h0.begin(), cascade.h0.end(), std::complex<float>(0.0f));
    cascade.h0[mode_index(n, m, size)] = 0.5f;
    return modes;
}

/// All that has no past.
inline constexpr ChannelSet kAllChannels = [] {
    ChannelSet channels;
    for (int c = 0; c < kChannelCount; ++c) {
        const bool has_past = ocean::has_past(kChannels[static_cast<std::size_t>(c)].foam);
        if (!has_past) channels = channels | static_cast<Channel>(c);
    }
    return channels;
}();

}  // namespace ocean::test
