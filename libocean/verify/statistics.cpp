// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The energy of maps: over seeds, on any grid and patch, and how heights are distributed.
#include <array>
#include <string>

#include "bench.hpp"
#include "literature.hpp"
#include "map_statistics.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::verify {
namespace {

constexpr double kWind = 10.0, kFetch = 100e3;

struct GridCase {
    int resolution;
    double patch;
};

std::string grid_text(const GridCase& grid) {
    return "N = " + std::to_string(grid.resolution) + ", L = " + plain_text(grid.patch) + " m";
}

void variance_rows(Bench& bench) {
    for (const GridCase& grid : {GridCase{128, 400.0}, {256, 400.0}, {256, 800.0}, {512, 800.0}}) {
        bench.add(variance_row(bench, wind_sea(kWind, kFetch, grid.resolution, grid.patch), 64,
                               {.id = "statistics.variance_" + std::to_string(grid.resolution) +
                                      "_" + plain_text(grid.patch),
                                .claim = "Variance of maps on " + grid_text(grid)}));
    }
}

/// The share of JONSWAP's variance between the modes of a grid and its own integral.
void band_row(Bench& bench) {
    const Jonswap law{kWind, kFetch};
    const double m0 = law.moment([](double) { return 1.0; });
    double worst = 0.0;
    for (const double patch : {400.0, 800.0, 1600.0}) {
        for (const int resolution : {256, 512}) {
            Ocean sea(wind_sea(kWind, kFetch, resolution, patch), bench.options());
            const SeaState state = sea.state();
            if (state.energy_resolved < 0.99) continue;
            // The modes lie in a square of wavenumbers; a circle of its area has nearly its waves.
            const double k = 2.0 * kPi * (resolution - 1) / patch / std::sqrt(kPi);
            const double band =
                integral([&](double w) { return law.density(w); }, std::sqrt(kG * k), 20.0, 20000);
            const double modes = std::pow(state.significant_wave_height.resolved / 4.0, 2.0);
            const double off = modes / (m0 - band) - 1.0;
            if (std::abs(off) > std::abs(worst)) worst = off;
        }
    }
    bench.add({.id = "statistics.energy_of_modes",
               .claim = "Energy does not depend on samples and patch",
               .reference = "[Hasselmann 1973]: integral of S up to the grid's shortest waves",
               .method = "sum over the modes over that integral, the worst of N = 256, 512 and L = "
                         "400, 800, 1600 m with 99 % of the energy; U = 10 m/s, F = 100 km",
               .expected = 1.0,
               .measured = 1.0 + worst,
               .tolerance = 3e-3,
               .bound = "0.3 %"});
}

void swell_row(Bench& bench) {
    Parameters swell = wind_sea(kWind, kFetch, 256, 800.0);
    swell.waves.front().peak_enhancement = 10.0;
    swell.waves.front().peak_period = 13.0;
    swell.waves.front().swell = 1.0;
    double worst = 0.0;
    for (double patch = 800.0; patch < 1300.0; patch += 61.0) {
        swell.grid.patch_size = patch;
        const SeaState state = Ocean(swell, bench.options()).state();
        const double off =
            state.significant_wave_height.resolved / state.significant_wave_height.asked - 1.0;
        if (std::abs(off) > std::abs(worst)) worst = off;
    }
    bench.add({.id = "statistics.narrow_swell",
               .claim = "A swell narrower than the lattice keeps its height",
               .reference = "Hs of the modes is that of the spectrum",
               .method =
                   "waves of 13 s, gamma = 10, the worst of 9 patches from 800 to 1288 m, N = "
                   "256",
               .expected = 1.0,
               .measured = 1.0 + worst,
               .tolerance = 3e-3,
               .bound = "0.3 %"});
}

void shared_waves_row(Bench& bench) {
    Ocean coarse(wind_sea(kWind, kFetch, 128, 400.0), bench.options());
    Ocean fine(wind_sea(kWind, kFetch, 256, 400.0), bench.options());
    const Surface a = coarse.evaluate(12.0, {Channel::height});
    const Surface b = fine.evaluate(12.0, {Channel::height}, 128);
    bench.add({.id = "statistics.finer_grid",
               .claim = "A finer grid adds short waves and keeps the others",
               .reference = "a map of 128 samples is the same from N = 256 as from N = 128",
               .method = "rms of the difference over the rms of heights at t = 12 s, L = 400 m",
               .measured = relative_error(b.channel(Channel::height), a.channel(Channel::height)),
               .tolerance = 2e-6,
               .bound = "2e-6 of single precision"});
}

/// Skewness and kurtosis of heights, and how they are distributed.
void distribution_rows(Bench& bench) {
    constexpr int kSeeds = 64, kBins = 24;
    constexpr double kSpan = 4.0;  // standard deviations to each side
    Ocean sea(wind_sea(kWind, kFetch, 128, 400.0), bench.options());
    SampleMean skewness, kurtosis;
    std::array<SampleMean, kBins> shares;
    const double m0 = std::pow(sea.state().significant_wave_height.resolved / 4.0, 2.0);
    for (int seed = 1; seed <= kSeeds; ++seed) {
        sea.set("seed", std::to_string(seed));
        const Surface map = sea.evaluate(0.0, {Channel::height});
        const std::span<const float> heights = map.channel(Channel::height);
        double third = 0.0, fourth = 0.0;
        std::array<double, kBins> counts{};
        for (const float height : heights) {
            const double z = static_cast<double>(height) / std::sqrt(m0);
            third += z * z * z;
            fourth += z * z * z * z;
            const double bin = (z / kSpan + 1.0) * 0.5 * kBins;
            if (bin >= 0.0 && bin < kBins) counts[static_cast<std::size_t>(bin)] += 1.0;
        }
        const auto n = static_cast<double>(heights.size());
        skewness.add(third / n);
        kurtosis.add(fourth / n);
        const double width = 2.0 * kSpan / kBins;
        for (std::size_t i = 0; i < kBins; ++i) shares[i].add(counts[i] / n / width);
    }
    Plot plot{.title = "Heights of 64 seas beside the normal distribution",
              .x_label = "height over its standard deviation",
              .y_label = "density"};
    for (int i = 0; i < kBins; ++i) {
        const double z = kSpan * ((2.0 * i + 1.0) / kBins - 1.0);
        const SampleMean& share = shares[static_cast<std::size_t>(i)];
        plot.measured.push_back({z, share.mean(), 2.0 * share.error()});
    }
    for (double z = -kSpan; z <= kSpan; z += 0.1) {
        plot.curve.push_back({z, std::exp(-0.5 * z * z) / std::sqrt(2.0 * kPi)});
    }
    const std::string method = "mean of 64 seeds, N = 128, L = 400 m, by the variance of the modes";
    bench.add({.id = "statistics.skewness",
               .claim = "Heights of a linear sea have no skewness",
               .reference = "[Longuet-Higgins 1963b]: <h^3>/<h^2>^1.5 = 0 for linear waves",
               .method = method,
               .measured = skewness.mean(),
               .tolerance = 3.0 * skewness.error(),
               .bound = "3 standard errors",
               .plot = std::move(plot)});
    bench.add({.id = "statistics.kurtosis",
               .claim = "Heights of a linear sea are Gaussian",
               .reference = "<h^4>/<h^2>^2 = 3",
               .method = method,
               .expected = 3.0,
               .measured = kurtosis.mean(),
               .tolerance = 3.0 * kurtosis.error(),
               .bound = "3 standard errors"});
}

void mirror_row(Bench& bench) {
    Parameters parameters = wind_sea(kWind, kFetch, 128, 400.0);
    parameters.waves.front().spectrum = SpectrumKind::phillips;
    parameters.waves.front().spreading = SpreadingKind::cosine_squared;
    Ocean sea(parameters, bench.options());
    const Surface map = sea.evaluate(1.7, {Channel::height});
    const std::span<const float> h = map.channel(Channel::height);
    double sum = 0.0;
    for (std::size_t j = 0; j < 128; ++j) {
        for (std::size_t i = 0; i < 128; ++i) {
            sum += static_cast<double>(h[j * 128 + i]) *
                   static_cast<double>(h[(128 - j) % 128 * 128 + (128 - i) % 128]);
        }
    }
    bench.add({.id = "statistics.no_mirror",
               .claim = "The sea is no mirror image of itself",
               .reference = "correlation of h(x) and h(-x) is 0 for independent waves",
               .method = "one map of Phillips' spectrum at t = 1.7 s, N = 128, L = 400 m",
               .measured = sum / static_cast<double>(h.size()) / variance_of(h),
               .tolerance = 0.15,
               .bound = "0.15, the scatter of the few waves that hold the energy"});
}

}  // namespace

Row variance_row(Bench& bench, const Parameters& parameters, int seeds, Row row) {
    Ocean sea(parameters, bench.options());
    const double height = sea.state().significant_wave_height.resolved;
    SampleMean variance;
    for (int seed = 1; seed <= seeds; ++seed) {
        sea.set("seed", std::to_string(seed));
        const Surface map = sea.evaluate(0.0, {Channel::height}, parameters.grid.resolution);
        variance.add(variance_of(map.channel(Channel::height)));
    }
    row.reference = "<h^2> = m0, the sum of S D c_g/k dkx dky over the modes [Horvath 2015]";
    row.method = "mean variance of " + std::to_string(seeds) + " maps, a seed each";
    row.unit = "m^2";
    row.expected = height * height / 16.0;
    row.measured = variance.mean();
    row.tolerance = 3.0 * variance.error();
    row.bound = "3 standard errors";
    return row;
}

void verify_statistics(Bench& bench) {
    variance_rows(bench);
    band_row(bench);
    swell_row(bench);
    shared_waves_row(bench);
    distribution_rows(bench);
    mirror_row(bench);
}

}  // namespace ocean::verify
