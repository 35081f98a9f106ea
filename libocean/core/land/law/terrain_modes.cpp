// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From law and noise to the modes of a terrain; see terrain_modes.hpp.
#include "ocean/internal/terrain_modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/noise_row.hpp"
#include "base/noise_streams.hpp"
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

std::vector<NoiseSource> noise_sources(const TerrainModel& terrain) {
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

TerrainNoise::TerrainNoise(const TerrainModel& terrain, ThreadPool& pool)
    : resolution_(terrain.resolution),
      wavenumber_step_(lattice_of(terrain).wavenumber_step()),
      values_(lattice_of(terrain).size() / 2) {
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
            if (m <= 0) row[0] = {};  // no mean; for n = 0 half of the waves are mirrors
        }
    });
    add_moments();
}

void TerrainNoise::add_moments() {
    const double dk = wavenumber_step_;
    first_cell_ = WavenumberCells::place_of(dk * dk).cell;
    const auto last = WavenumberCells::place_of(dk * dk * resolution_ * resolution_).cell;
    moments_.resize(static_cast<std::size_t>(last - first_cell_ + 1));
    const int half = resolution_ / 2;
    for (int m = 1 - half; m < half; ++m) {
        const std::span g = row(m);
        const double ky = m * dk;
        for (std::size_t n = m <= 0 ? 1 : 0; n < g.size(); ++n) {
            const double kx = static_cast<double>(n) * dk;
            const auto [cell, part] = WavenumberCells::place_of(kx * kx + ky * ky);
            const double re = g[n].real(), im = g[n].imag();
            const double square = re * re + im * im;
            auto& sums = moments_[static_cast<std::size_t>(cell - first_cell_)].sums;
            sums[0] += square;
            sums[1] += square * part;
            sums[2] += square * part * part;
        }
    }
}

double TerrainNoise::energy(const TerrainAmplitudes& amplitude, ThreadPool& pool) const {
    if (!amplitude.turns() && !amplitude.has_limits()) {
        double sum = 0.0;
        for (std::size_t i = 0; i < moments_.size(); ++i) {
            const auto& [sums] = moments_[i];
            if (sums[0] == 0.0) continue;
            const std::int64_t cell = first_cell_ + static_cast<std::int64_t>(i);
            const double begin = amplitude.at_cell(cell);
            const double rise = amplitude.at_cell(cell + 1) - begin;
            sum += begin * begin * sums[0] + 2.0 * begin * rise * sums[1] + rise * rise * sums[2];
        }
        return sum;
    }
    const double dk = wavenumber_step_;
    std::vector<double> rows(static_cast<std::size_t>(resolution_));
    pool.for_each_range(resolution_, [&](int first, int last) {
        std::vector<double> a(static_cast<std::size_t>(resolution_ / 2));
        for (int index = first; index < last; ++index) {
            const int m = signed_wavenumber(index, resolution_);
            if (m == -resolution_ / 2) continue;
            const std::span g = row(m);
            amplitude.row(dk, m * dk, a);
            double sum = 0.0;
            for (std::size_t n = 0; n < g.size(); ++n) {
                const double re = g[n].real(), im = g[n].imag();
                sum += a[n] * a[n] * (re * re + im * im);
            }
            rows[static_cast<std::size_t>(index)] = sum;
        }
    });
    double sum = 0.0;
    for (const double row : rows) sum += row;
    return sum;
}

std::span<const std::complex<float>> TerrainNoise::row(int m) const {
    const auto half = static_cast<std::size_t>(resolution_ / 2);
    return {values_.data() + static_cast<std::size_t>(fft_index(m, resolution_)) * half, half};
}

Lattice lattice_of(const TerrainModel& terrain) {
    return {terrain.resolution, terrain.patch_size};
}

Modes empty_terrain_modes(const TerrainModel& terrain) {
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

/// Writes h0 of the rows m and -m: h(n, m), and its mirror h(-n, -m) = conj h(n, m).
class RowWriter {
  public:
    RowWriter(const TerrainNoise& noise, const TerrainAmplitudes& amplitude, double factor,
              double dk, std::complex<float>* h0)
        : noise_(noise),
          amplitude_(amplitude),
          factor_(factor),
          dk_(dk),
          h0_(h0),
          a_(static_cast<std::size_t>(noise.resolution() / 2)) {}

    /// Writes both rows of a wave index m >= 0.
    void write(int m) {
        amplitudes(m);
        write_one(m);
        if (m == 0) return;
        if (amplitude_.turns()) amplitudes(-m);
        write_one(-m);
    }

  private:
    void amplitudes(int m) {
        amplitude_.row(dk_, m * dk_, a_);
        for (double& a : a_) a *= factor_;
    }

    void write_one(int m) const {
        const int size = noise_.resolution();
        const std::span g = noise_.row(m);
        std::complex<float>* const right = h0_ + mode_index(0, m, size);
        std::complex<float>* const mirror = h0_ + mode_index(0, -m, size) + size;
        for (std::size_t n = 1; n < g.size(); ++n) {
            const auto re = static_cast<float>(a_[n] * static_cast<double>(g[n].real()));
            const auto im = static_cast<float>(a_[n] * static_cast<double>(g[n].imag()));
            right[n] = {re, im};
            mirror[-static_cast<std::ptrdiff_t>(n)] = {re, -im};
        }
        if (m <= 0) return;
        const std::complex<float> h = {static_cast<float>(a_[0] * g[0].real()),
                                       static_cast<float>(a_[0] * g[0].imag())};
        right[0] = h;
        h0_[mode_index(0, -m, size)] = std::conj(h);
    }

    const TerrainNoise& noise_;
    const TerrainAmplitudes& amplitude_;
    double factor_;
    double dk_;
    std::complex<float>* h0_;
    std::vector<double> a_;
};

}  // namespace

TerrainScale set_terrain_modes(const TerrainModel& terrain, const TerrainNoise& noise,
                               std::optional<double> rms, ThreadPool& pool, Modes& modes,
                               LawPart part) {
    const int size = noise.resolution();
    const double dk = kTwoPi / terrain.patch_size;
    const TerrainAmplitudes whole(TerrainLaw(terrain), dk, dk * size);
    // |h|^2 = S / 2 |g|^2 dk^2, and each mode has a mirror image.
    const double own_rms = dk * std::sqrt(noise.energy(whole, pool));
    std::optional<TerrainAmplitudes> of_part;
    if (part != LawPart::whole) of_part.emplace(TerrainLaw(terrain, part), dk, dk * size);
    const TerrainAmplitudes& amplitude = of_part ? *of_part : whole;
    TerrainScale scale{1.0, own_rms};
    if (rms) scale = {own_rms > 0.0 ? *rms / own_rms : 0.0, own_rms > 0.0 ? *rms : 0.0};

    constexpr double kRootHalf = 0.70710678118654752;
    const double factor = 0.5 * kRootHalf * dk * scale.gain;
    std::complex<float>* const h0 = modes.cascades.front().h0.data();
    pool.for_each_range(size / 2, [&](int first, int last) {
        RowWriter writer(noise, amplitude, factor, dk, h0);
        for (int m = first; m < last; ++m) writer.write(m);
    });
    modes.revision = Revision::begin();
    return scale;
}

}  // namespace ocean
