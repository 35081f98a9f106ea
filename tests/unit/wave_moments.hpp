// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The shape of waves in records of gauges.
#pragma once

#include "ocean/internal/fft.hpp"

#include "testing.hpp"

namespace ocean {

struct Moments {
    double variance = 0.0, skewness = 0.0, asymmetry = 0.0;
};

/// Returns the moments of records of one length, a power of two. asymmetry: the mean cube of the
/// Hilbert transform in time, negative where fronts are steep.
inline Moments moments_of(const std::vector<std::vector<double>>& records) {
    Moments sums;
    double count = 0.0;
    for (const std::vector<double>& record : records) {
        const auto n = static_cast<double>(record.size());
        double mean = 0.0;
        for (const double h : record) mean += h / n;
        std::vector<std::complex<double>> signal;
        for (const double h : record) signal.emplace_back(h - mean);
        const Radix2Fft<double> fft(static_cast<int>(record.size()));
        fft.transform(signal.data(), 1, FftDirection::forward);
        for (std::size_t i = signal.size() / 2; i < signal.size(); ++i) signal[i] = 0.0;
        fft.transform(signal.data(), 1, FftDirection::inverse);
        for (const std::complex<double>& x : signal) {
            const std::complex<double> analytic = 2.0 / n * x;
            sums.variance += std::norm(analytic) / 2.0;
            sums.skewness += std::pow(analytic.real(), 3.0);
            sums.asymmetry += std::pow(analytic.imag(), 3.0);
        }
        count += n;
    }
    const double variance = sums.variance / count, unit = count * std::pow(variance, 1.5);
    return {variance, sums.skewness / unit, sums.asymmetry / unit};
}

}  // namespace ocean
