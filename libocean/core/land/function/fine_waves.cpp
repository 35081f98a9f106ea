// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tiles of fine waves and their hashed readings; see fine_waves.hpp.
#include "land/function/fine_waves.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <utility>

#include "land/function/place_hash.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/terrain_modes.hpp"
#include "ocean/surface.hpp"
#include "wave/wave.hpp"

namespace ocean {
namespace {

constexpr double kWavesOfTile = 8.0;     // longest waves along a side of a tile
constexpr double kSamplesOfWave = 4.0;   // of the shortest wave
constexpr double kWavesOfSpacing = 3.0;  // longest waves between readings
constexpr double kReach = 0.85;          // of a reading, in spacings
constexpr int kRingsPerOctave = 3;

/// The waves that one tile holds.
struct Band {
    double longest, shortest;  // [m]

    double period() const { return kWavesOfTile * longest; }
    int resolution() const {
        const auto samples =
            static_cast<unsigned>(std::ceil(kSamplesOfWave * period() / shortest * (1.0 - 1e-9)));
        return std::max(kMinResolution, static_cast<int>(std::bit_ceil(samples)));
    }
};

/// Returns bands of equal ratio, at most FineWaves::kMaxRatio each.
std::vector<Band> bands_of(double longest, double shortest) {
    const double octaves = std::log2(longest / shortest);
    const int count =
        std::max(1, static_cast<int>(std::ceil(octaves / std::log2(FineWaves::kMaxRatio) - 1e-9)));
    std::vector<Band> bands;
    for (int i = 0; i < count; ++i) {
        bands.push_back({longest * std::exp2(-octaves * i / count),
                         longest * std::exp2(-octaves * (i + 1) / count)});
    }
    return bands;
}

/// The rings of a band: thirds of octaves between its limits.
class Rings {
  public:
    explicit Rings(const Band& band)
        : low_(kTwoPi / band.longest),
          high_(kTwoPi / band.shortest),
          count_(std::max(1, static_cast<int>(std::lround(
                                 kRingsPerOctave * std::log2(band.longest / band.shortest))))) {}

    std::size_t count() const { return static_cast<std::size_t>(count_); }
    double edge(std::size_t ring) const {
        return low_ * std::pow(high_ / low_, static_cast<double>(ring) / count_);
    }
    /// Returns the ring of k, or count() if k is beyond the band.
    std::size_t of(double k) const {
        if (!(k >= low_ && k < high_)) return count();
        const double at = count_ * std::log(k / low_) / std::log(high_ / low_);
        return std::min(static_cast<std::size_t>(at), count() - 1);
    }

  private:
    double low_, high_;
    int count_;
};

/// Calls wave(n, m, g) for each wave of the half plane.
template <typename Wave>
void for_each_wave(const TerrainNoise& noise, const Wave& wave) {
    const int half = noise.resolution() / 2;
    for (int m = 1 - half; m < half; ++m) {
        const auto row = noise.row(m);
        for (int n = m <= 0 ? 1 : 0; n < half; ++n) wave(n, m, row[static_cast<std::size_t>(n)]);
    }
}

/// Returns the heights of a tile with the energy of the density in each ring.
std::vector<float> tile_heights(const RadialDensity& density, const Band& band, std::uint32_t seed,
                                ThreadPool& pool) {
    TerrainModel square;
    square.resolution = band.resolution();
    square.patch_size = band.period();
    square.seed = seed;
    const TerrainNoise noise(square, pool);
    const double dk = kTwoPi / square.patch_size;
    const Rings rings(band);
    std::vector<double> energy(rings.count() + 1);
    for_each_wave(noise, [&](int n, int m, std::complex<float> g) {
        const double k = dk * std::hypot(n, m);
        energy[rings.of(k)] += 2.0 * density(k) * static_cast<double>(std::norm(g));
    });
    std::vector<double> gain(rings.count() + 1);
    for (std::size_t r = 0; r < rings.count(); ++r) {
        const double wanted = ring_variance(density, rings.edge(r), rings.edge(r + 1));
        gain[r] = energy[r] > 0.0 ? std::sqrt(wanted / energy[r]) : 0.0;
    }
    // The height is the sum of h exp(i k x) over all waves, and h0 = h / 2; see terrain_modes.hpp.
    Modes modes = empty_terrain_modes(square);
    auto& h0 = modes.cascades.front().h0;
    for_each_wave(noise, [&](int n, int m, std::complex<float> g) {
        const double k = dk * std::hypot(n, m);
        const auto half = static_cast<float>(0.5 * gain[rings.of(k)] * std::sqrt(density(k)));
        h0[mode_index(n, m, square.resolution)] = half * g;
        h0[mode_index(-n, -m, square.resolution)] = half * std::conj(g);
    });
    SurfaceSettings flat;
    flat.choppiness = 0.0;
    const Surface map = make_surface(modes, flat, 0.0, {Channel::height}, Backend::cpu, pool);
    const auto heights = map.channel(Channel::height);
    return {heights.begin(), heights.end()};
}

}  // namespace

double ring_variance(const RadialDensity& density, double k0, double k1) {
    constexpr int kSteps = 64;
    const double step = std::log(k1 / k0) / kSteps;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double k = k0 * std::exp(step * (i + 0.5));
        sum += density(k) * k * k;
    }
    return kTwoPi * step * sum;
}

