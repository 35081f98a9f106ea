// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Expected rings: see expected_rings.hpp.
//
// With the covariance C(r) of the land, the inverse transform of its S dkx dky, and weights w,
//   E |sum w h exp(-ikx)|^2 = sum over r of C(r) A(r) exp(-ikr),  A(r) = sum over x of w(x) w(x +
//   r)
// [Percival and Walden 1993, chapter 6]. The lags r reach from -(n - 1) to n - 1. Folded to the
// length of the transform of measure_rings, their sum has the same values at its wavenumbers.
#include "expected_rings.hpp"

#include <bit>
#include <cmath>
#include <complex>
#include <cstdlib>

#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/terrain_law.hpp"
#include "ocean/page_vector.hpp"
#include "ring_sums.hpp"

namespace ocean {
namespace {

/// A complex array of powers of two that is transformed by all threads.
struct ComplexGrid {
    int columns;
    int rows;
    PageVector<std::complex<double>> values;

    ComplexGrid(int its_columns, int its_rows) : columns(its_columns), rows(its_rows) {
        const auto count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
        require_memory(count * sizeof(std::complex<double>), "the expected spectrum of a terrain");
        values.assign(count, 0.0);
    }
    std::complex<double>& at(int i, int j) {
        return values[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(i)];
    }

    void transform(FftDirection direction, ThreadPool& pool) {
        const Radix2Fft<double> along_row(columns), along_column(rows);
        pool.for_each_range(rows, [&](int first, int last) {
            for (int j = first; j < last; ++j) along_row.transform(&at(0, j), 1, direction);
        });
        pool.for_each_range(columns, [&](int first, int last) {
            std::vector<std::complex<double>> column(static_cast<std::size_t>(rows));
            for (int i = first; i < last; ++i) {
                for (int j = 0; j < rows; ++j) column[static_cast<std::size_t>(j)] = at(i, j);
                along_column.transform(column.data(), 1, direction);
                for (int j = 0; j < rows; ++j) at(i, j) = column[static_cast<std::size_t>(j)];
            }
        });
    }
};

/// Returns C(r) of the terrain's tile.
ComplexGrid covariance_of(const TerrainModel& terrain, ThreadPool& pool) {
    const int n = terrain.resolution;
    const double dk = kTwoPi / terrain.patch_size;
    const TerrainLaw law(terrain);
    ComplexGrid grid(n, n);
    pool.for_each_range(n, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const int m = signed_wavenumber(j, n);
            for (int i = 0; i < n; ++i) {
                const int k = signed_wavenumber(i, n);
                const bool is_wave = (k != 0 || m != 0) && k != -n / 2 && m != -n / 2;
                if (is_wave) grid.at(i, j) = law.density(k * dk, m * dk) * dk * dk;
            }
        }
    });
    grid.transform(FftDirection::inverse, pool);
    return grid;
}

/// Returns A(r) of one side for r = 0 .. n - 1.
std::vector<double> autocorrelation(const std::vector<double>& weights) {
    std::vector<double> sums(weights.size(), 0.0);
    for (std::size_t lag = 0; lag < weights.size(); ++lag) {
        for (std::size_t i = lag; i < weights.size(); ++i) {
            sums[lag] += weights[i] * weights[i - lag];
        }
    }
    return sums;
}

int padded(int samples) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(samples)));
}

/// Returns the land's covariance times the window's, folded.
ComplexGrid folded_covariance(ComplexGrid& covariance, const std::array<int, 2>& samples,
                              const std::vector<double>& window_x,
                              const std::vector<double>& window_y) {
    ComplexGrid folded(padded(samples[0]), padded(samples[1]));
    const auto wrapped = [](int lag, int period) { return (lag % period + period) % period; };
    for (int y = -samples[1] + 1; y < samples[1]; ++y) {
        const double weight_y = window_y[static_cast<std::size_t>(std::abs(y))];
        for (int x = -samples[0] + 1; x < samples[0]; ++x) {
            const double weight = weight_y * window_x[static_cast<std::size_t>(std::abs(x))];
            folded.at(wrapped(x, folded.columns), wrapped(y, folded.rows)) +=
                weight * covariance.at(wrapped(x, covariance.columns), wrapped(y, covariance.rows));
        }
    }
    return folded;
}

}  // namespace

std::vector<double> expected_rings(const TerrainModel& terrain, const std::array<int, 2>& samples,
                                   const RingOptions& options, ThreadPool& pool) {
    const double cell = terrain.patch_size / terrain.resolution;
    const std::vector<double> window_x = autocorrelation(taper_weights(samples[0], true));
    const std::vector<double> window_y = autocorrelation(taper_weights(samples[1], true));
    ComplexGrid covariance = covariance_of(terrain, pool);
    ComplexGrid power = folded_covariance(covariance, samples, window_x, window_y);
    power.transform(FftDirection::forward, pool);
    const double density = cell * cell / (kTwoPi * kTwoPi * window_x[0] * window_y[0]);
    const auto [lowest, end] = options.limits.value();
    const RingEdges edges{lowest, end, options.rings_per_octave};
    std::vector<RingSums> sums(static_cast<std::size_t>(edges.count()));
    for (int j = 0; j < power.rows; ++j) {
        const double ky = kTwoPi * signed_wavenumber(j, power.rows) / (power.rows * cell);
        for (int i = 0; i < power.columns; ++i) {
            const double kx = kTwoPi * signed_wavenumber(i, power.columns) / (power.columns * cell);
            const int ring = edges.ring_of(std::hypot(kx, ky));
            if (ring < 0) continue;
            sums[static_cast<std::size_t>(ring)].add(density * power.at(i, j).real(), 0.0, 1.0);
        }
    }
    std::vector<double> densities;
    for (const RingSums& ring : sums) {
        if (ring.weight > 0.0) densities.push_back(ring.density / ring.weight);
    }
    return densities;
}

}  // namespace ocean
