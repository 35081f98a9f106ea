// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An island of fractional land whose coast is the same line at every resolution.
#pragma once

#include <cstddef>
#include <cstdint>

#include "flood.hpp"
#include "ocean/internal/stream_power.hpp"
#include "ocean/terrain.hpp"
#include "test_seas.hpp"

namespace ocean::test {

class StreamIsland {
  public:
    static constexpr double kSide = 16384.0;  // [m]

    explicit StreamIsland(std::uint32_t seed = 5) : seed_(seed) {}

    /// Returns the level of n x n cells, n a power of two within 32 .. 4096.
    StreamLevel level(int n) const {
        const std::vector<float> noise = noise_of(n, 2 * n);
        const std::vector<float> coast = noise_of(std::min(n, 128), 2 * n);
        StreamLevel level;
        const auto size = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
        std::vector<float> shore(size);
        for (const auto [i, j, p] : cells(n, n)) {
            const double x = (i + 0.5) / n * 2.0 - 1.0, y = (j + 0.5) / n * 2.0 - 1.0;
            shore[p] =
                static_cast<float>(0.62 + 0.20 * double{coast[p]} - std::sqrt(x * x + y * y));
        }
        level.outlet = sea_of(shore, n);
        for (std::size_t p = 0; p < size; ++p) {
            const float s = std::clamp(shore[p], 0.0f, 1.0f);
            level.uplift.push_back(0.25f + 0.75f * std::min(s / 0.35f, 1.0f));
            level.start.push_back(level.outlet[p] != 0
                                      ? 0.0f
                                      : 40.0f * noise[p] * std::min(s / 0.1f, 1.0f) + 300.0f * s);
        }
        return level;
    }

    StreamSource source() const {
        return [this](int columns, int, double) { return level(columns); };
    }

  private:
    /// Returns noise with the waves of n samples a side, at the centres of `map` / 2 cells a side.
    std::vector<float> noise_of(int n, int map) const {
        TerrainModel terrain;
        terrain.resolution = n;
        terrain.patch_size = kSide;
        terrain.beta = 1.9;
        terrain.outer_scale = 9000.0;
        terrain.rms = 1.0;
        terrain.seed = seed_;
        const auto heights = values_of(Terrain(terrain).surface({Channel::height}, map));
        std::vector<float> centres;
        for (const auto [i, j, at] : cells(map, map)) {
            if (i % 2 == 1 && j % 2 == 1) centres.push_back(heights[at]);
        }
        return centres;
    }

    /// Returns 1 for cells below the shore that are connected to the south-west corner.
    static std::vector<std::uint8_t> sea_of(const std::vector<float>& shore, int n) {
        std::vector<std::uint8_t> sea(shore.size(), 0);
        std::vector<char> seen(shore.size());
        const auto is_sea = [&](std::size_t at) { return at == 0 || shore[at] < 0.0f; };
        for (const std::size_t at : piece_of(0, n, n, seen, is_sea)) sea[at] = 1;
        return sea;
    }

    std::uint32_t seed_;
};

}  // namespace ocean::test
