// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The register of noise streams: the third argument of gaussian_noise (shaders/wave/noise.glsl)
// identifies the user of a number. No two users share a stream, so an addition for one of them does
// not change the sea of another. The numbers of a seed and stream are promised and never change.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ocean {

/// The first stream of each user.
enum class NoiseStream : std::uint32_t {
    cascades = 0,
    detail_bands = 16,
    foam_textures = 0x1000,
    foam_cover = 0x666F616D,
    terrain = 0x74657272,
};

inline constexpr std::uint32_t kStreamsOfFoamTexture = 0x10;

/// Streams from the first of a user on.
struct NoiseStreamRange {
    NoiseStream first;
    std::uint32_t count;
};
inline constexpr std::array kNoiseStreams = {
    NoiseStreamRange{NoiseStream::cascades, 5},
    NoiseStreamRange{NoiseStream::detail_bands, 3},
    NoiseStreamRange{NoiseStream::foam_textures, 3 * kStreamsOfFoamTexture},
    NoiseStreamRange{NoiseStream::foam_cover, 1},
    NoiseStreamRange{NoiseStream::terrain, 2},  // the first tile, and its layers
};
static_assert(
    [] {
        for (std::size_t i = 1; i < kNoiseStreams.size(); ++i) {
            const auto [first, count] = kNoiseStreams[i - 1];
            if (static_cast<std::uint32_t>(first) + count >
                static_cast<std::uint32_t>(kNoiseStreams[i].first)) {
                return false;
            }
        }
        return true;
    }(),
    "two users of noise would draw the same numbers");

/// Returns the number of streams of a user.
consteval std::uint32_t streams_of(NoiseStream user) {
    for (const auto& [first, count] : kNoiseStreams) {
        if (first == user) return count;
    }
    return 0;
}

/// Returns the stream number of a user for gaussian_noise and noise_row.
constexpr std::uint32_t noise_stream(NoiseStream user, std::uint32_t index = 0) {
    return static_cast<std::uint32_t>(user) + index;
}

}  // namespace ocean
