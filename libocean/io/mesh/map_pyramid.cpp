// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Interpolates maps by Catmull-Rom splines in both directions, which pass through the samples and
// have a continuous slope: a reflection would show its steps.
#include "map_pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ocean/error.hpp"
#include "require_channels.hpp"

namespace ocean::io {
namespace {

constexpr std::array kSampled{Channel::dx, Channel::dy, Channel::height,
                              Channel::nx, Channel::ny, Channel::nz};
using Values = std::array<double, kSampled.size()>;
constexpr Values kStillWater{0.0, 0.0, 0.0, 0.0, 0.0, 1.0};

// The coarsest map still has the swell, so that it fades over more than one octave.
constexpr double kOctavesToStillWater = 2.0;

std::array<double, 4> catmull_rom(double f) {
    return {f * (-0.5 + f * (1.0 - 0.5 * f)), 1.0 + f * f * (-2.5 + 1.5 * f),
            f * (0.5 + f * (2.0 - 1.5 * f)), f * f * (-0.5 + 0.5 * f)};
}

// The indices, wrapped, and the weights of the four samples around a coordinate.
struct Taps {
    std::array<std::size_t, 4> index;
    std::array<double, 4> weight;
};

Taps find_taps(double coordinate, int n) {
    const double whole = std::floor(coordinate);
    const auto first = static_cast<long long>(whole) - 1;
    Taps taps{{}, catmull_rom(coordinate - whole)};
    for (int k = 0; k < 4; ++k) {
        // n is a power of two: the mask is the modulus, also of negative numbers.
        taps.index[static_cast<std::size_t>(k)] = static_cast<std::size_t>((first + k) & (n - 1));
    }
    return taps;
}

Values interpolate(const Surface& surface, double x, double y) {
    const int n = surface.resolution();
    const double samples_per_metre = n / surface.period();
    const Taps across = find_taps(x * samples_per_metre, n);
    const Taps up = find_taps(y * samples_per_metre, n);
    Values values{};
    for (std::size_t c = 0; c < kSampled.size(); ++c) {
        const auto map = surface.channel(kSampled[c]);
        for (std::size_t j = 0; j < 4; ++j) {
            const float* row = &map[up.index[j] * static_cast<std::size_t>(n)];
            double sum = 0.0;
            for (std::size_t i = 0; i < 4; ++i) sum += across.weight[i] * row[across.index[i]];
            values[c] += up.weight[j] * sum;
        }
    }
    return values;
}

SlopeVariance measure(const Surface& surface) {
    const auto slope_x = surface.channel(Channel::slope_x);
    const auto slope_y = surface.channel(Channel::slope_y);
    SlopeVariance sum;  // the mean slope of a periodic surface is zero
    for (std::size_t i = 0; i < slope_x.size(); ++i) {
        const double x = slope_x[i], y = slope_y[i];
        sum.xx += x * x;
        sum.xy += x * y;
        sum.yy += y * y;
    }
    const double scale = 1.0 / static_cast<double>(slope_x.size());
    return {sum.xx * scale, sum.xy * scale, sum.yy * scale};
}

// Returns the variance of all waves minus the variance of a blend of two levels. Waves of the finer
// level only have the weight w and the variance w^2; waves of both levels are complete.
SlopeVariance left_out(const SlopeVariance& all, const SlopeVariance& fine,
                       const SlopeVariance& coarse, double weight) {
    const double kept = (1.0 - weight) * (1.0 - weight);
    const auto part = [kept](double whole, double finer, double coarser) {
        return whole - coarser - kept * (finer - coarser);
    };
    return {part(all.xx, fine.xx, coarse.xx), part(all.xy, fine.xy, coarse.xy),
            part(all.yy, fine.yy, coarse.yy)};
}

}  // namespace

MapPyramid::MapPyramid(std::span<const Surface> levels) : levels_(levels) {
    if (levels.empty()) throw Error(ErrorKind::invalid_value, "a horizon mesh needs a map");
    for (std::size_t l = 0; l < levels.size(); ++l) {
        require_channels(levels[l], {Channel::dx, Channel::dy, Channel::height, Channel::nx,
                                     Channel::ny, Channel::nz, Channel::slope_x, Channel::slope_y});
        if (l > 0 &&
            (levels[l].resolution() * 2 != levels[l - 1].resolution() ||
             levels[l].period() != levels[0].period() || levels[l].time() != levels[0].time())) {
            throw Error(ErrorKind::invalid_value,
                        "level " + std::to_string(l) + " of " +
                            std::to_string(levels[l].resolution()) +
                            " samples is not half the one before, of the same sea and time");
        }
        variance_.push_back(measure(levels[l]));
    }
    variance_.emplace_back();
}

MapPyramid::Blend MapPyramid::blend(double spacing) const {
    const double finest = levels_[0].period() / levels_[0].resolution();
    const auto coarsest = static_cast<double>(levels_.size() - 1);
    const double level = std::max(0.0, std::log2(spacing / finest));
    if (level >= coarsest) {
        const double faded = std::min(1.0, (level - coarsest) / kOctavesToStillWater);
        return {levels_.size() - 1, levels_.size(), faded};
    }
    const auto fine = static_cast<std::size_t>(level);
    return {fine, fine + 1, level - static_cast<double>(fine)};
}

PyramidSample MapPyramid::sample(double x, double y, double spacing) const {
    const auto [fine, coarse, weight] = blend(spacing);
    Values values = interpolate(levels_[fine], x, y);
    if (weight > 0.0) {
        const Values other =
            coarse == levels_.size() ? kStillWater : interpolate(levels_[coarse], x, y);
        for (std::size_t c = 0; c < values.size(); ++c) {
            values[c] += weight * (other[c] - values[c]);
        }
    }
    const double length =
        std::sqrt(values[3] * values[3] + values[4] * values[4] + values[5] * values[5]);
    return {values[0],
            values[1],
            values[2],
            values[3] / length,
            values[4] / length,
            values[5] / length,
            left_out(variance_[0], variance_[fine], variance_[coarse], weight)};
}

}  // namespace ocean::io
