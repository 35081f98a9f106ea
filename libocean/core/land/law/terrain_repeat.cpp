// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Autocorrelations of tiles; see terrain_repeat.hpp.
#include "ocean/terrain_repeat.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/modes.hpp"

namespace ocean {
namespace {

constexpr int kMaxRepeatedSide = 4096;
constexpr double kBeyond = 0.1;  // peaks count where the mean correlation is below this

using PowerPlane = std::vector<std::complex<float>>;

/// Returns the signed lag of an index [samples].
int lag(int i, int side) {
    return i < side / 2 ? i : i - side;
}

/// Returns the first distance at which the mean over directions is below kBeyond [samples].
double first_distance(const std::vector<float>& correlation, int side) {
    std::vector<double> sum(static_cast<std::size_t>(side)), count(sum.size());
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const double distance = std::hypot(lag(i, side), lag(j, side));
            const auto ring = static_cast<std::size_t>(distance);
            sum[ring] += static_cast<double>(correlation[static_cast<std::size_t>(j * side + i)]);
            count[ring] += 1.0;
        }
    }
    for (std::size_t ring = 1; ring < sum.size() && count[ring] > 0.0; ++ring) {
        if (sum[ring] < kBeyond * count[ring]) return static_cast<double>(ring);
    }
    return side;
}

RepeatPeak highest_peak(const std::vector<float>& correlation, int side, double cell) {
    const double begin = first_distance(correlation, side);
    const int mask = side - 1;
    RepeatPeak peak;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const float here = correlation[static_cast<std::size_t>(j * side + i)];
            if (static_cast<double>(here) <= peak.correlation) continue;
            const double distance = std::hypot(lag(i, side), lag(j, side));
            if (distance < begin) continue;
            bool is_highest = true;
            for (int dj = -1; dj <= 1; ++dj) {
                for (int di = -1; di <= 1; ++di) {
                    const int at = ((j + dj) & mask) * side + ((i + di) & mask);
                    is_highest &= correlation[static_cast<std::size_t>(at)] <= here;
                }
            }
            if (is_highest) peak = {static_cast<double>(here), cell * distance};
        }
    }
    return peak;
}

std::vector<float> normalised(const PowerPlane& plane, bool imaginary) {
    const auto part = [&](const std::complex<float>& value) {
        return imaginary ? value.imag() : value.real();
    };
    const float all = part(plane.front());
    std::vector<float> correlation;
    correlation.reserve(plane.size());
    for (const auto& value : plane) correlation.push_back(all > 0.0f ? part(value) / all : 0.0f);
    return correlation;
}

}  // namespace

TerrainRepeat find_repeat(const Modes& modes) {
    const CascadeModes& tile = modes.cascades.front();
    const int own = tile.lattice.resolution;
    const int side = std::min(own, kMaxRepeatedSide);
    require_memory(tile.lattice.size() * (sizeof(std::complex<float>) + 2 * sizeof(float)),
                   "the autocorrelation of the terrain");
    const double dk = tile.lattice.wavenumber_step();
    // Both powers are even and real, so that one transform holds both of theirs as its two parts.
    PowerPlane plane(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int m = 1 - side / 2; m < side / 2; ++m) {
        for (int n = 1 - side / 2; n < side / 2; ++n) {
            const double power = std::norm(std::complex<double>(tile.h0[mode_index(n, m, own)]));
            const double k_square = dk * dk * (n * n + m * m);
            plane[mode_index(n, m, side)] = {static_cast<float>(power),
                                             static_cast<float>(power * k_square)};
        }
    }
    Radix2Fft<float>(side).transform_2d(plane, FftDirection::inverse);
    const double cell = tile.lattice.period / side;
    return {highest_peak(normalised(plane, false), side, cell),
            highest_peak(normalised(plane, true), side, cell)};
}

}  // namespace ocean
