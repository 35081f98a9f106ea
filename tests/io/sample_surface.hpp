// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Surfaces with known values, so that the file tests need no waves: every channel of every sample
// has a value of its own, smooth and periodic.
#pragma once

#include <cmath>

#include "../temporary_folder.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/surface.hpp"

namespace ocean::test {

inline constexpr double kSamplePeriod = 100.0;

/// Channel c at sample (i, j): an upright, tilted pair of waves; unequal under any swap of
/// channels, rows, columns or signs.
inline float sample_value(int channel, int i, int j, int n) {
    const double x = kTwoPi * i / n, y = kTwoPi * j / n;
    return static_cast<float>((1.0 + channel) * (std::sin(x + 0.1 * channel) +
                                                 0.5 * std::cos(2.0 * y + x + 0.3 * channel)));
}

inline ChannelSet all_channels() {
    ChannelSet all;
    for (int c = 0; c < kChannelCount; ++c) all = all | ChannelSet{static_cast<Channel>(c)};
    return all;
}

inline Surface sample_surface(int n, double time = 12.25, ChannelSet channels = all_channels()) {
    Surface surface(Lattice{n, kSamplePeriod}, time, channels);
    for (int c = 0; c < kChannelCount; ++c) {
        if (!channels.contains(static_cast<Channel>(c))) continue;
        const auto map = surface.channel(static_cast<Channel>(c));
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                map[static_cast<std::size_t>(j * n + i)] = sample_value(c, i, j, n);
            }
        }
    }
    return surface;
}

}  // namespace ocean::test
