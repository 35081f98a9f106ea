// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Seas and measures that several tests share.
#pragma once

#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/ocean.hpp"
#include "ocean/surface.hpp"

namespace ocean::test {

/// One JONSWAP wind sea: U10 10 m/s, fetch 100 km, Hs 2.0131 m, of waves of 57 m.
inline Parameters wind_sea(int resolution = 128, double patch_size = 400.0) {
    Parameters parameters;
    parameters.grid.resolution = resolution;
    parameters.grid.patch_size = patch_size;
    WaveSystem& system = parameters.waves.front();
    system.spectrum = SpectrumKind::jonswap;
    system.spreading = SpreadingKind::hasselmann;
    system.fetch = 100000.0;
    system.wind_direction = 30.0;
    return parameters;
}

/// A stronger one, whose crests foam by a threshold.
inline Parameters foaming_sea() {
    Parameters parameters = wind_sea(128, 200.0);
    parameters.waves.front().wind_speed = 15.0;
    parameters.surface.foam_coverage = FoamCoverage::threshold;
    return parameters;
}

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
