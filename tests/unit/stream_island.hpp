// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An island of fractional land whose coast is the same line at every resolution.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ocean/internal/stream_power.hpp"
#include "ocean/terrain.hpp"

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
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const double x = (i + 0.5) / n * 2.0 - 1.0, y = (j + 0.5) / n * 2.0 - 1.0;
                const std::size_t p = static_cast<std::size_t>(j) * static_cast<std::size_t>(n) +
                                      static_cast<std::size_t>(i);
                shore[p] = static_cast<float>(0.62 + 0.20 * static_cast<double>(coast[p]) -
                                              std::sqrt(x * x + y * y));
            }
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
        const Surface surface = Terrain(terrain).surface({Channel::height}, map);
        const auto heights = surface.channel(Channel::height);
        std::vector<float> centres;
        for (int j = 1; j < map; j += 2) {
            for (int i = 1; i < map; i += 2) {
                centres.push_back(
                    heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(map) +
                            static_cast<std::size_t>(i)]);
            }
        }
        return centres;
    }

    /// Returns 1 for cells below the shore that are connected to the south-west corner.
    static std::vector<std::uint8_t> sea_of(const std::vector<float>& shore, int n) {
        std::vector<std::uint8_t> sea(shore.size(), 0);
        std::vector<int> open = {0};
        sea[0] = 1;
        while (!open.empty()) {
            const int p = open.back();
            open.pop_back();
            const int i = p % n, j = p / n;
            const auto enter = [&](bool inside, int q) {
                if (!inside || sea[static_cast<std::size_t>(q)] != 0) return;
                if (shore[static_cast<std::size_t>(q)] >= 0.0f) return;
                sea[static_cast<std::size_t>(q)] = 1;
                open.push_back(q);
            };
            enter(i > 0, p - 1);
            enter(i < n - 1, p + 1);
            enter(j > 0, p - n);
            enter(j < n - 1, p + n);
        }
        return sea;
    }

    std::uint32_t seed_;
};

}  // namespace ocean::test
