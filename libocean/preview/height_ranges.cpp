// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "height_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ocean::preview {
namespace {

constexpr std::ptrdiff_t kTexelFloats = 4;  // of a texel; the height is the first

std::pair<float, float> joined(const std::pair<float, float>& a, const std::pair<float, float>& b) {
    return {std::min(a.first, b.first), std::max(a.second, b.second)};
}

}  // namespace

HeightRanges::HeightRanges(const LandImage& image, double margin)
    : origin_(image.origin), period_(image.period), wraps_(image.wraps) {
    add_finest(image, static_cast<float>(margin));
    while (levels_.back().side > 1) add_coarser();
}

/// Adds blocks of samples, each with the first samples of its neighbours.
void HeightRanges::add_finest(const LandImage& image, float margin) {
    const int n = image.resolution, side = (n + kBlock - 1) / kBlock;
    Level level{side, image.period / n * kBlock, {}};
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    level.ranges.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                        {kInfinity, -kInfinity});
    const auto inside = [&](int i) { return wraps_ ? i % n : std::min(i, n - 1); };
    for (int b = 0; b < side; ++b) {
        Range* const ranges = level.ranges.data() + b * side;
        for (int j = b * kBlock; j <= (b + 1) * kBlock; ++j) {
            const float* const row = image.texels.data() + kTexelFloats * inside(j) * n;
            for (int a = 0; a < side; ++a) {
                const int end = std::min((a + 1) * kBlock, n);
                const float beyond = row[kTexelFloats * inside(end)];
                float low = std::min(ranges[a].first, beyond);
                float high = std::max(ranges[a].second, beyond);
                for (int i = a * kBlock; i < end; ++i) {
                    low = std::min(low, row[kTexelFloats * i]);
                    high = std::max(high, row[kTexelFloats * i]);
                }
                ranges[a] = {low, high};
            }
        }
        for (int a = 0; a < side; ++a)
            ranges[a] = {ranges[a].first - margin, ranges[a].second + margin};
    }
    levels_.push_back(std::move(level));
}

void HeightRanges::add_coarser() {
    const Level& fine = levels_.back();
    Level level{(fine.side + 1) / 2, 2.0 * fine.block, {}};
    for (int b = 0; b < level.side; ++b) {
        for (int a = 0; a < level.side; ++a) {
            const auto of = [&](int i, int j) {
                const auto column = static_cast<std::size_t>(std::min(2 * a + i, fine.side - 1));
                const auto row = static_cast<std::size_t>(std::min(2 * b + j, fine.side - 1));
                return fine.ranges[row * static_cast<std::size_t>(fine.side) + column];
            };
            level.ranges.push_back(joined(joined(of(0, 0), of(1, 0)), joined(of(0, 1), of(1, 1))));
        }
    }
    levels_.push_back(std::move(level));
}

std::pair<float, float> HeightRanges::in(double x, double y, double side) const {
    std::size_t chosen = 0;
    while (chosen + 1 < levels_.size() && levels_[chosen].block < side) ++chosen;
    const Level& level = levels_[chosen];
    if (side >= period_ && wraps_) return levels_.back().ranges.front();
    const auto blocks = [&](double from, double origin) {
        const double first = std::floor((from - origin) / level.block);
        const double last = std::floor((from + side - origin) / level.block);
        const double end = level.side - 1;
        if (wraps_) return std::pair{first, last};
        return std::pair{std::clamp(first, 0.0, end), std::clamp(last, 0.0, end)};
    };
    const auto [left, right] = blocks(x, origin_[0]);
    const auto [low, high] = blocks(y, origin_[1]);
    const auto inside = [&](double at) {
        const double n = level.side;
        return static_cast<std::size_t>(at - n * std::floor(at / n));
    };
    Range range = level.ranges[inside(low) * static_cast<std::size_t>(level.side) + inside(left)];
    for (double b = low; b <= high; b += 1.0) {
        for (double a = left; a <= right; a += 1.0) {
            range = joined(
                range, level.ranges[inside(b) * static_cast<std::size_t>(level.side) + inside(a)]);
        }
    }
    return range;
}

}  // namespace ocean::preview
