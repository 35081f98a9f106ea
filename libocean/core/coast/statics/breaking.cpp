// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table of LimiterGain: see breaking.hpp. Heights u = s x, x^2 exponentially distributed with
// mean 1, have the mean square s^2; after the limiter the mean square is M(s) = E f(s x)^2. The
// gain C for the ratio rho is s / rho with M(s) = rho^2.
#include "breaking.hpp"

namespace ocean {
namespace {

constexpr double kHighestX = 6.0;  // a share exp(-36) of the waves is higher
constexpr int kNodes = 192;        // of Simpson's rule, even
constexpr double kLargestScale = 8.0;
constexpr double kScaleStep = 1.0 / 128.0;

/// Returns M(s) by Simpson's rule.
double limited_mean_square(double s) {
    const double step = kHighestX / kNodes;
    double sum = 0.0;
    for (int n = 1; n <= kNodes; ++n) {
        const double x = n * step;
        const double weight = n == kNodes ? 1.0 : n % 2 == 1 ? 4.0 : 2.0;
        const double f = limited(s * x);
        sum += weight * 2.0 * x * std::exp(-x * x) * f * f;
    }
    return sum * step / 3.0;
}

}  // namespace

LimiterGain::LimiterGain() : table_(kIntervals + 1, 1.0) {
    double s = 0.0, below = 0.0, rms = 0.0;  // rms of the limited heights at s - kScaleStep, and s
    for (std::size_t i = 1; i <= kIntervals; ++i) {
        const double rho = kHighestRatio * static_cast<double>(i) / kIntervals;
        while (rms < rho && s < kLargestScale) {
            below = rms;
            s += kScaleStep;
            rms = std::sqrt(limited_mean_square(s));
        }
        table_[i] = (s - kScaleStep * (rms - rho) / (rms - below)) / rho;
    }
}

}  // namespace ocean
