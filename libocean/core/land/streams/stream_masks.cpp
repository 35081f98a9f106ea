// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Masks from area, slope and the height above the nearest channel: see stream_masks.hpp.
#include "land/streams/stream_masks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ocean {
namespace {

/// Returns log2(x) of a normal x > 0, to 3e-7, with + - * / alone: the series of the area tangent
/// in (f - 1) / (f + 1), f the fraction of x within 0.7 .. 1.4.
float portable_log2(float x) {
    constexpr std::uint32_t kHalfRoot = 0x3F3504F3u;  // sqrt(1/2)
    const auto bits = std::bit_cast<std::uint32_t>(x) - kHalfRoot;
    const auto exponent = static_cast<float>(static_cast<std::int32_t>(bits) >> 23);
    const float f = std::bit_cast<float>((bits & 0x007FFFFFu) + kHalfRoot);
    const float t = (f - 1.0f) / (f + 1.0f);
    const float s = t * t;
    const float series = 1.0f + s * (1.0f / 3.0f + s * (0.2f + s * (1.0f / 7.0f)));
    return exponent + 2.8853901f * t * series;  // 2 / ln 2
}

/// Returns 2^x for |x| < 100 to 3e-6, with + and * alone.
float portable_exp2(float x) {
    const float whole = std::floor(x + 0.5f);
    const float y = (x - whole) * 0.69314718f;
    const float part =
        1.0f + y * (1.0f + y * (0.5f + y * (1.0f / 6.0f + y * (1.0f / 24.0f + y / 120.0f))));
    const auto bits = static_cast<std::uint32_t>(static_cast<int>(whole) + 127) << 23;
    return part * std::bit_cast<float>(bits);
}

/// Returns the depth of the floods of a channel with a drainage area [m2]. Depth rises as
/// discharge^0.4 [Leopold and Maddock 1953], and discharge as the area.
float flood_depth(float area) {
    constexpr float kSquareKilometre = 1e6f;
    constexpr float kPower = 0.4f;
    return static_cast<float>(kFloodDepth) *
           portable_exp2(kPower * portable_log2(area / kSquareKilometre));
}

/// Returns the slope at a cell, by central differences; one-sided ones at the border.
float slope_at(const StreamGrid& grid, std::span<const float> heights, int i, int j) {
    const int i0 = std::max(i - 1, 0), i1 = std::min(i + 1, grid.columns - 1);
    const int j0 = std::max(j - 1, 0), j1 = std::min(j + 1, grid.rows - 1);
    const auto cell = static_cast<float>(grid.cell);
    const float x = (heights[grid.index(i1, j)] - heights[grid.index(i0, j)]) /
                    (static_cast<float>(i1 - i0) * cell);
    const float y = (heights[grid.index(i, j1)] - heights[grid.index(i, j0)]) /
                    (static_cast<float>(j1 - j0) * cell);
    return std::sqrt(x * x + y * y);
}

float wetness_of(float area, float width, float slope) {
    constexpr float kLn2 = 0.69314718f;
    constexpr float kMinSlope = 1e-3f;
    const float index = kLn2 * portable_log2(area / (width * std::max(slope, kMinSlope)));
    constexpr auto kDry = static_cast<float>(kDryIndex), kWet = static_cast<float>(kWetIndex);
    return std::clamp((index - kDry) / (kWet - kDry), 0.0f, 1.0f);
}

}  // namespace

float channel_of(float area) {
    constexpr auto kScale = static_cast<float>(1.0 / kChannelArea);
    const float ratio = area * kScale;
    return 1.0f - 1.0f / (1.0f + ratio * ratio);
}

void set_wetness(const StreamGrid& grid, std::span<const std::uint8_t> directions,
                 std::span<const float> area, std::span<const float> height,
                 std::span<float> wetness, StreamWork& work) {
    const auto width = static_cast<float>(grid.cell);
    work.rows(grid, 0.4 * kMaskWork, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < grid.columns; ++i) {
                const CellIndex p = grid.index(i, j);
                const bool is_outlet = directions[p] == kOutlet;
                wetness[p] =
                    is_outlet ? 1.0f : wetness_of(area[p], width, slope_at(grid, height, i, j));
            }
        }
    });
}

void set_deposit(const StreamGrid& grid, const StreamWalk& walk,
                 std::span<const std::uint8_t> directions, std::span<const float> area,
                 std::span<const float> height, std::span<float> bed, StreamWork& work) {
    // The channel below each cell: the first channel downstream, or the outlet.
    PageVector<CellIndex> channel(grid.size());
    work.rows(grid, 0.1 * kMaskWork, [&](int first, int last) {
        for (CellIndex p = grid.index(0, first); p < grid.index(0, last); ++p) channel[p] = p;
    });
    walk.up(work, [&](CellIndex p, CellIndex receiver, int) {
        if (area[p] < static_cast<float>(kChannelArea)) channel[p] = channel[receiver];
    });
    work.rows(grid, 0.2 * kMaskWork, [&](int first, int last) {
        for (CellIndex p = grid.index(0, first); p < grid.index(0, last); ++p) {
            if (directions[p] == kOutlet) {
                bed[p] = 0.0f;
                continue;
            }
            const float thickness = std::max(height[p] - bed[p], 0.0f);
            const float soil = thickness / (thickness + static_cast<float>(kSoilDepth));
            const CellIndex q = channel[p];
            const float above = std::max(height[p] - height[q], 0.0f);
            const float alluvium = std::max(1.0f - above / flood_depth(area[q]), 0.0f);
            bed[p] = std::max(soil, alluvium);
        }
    });
}

}  // namespace ocean