RadialDensity tabulated(const RadialDensity& density, double k0, double k1) {
    constexpr int kPerOctave = 64;
    std::vector<double> table;
    const int last = static_cast<int>(std::ceil(kPerOctave * std::log2(k1 / k0))) + 1;
    for (int i = 0; i <= last; ++i) {
        table.push_back(density(k0 * std::exp2(static_cast<double>(i) / kPerOctave)));
    }
    return [table = std::move(table), k0](double k) {
        const double at = kPerOctave * std::log2(k / k0);
        if (!(at >= 0.0) || at >= static_cast<double>(table.size() - 1)) return 0.0;
        const auto i = static_cast<std::size_t>(at);
        return table[i] + (at - static_cast<double>(i)) * (table[i + 1] - table[i]);
    };
}

FineWaves::FineWaves(const RadialDensity& density, double longest, double shortest,
                     std::uint32_t seed, ThreadPool& pool) {
    for (const Band& band : bands_of(longest, shortest)) {
        const auto number = static_cast<std::uint32_t>(tiles_.size());
        const std::uint32_t own_seed = place_hash(number, 0x66696E65u, seed);
        tiles_.push_back({SplinePyramid(Domain::tile(band.period(), band.resolution()),
                                        tile_heights(density, band, own_seed, pool), pool, 1),
                          band.period(), kWavesOfSpacing * band.longest, band.longest, own_seed});
        const Rings rings(band);
        for (std::size_t r = 0; r < rings.count(); ++r) {
            variance_ += ring_variance(density, rings.edge(r), rings.edge(r + 1));
        }
    }
}

GroundJet FineWaves::read(const Tile& tile, double x, double y, double cell) {
    const SplineGrid& samples = tile.samples.level(cell);
    const double a = tile.spacing;
    const double row_height = 0.86602540378443865 * a;
    const double reach_square = kReach * kReach * a * a;
    const auto first_row = static_cast<std::int64_t>(std::floor(y / row_height)) - 1;
    GroundJet sum;
    double squares = 0.0, squares_x = 0.0, squares_y = 0.0;
    for (std::int64_t j = first_row; j < first_row + 4; ++j) {
        const double ry = y - static_cast<double>(j) * row_height;
        if (ry * ry >= reach_square) continue;
        const double shift = (j & 1) != 0 ? 0.5 * a : 0.0;
        const auto first = static_cast<std::int64_t>(std::floor((x - shift) / a)) - 1;
        for (std::int64_t i = first; i < first + 4; ++i) {
            const double rx = x - shift - static_cast<double>(i) * a;
            const double square = rx * rx + ry * ry;
            if (square >= reach_square) continue;
            const double q = 1.0 - square / reach_square;
            const double w = q * q * q, dw = -6.0 * q * q / reach_square;  // times rx, ry
            const auto column = static_cast<std::uint32_t>(i), row = static_cast<std::uint32_t>(j);
            const std::uint32_t turns = place_hash(column, row, tile.seed);
            const std::uint32_t shifts = place_hash(column, row, ~tile.seed);
            const double unit = tile.period / 65536.0;
            const auto [sine, cosine] =
                wave::double_precision::sin_cos_turns((turns & 0xFFFFu) / 65536.0);
            const double sign = (turns >> 31) != 0 ? 1.0 : -1.0;
            const GroundJet jet = samples.at(rx * cosine + ry * sine + unit * (shifts & 0xFFFFu),
                                             ry * cosine - rx * sine + unit * (shifts >> 16));
            const double z = sign * jet.height;
            sum.height += w * z;
            sum.slope_x += w * sign * (jet.slope_x * cosine - jet.slope_y * sine) + dw * rx * z;
            sum.slope_y += w * sign * (jet.slope_x * sine + jet.slope_y * cosine) + dw * ry * z;
            squares += w * w;
            squares_x += w * dw * rx;
            squares_y += w * dw * ry;
        }
    }
    const double scale = 1.0 / std::sqrt(squares);
    const double fall = sum.height * scale / squares;
    return {sum.height * scale, sum.slope_x * scale - fall * squares_x,
            sum.slope_y * scale - fall * squares_y};
}

GroundJet FineWaves::at(double x, double y, double cell) const {
    GroundJet sum;
    for (const Tile& tile : tiles_) {
        if (tile.longest <= 2.0 * cell) break;
        const GroundJet jet = read(tile, x, y, cell);
        sum.height += jet.height;
        sum.slope_x += jet.slope_x;
        sum.slope_y += jet.slope_y;
    }
    return sum;
}

std::uint64_t FineWaves::bytes(double longest, double shortest) {
    std::uint64_t sum = 0;
    for (const Band& band : bands_of(longest, shortest)) {
        sum += SplinePyramid::bytes(Domain::tile(band.period(), band.resolution()));
    }
    return sum;
}

}  // namespace ocean
