// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One inverse transform of independent complex amplitudes on a grid that is just fine enough for
// the band; between its samples Catmull and Rom's cubic interpolates, first along y, then along x.
#include "waves/foam/tiled_noise.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/noise_row.hpp"
#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

/// Min samples per cycle of the highest wavenumber.
constexpr double kSamplesPerCycle = 2.5;

using Complex = std::complex<float>;

/// Returns k^(-falloff / 4) by roots alone, which round the same way everywhere.
double amplitude(double k, int falloff) {
    const double root = std::sqrt(std::sqrt(k));
    double result = 1.0;
    for (int i = 0; i < falloff; ++i) result /= root;
    return result;
}

struct CubicPlace {
    std::array<int, 4> sample;
    std::array<float, 4> weight;
};

/// Returns the cubic weights at x samples from sample 0 of a periodic row. [Catmull and Rom 1974]
CubicPlace cubic_place(double x, int samples) {
    const double whole = std::floor(x);
    const auto t = static_cast<float>(x - whole);
    const int first = static_cast<int>(whole) - 1 + samples;
    CubicPlace place{{},
                     {((2.0f - t) * t - 1.0f) * t * 0.5f, ((3.0f * t - 5.0f) * t * t + 2.0f) * 0.5f,
                      ((4.0f - 3.0f * t) * t + 1.0f) * t * 0.5f, (t - 1.0f) * t * t * 0.5f}};
    for (int k = 0; k < 4; ++k)
        place.sample[static_cast<std::size_t>(k)] = (first + k) & (samples - 1);
    return place;
}

}  // namespace

TiledNoise::TiledNoise(std::uint32_t seed, std::uint32_t field, const NoiseBand& band, int size) {
    const int shown = std::min(static_cast<int>(band.highest), size / 3);
    side_ = static_cast<int>(std::bit_ceil(static_cast<unsigned>(kSamplesPerCycle * shown)));
    grid_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), {});
    const auto highest = static_cast<int>(band.highest);
    std::vector<Complex> draws(static_cast<std::size_t>(2 * highest + 1));
    double variance = 0.0;
    for (int m = -highest; m <= highest; ++m) {
        noise_row(seed, field, -highest, m, draws);
        for (int n = -highest; n <= highest; ++n) {
            const double x = band.stretch * n, y = m;
            const double k = std::sqrt(x * x + y * y);
            if (k < band.lowest || k > band.highest) continue;
            const double a = amplitude(k, band.falloff);
            variance += a * a;
            if (std::max(std::abs(n), std::abs(m)) > shown) continue;
            grid_[mode_index(n, m, side_)] =
                static_cast<float>(a) * draws[static_cast<std::size_t>(n + highest)];
        }
    }
    const auto scale = static_cast<float>(1.0 / std::sqrt(variance));
    for (Complex& mode : grid_) mode *= scale;
    Radix2Fft<float>(side_).transform_2d(grid_, FftDirection::inverse);
}

void TiledNoise::row(double v, std::span<Complex> values) const {
    const CubicPlace y = cubic_place(v * side_, side_);
    const auto width = static_cast<std::size_t>(side_);
    std::vector<Complex> line(width);
    for (std::size_t k = 0; k < 4; ++k) {
        const Complex* samples = grid_.data() + static_cast<std::size_t>(y.sample[k]) * width;
        for (std::size_t i = 0; i < width; ++i) line[i] += y.weight[k] * samples[i];
    }
    const double step = static_cast<double>(side_) / static_cast<double>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const CubicPlace x = cubic_place((static_cast<double>(i) + 0.5) * step, side_);
        Complex sum;
        for (std::size_t k = 0; k < 4; ++k) {
            sum += x.weight[k] * line[static_cast<std::size_t>(x.sample[k])];
        }
        values[i] = sum;
    }
}

}  // namespace ocean
