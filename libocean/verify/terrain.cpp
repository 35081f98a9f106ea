// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The exponents of fractal land: of its spectrum, and of the variogram.
#include "ocean/terrain.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <string>

#include "bench.hpp"
#include "literature.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::verify {
namespace {

constexpr int kSize = 1024;
constexpr double kPatch = 2000.0;
constexpr int kSeeds = 4;

TerrainModel fractal(double beta, int seed) {
    TerrainModel terrain;
    terrain.resolution = kSize;
    terrain.patch_size = kPatch;
    terrain.beta = beta;
    terrain.rms = 25.0;
    terrain.seed = static_cast<std::uint32_t>(seed);
    return terrain;
}

/// Returns the log density over the log wavenumber of rings, four to an octave, of the last two
/// decades before the Nyquist wavenumber; `error` is the number of waves of a ring.
std::vector<Point> rings_of(std::span<const float> heights) {
    const std::vector<std::complex<double>> c = coefficients(heights);
    const double dk = 2.0 * kPi / kPatch;
    std::vector<Point> rings(40, Point{0.0, 0.0});
    for (std::size_t at = 1; at < c.size(); ++at) {
        const double index =
            std::hypot(wave_index(at % kSize, kSize), wave_index(at / kSize, kSize));
        if (index > kSize / 2 - 1) continue;
        Point& ring = rings[static_cast<std::size_t>(4.0 * std::log2(index) + 1e-9)];
        ring.x += std::log(index * dk);
        ring.y += std::norm(c[at]) / (dk * dk);
        ring.error += 1.0;
    }
    std::vector<Point> kept;
    for (const Point& ring : rings) {
        if (ring.error == 0.0) continue;
        const double x = ring.x / ring.error;
        if (x < std::log(dk * kSize / 200.0)) continue;
        kept.push_back({x, std::log(ring.y / ring.error), ring.error});
    }
    return kept;
}

void spectrum_rows(Bench& bench) {
    for (const double beta : {1.2, 2.0, 2.8}) {
        SampleMean exponent;
        Plot plot{.title = "Spectrum of one land of exponent 2",
                  .x_label = "wavenumber [rad/m]",
                  .y_label = "density [m^4]",
                  .logarithmic = true};
        for (int seed = 1; seed <= kSeeds; ++seed) {
            Terrain land(fractal(beta, seed), {.threads = bench.request.threads});
            const Surface map = land.surface({Channel::height});
            const std::vector<Point> rings = rings_of(map.channel(Channel::height));
            exponent.add(-0.5 * slope_of(rings, [](const Point& ring) { return ring.error; }));
            if (seed > 1 || beta != 2.0) continue;
            for (const Point& ring : rings) {
                plot.measured.push_back({std::exp(ring.x), std::exp(ring.y)});
            }
            const Point middle = plot.measured[plot.measured.size() / 2];
            for (const Point& at : {plot.measured.front(), plot.measured.back()}) {
                plot.curve.push_back({at.x, middle.y * std::pow(at.x / middle.x, -2.0 * beta)});
            }
        }
        bench.add(
            {.id = "terrain.exponent_" + plain_text(beta),
             .claim = "Spectrum of land of exponent " + plain_text(beta),
             .reference = "S(kx, ky) ~ k^-2beta, H = beta - 1 [Mandelbrot 1983]",
             .method = "line through rings of the last two decades, mean of 4 seeds, N = 1024",
             .expected = beta,
             .measured = exponent.mean(),
             .tolerance = 0.01 * beta,
             .bound = "1 %",
             .plot = std::move(plot)});
    }
}

/// Variograms of land of H = 0.5 at lags of 4 to 32 cells against the sum over its waves.
void variogram_row(Bench& bench) {
    constexpr double kBeta = 1.5;
    constexpr std::array kLags = {4, 8, 16, 32};
    std::array<double, kLags.size()> sums{};
    double all = 0.0;
    for (int m = 1 - kSize / 2; m < kSize / 2; ++m) {
        for (int n = 1 - kSize / 2; n < kSize / 2; ++n) {
            if (n == 0 && m == 0) continue;
            const double energy = std::pow(n * n + m * m, -kBeta);
            all += energy;
            for (std::size_t i = 0; i < kLags.size(); ++i) {
                sums[i] += energy * (1.0 - std::cos(2.0 * kPi * n * kLags[i] / kSize));
            }
        }
    }
    std::array<SampleMean, kLags.size()> variograms;
    SampleMean exponent;
    for (int seed = 1; seed <= 2 * kSeeds; ++seed) {
        Terrain land(fractal(kBeta, seed), {.threads = bench.request.threads});
        const Surface map = land.surface({Channel::height});
        const std::span<const float> h = map.channel(Channel::height);
        std::vector<Point> line;
        for (std::size_t i = 0; i < kLags.size(); ++i) {
            const auto lag = static_cast<std::size_t>(kLags[i]);
            double sum = 0.0;
            for (std::size_t y = 0; y < kSize; ++y) {
                for (std::size_t x = 0; x < kSize; ++x) {
                    const auto here = static_cast<double>(h[y * kSize + x]);
                    sum +=
                        std::pow(here - static_cast<double>(h[y * kSize + (x + lag) % kSize]), 2) +
                        std::pow(here - static_cast<double>(h[(y + lag) % kSize * kSize + x]), 2);
                }
            }
            variograms[i].add(0.25 * sum / (kSize * kSize));
            line.push_back({std::log(kLags[i]), std::log(sum)});
        }
        exponent.add(0.5 * slope_of(line));
    }
    Plot plot{.title = "Variogram of land of H = 0.5",
              .x_label = "lag [m]",
              .y_label = "half the mean square difference [m^2]",
              .logarithmic = true};
    std::vector<Point> theory;
    for (std::size_t i = 0; i < kLags.size(); ++i) {
        const double lag = kLags[i] * kPatch / kSize, expected = 625.0 * sums[i] / all;
        theory.push_back({std::log(lag), std::log(expected)});
        plot.curve.push_back({lag, expected});
        plot.measured.push_back({lag, variograms[i].mean(), 2.0 * variograms[i].error()});
    }
    bench.add({.id = "terrain.variogram",
               .claim = "Variogram of land of H = 0.5",
               .reference = "[Mandelbrot 1983]: <(h(x+r) - h(x))^2> ~ r^2H; of a tile the sum of "
                            "k^-2beta (1 - cos k r), whose slope is expected",
               .method =
                   "half the slope of the log variogram from 4 to 32 cells, both axes, mean of "
                   "8 seeds, N = 1024",
               .expected = 0.5 * slope_of(theory),
               .measured = exponent.mean(),
               .tolerance = 3.0 * exponent.error(),
               .bound = "3 standard errors",
               .plot = std::move(plot)});
}

}  // namespace

void verify_terrain(Bench& bench) {
    spectrum_rows(bench);
    variogram_row(bench);
}

}  // namespace ocean::verify
