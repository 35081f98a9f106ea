// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Steady and aged heights: see stream_heights.hpp.
#include "land/streams/stream_heights.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ocean {
namespace {

constexpr int kNodeBits = 8;  // nodes an octave: 2^8
constexpr int kShift = 23 - kNodeBits;
constexpr std::uint32_t kFirstNode = 127u << kNodeBits;  // of 1.0f

/// Returns log2(x) for x >= 1, bit by bit: squaring x doubles its logarithm.
double exact_log2(double x) {
    double whole = 0.0;
    for (; x >= 2.0; x *= 0.5) whole += 1.0;
    double part = 0.0;
    for (double bit = 0.5; bit > 1e-16; bit *= 0.5) {
        x *= x;
        if (x < 2.0) continue;
        x *= 0.5;
        part += bit;
    }
    return whole + part;
}

/// Returns 2^-y for y >= 0, bit by bit: a root halves the exponent.
double exact_exp2_of_minus(double y) {
    double result = 1.0;
    for (; y >= 1.0; y -= 1.0) result *= 0.5;
    double factor = 0.5;
    for (double bit = 0.5; bit > 1e-17; bit *= 0.5) {
        factor = std::sqrt(factor);
        if (y < bit) continue;
        result *= factor;
        y -= bit;
    }
    return result;
}

}  // namespace

SteadySlope::SteadySlope(const StreamSettings& settings, double cell)
    : max_(static_cast<float>(settings.max_slope)) {
    constexpr int kOctaves = 32;
    for (int node = 0; node <= kOctaves << kNodeBits; ++node) {
        const auto bits = (kFirstNode + static_cast<std::uint32_t>(node)) << kShift;
        const double area = double{std::bit_cast<float>(bits)} * cell * cell;
        const double ratio = std::max(1.0, area / settings.hillslope_area);
        nodes_.push_back(static_cast<float>(
            settings.slope * exact_exp2_of_minus(settings.exponent * exact_log2(ratio))));
    }
}

float SteadySlope::operator()(std::uint32_t count) const {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(count));
    const float part = static_cast<float>(bits & ((1u << kShift) - 1)) * (1.0f / (1u << kShift));
    const float* const node = nodes_.data() + ((bits >> kShift) - kFirstNode);
    return node[0] + part * (node[1] - node[0]);
}

void set_steady(const StreamGrid& grid, const SteadySlope& slope, const StreamWalk& walk,
                std::span<const std::uint32_t> counts, std::span<const float> uplift,
                std::span<float> heights, std::span<float> response, StreamWork& work) {
    const auto straight = static_cast<float>(grid.distance(0));
    const auto diagonal = static_cast<float>(grid.distance(1));
    walk.up(work, [&](CellIndex p, CellIndex receiver, int direction) {
        const float u = std::max(uplift[p], kMinUplift);
        const float distance = (direction & 1) != 0 ? diagonal : straight;
        const float rise = std::min(u * slope(counts[p]), slope.max()) * distance;
        heights[p] = risen(heights[receiver], rise);
        if (!response.empty()) response[p] = risen(response[receiver], rise / u);
    });
}

void set_aged(const StreamWalk& walk, double time, std::span<const float> steady,
              std::span<const float> response, std::span<float> heights, StreamWork& work) {
    const auto age = static_cast<float>(time);
    walk.up_with_paths(work, [&](std::span<const CellIndex> path) {
        const CellIndex p = path.back();
        const float target = response[p] - age;
        if (target <= 0.0f) {
            heights[p] = steady[p];
            return;
        }
        // Linear between two cells of the path: the slope that arrives now set out between them.
        const auto above =
            std::ranges::upper_bound(path, target, {}, [&](CellIndex q) { return response[q]; });
        const CellIndex upper = above == path.end() ? p : *above;
        const CellIndex lower = *(above - 1);
        const float span = response[upper] - response[lower];
        const float part = span > 0.0f ? (target - response[lower]) / span : 0.0f;
        const float then = steady[lower] + part * (steady[upper] - steady[lower]);
        heights[p] = steady[p] - then + steady[path.front()];
    });
}

}  // namespace ocean
