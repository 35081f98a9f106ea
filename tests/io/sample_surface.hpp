// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Surfaces with known values, so that the file tests need no waves: every channel of every sample
// has a value of its own, smooth and periodic.
#pragma once

#include <unistd.h>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

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

inline Surface sample_surface(int n, double time = 12.25) {
    Surface surface(Lattice{n, kSamplePeriod}, time, all_channels());
    for (int c = 0; c < kChannelCount; ++c) {
        const auto map = surface.channel(static_cast<Channel>(c));
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                map[static_cast<std::size_t>(j * n + i)] = sample_value(c, i, j, n);
            }
        }
    }
    return surface;
}

/// A folder of its own that goes with the object.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "ocean-io-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string path() const { return path_.string(); }
    /// Hidden names included.
    std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_),
                                                      std::filesystem::directory_iterator()));
    }

  private:
    std::filesystem::path path_;
};

inline std::string read_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace ocean::test
