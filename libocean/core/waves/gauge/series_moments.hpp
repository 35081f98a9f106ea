// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Mean and variance of a gauge's time series, which its waves, its spectrum and its sea state all
// need.
#pragma once

#include <numeric>
#include <span>

namespace ocean {

struct SeriesMoments {
    double mean = 0.0;
    double variance = 0.0;  // about the mean, divided by the number of samples
};

/// Returns both moments; 0 and 0 for an empty series.
inline SeriesMoments moments_of(std::span<const double> values) {
    if (values.empty()) return {};
    const auto count = static_cast<double>(values.size());
    SeriesMoments moments;
    moments.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    for (const double value : values) {
        moments.variance += (value - moments.mean) * (value - moments.mean);
    }
    moments.variance /= count;
    return moments;
}

}  // namespace ocean
