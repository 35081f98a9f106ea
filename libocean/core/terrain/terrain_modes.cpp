// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From law and noise to the modes of a terrain; see terrain_modes.hpp.
#include "ocean/terrain_modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "modes/noise_row.hpp"
#include "modes/noise_streams.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

/// The noise that one tile or layer adds.
struct NoiseSource {
    std::uint32_t seed;
    std::uint32_t stream;
    int divisor;  // patch_size / period
    double gain;
};

std::vector<NoiseSource> noise_sources(const Terrain& terrain) {
    std::vector<NoiseSource> sources = {{terrain.seed, noise_stream(NoiseStream::terrain), 1, 1.0}};
    for (const TerrainLayer& layer : terrain.layers) {
        sources.push_back({layer.seed, noise_stream(NoiseStream::terrain, 1),
                           static_cast<int>(std::lround(terrain.patch_size / layer.period)),
                           layer.gain});
    }
    return sources;
}

/// Adds the noise of a source to the row g(0 .. half - 1, m).
void add_noise(const NoiseSource& source, int m, std::span<std::complex<float>> row,
               std::vector<std::complex<float>>& drawn) {
    if (m % source.divisor != 0) return;
    const std::size_t step = static_cast<std::size_t>(source.divisor);
    drawn.resize((row.size() - 1) / step + 1);
    noise_row(source.seed, source.stream, 0, m / source.divisor, drawn);
    const auto factor = static_cast<float>(source.divisor * source.gain);
    for (std::size_t i = 0; i < drawn.size(); ++i) row[i * step] += factor * drawn[i];
}

}  // namespace

TerrainNoise::TerrainNoise(const Terrain& terrain, ThreadPool& pool)
    : resolution_(terrain.resolution), values_(lattice_of(terrain).size() / 2) {
    const std::vector<NoiseSource> sources = noise_sources(terrain);
    const int half = resolution_ / 2;
    pool.for_each_range(resolution_, [&](int first, int last) {
        std::vector<std::complex<float>> drawn;
        for (int index = first; index < last; ++index) {
            const int m = signed_wavenumber(index, resolution_);
            const std::span row(values_.data() + static_cast<std::ptrdiff_t>(index) * half,
                                static_cast<std::size_t>(half));
            std::ranges::fill(row, std::complex<float>());
            if (m == -half) continue;
            for (const NoiseSource& source : sources) add_noise(source, m, row, drawn);
            if (m <= 0) row[0] = {};  // the mean, and the mirrored half of n = 0
        }
    });
}

std::span<const std::complex<float>> TerrainNoise::row(int m) const {
    const auto half = static_cast<std::size_t>(resolution_ / 2);
    return {values_.data() + static_cast<std::size_t>(fft_index(m, resolution_)) * half, half};
}

Lattice lattice_of(const Terrain& terrain) {
    return {terrain.resolution, terrain.patch_size};
}

Modes empty_terrain_modes(const Terrain& terrain) {
    const Lattice lattice = lattice_of(terrain);
    Modes modes{lattice, 0.0, 0.0, {}, {}, Revision::begin()};
    CascadeModes& tile = modes.cascades.emplace_back();
    tile.lattice = lattice;
    tile.h0.assign(lattice.size(), {});
    tile.rate_high.assign(lattice.size(), 0.0f);
    tile.rate_low.assign(lattice.size(), 0.0f);
    tile.displacement.assign(lattice.size(), 0.0f);
    tile.shell_covariance.resize(static_cast<std::size_t>(lattice.resolution / 2));
    return modes;
}

namespace {

/// Returns sum |h(k)|^2 over both half planes for gain 1 [m^2], row by row in double, so that it
/// does not depend on the number of threads.
double energy(const TerrainNoise& noise, const TerrainAmplitudes& amplitude, double dk,
              ThreadPool& pool) {
    const int size = noise.resolution();
    std::vector<double> rows(static_cast<std::size_t>(size));
    pool.for_each_range(size, [&](int first, int last) {
        for (int index = first; index < last; ++index) {
            const int m = signed_wavenumber(index, size);
            const std::span g = noise.row(m);
            double sum = 0.0;
            for (std::size_t n = 0; n < g.size(); ++n) {
                const double a = amplitude(static_cast<double>(n) * dk, m * dk);
                const double re = g[n].real(), im = g[n].imag();
                sum += a * a * (re * re + im * im);
            }
            rows[static_cast<std::size_t>(index)] = sum;
        }
    });
    double sum = 0.0;
    for (const double row : rows) sum += row;
    // |h|^2 = S / 2 |g|^2 dk^2, and each mode has a mirror.
    return sum * dk * dk;
}

}  // namespace

TerrainScale set_terrain_modes(const Terrain& terrain, const TerrainNoise& noise,
                               std::optional<double> rms, ThreadPool& pool, Modes& modes) {
    const int size = noise.resolution();
    const double dk = kTwoPi / terrain.patch_size;
    const TerrainLaw law(terrain);
    const TerrainAmplitudes amplitude(law, dk, dk * size);
    const double own_rms = std::sqrt(energy(noise, amplitude, dk, pool));
    TerrainScale scale{1.0, own_rms};
    if (rms) scale = {own_rms > 0.0 ? *rms / own_rms : 0.0, own_rms > 0.0 ? *rms : 0.0};

    constexpr double kRootHalf = 0.70710678118654752;
    const double factor = 0.5 * kRootHalf * dk * scale.gain;
    PageVector<std::complex<float>>& h0 = modes.cascades.front().h0;
    pool.for_each_range(size, [&](int first, int last) {
        for (int index = first; index < last; ++index) {
            const int m = signed_wavenumber(index, size);
            const std::span g = noise.row(m);
            std::complex<float>* const right = &h0[mode_index(0, m, size)];
            std::complex<float>* const mirror = &h0[mode_index(0, -m, size)];
            for (std::size_t n = 0; n < g.size(); ++n) {
                const double a = factor * amplitude(static_cast<double>(n) * dk, m * dk);
                const std::complex<float> h = {static_cast<float>(a * g[n].real()),
                                               static_cast<float>(a * g[n].imag())};
                if (n > 0) {
                    right[n] = h;
                    mirror[static_cast<std::size_t>(size) - n] = std::conj(h);
                } else if (m > 0) {
                    right[0] = h;
                    mirror[0] = std::conj(h);
                }
            }
        }
    });
    modes.revision = Revision::begin();
    return scale;
}

}  // namespace ocean
