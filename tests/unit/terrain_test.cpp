// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Terrains by numbers: what the file asks for is what the tile holds.
#include "ocean/terrain.hpp"

#include "base/noise_streams.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "ocean/internal/terrain_law.hpp"
#include "ocean/internal/terrain_modes.hpp"
#include "ocean/internal/terrain_stages.hpp"
#include "ocean/terrain_table.hpp"
#include "test_seas.hpp"
#include "wave/wave.hpp"

namespace ocean {
namespace {

TerrainModel tile(int resolution, double beta = 2.0) {
    TerrainModel terrain;
    terrain.resolution = resolution;
    terrain.patch_size = 2000.0;
    terrain.beta = beta;
    terrain.rms = 25.0;
    return terrain;
}

/// Returns the rms difference of two maps over the rms of the land.
double error_of(std::span<const float> a, std::span<const float> b) {
    return test::rms(test::difference(a, b)) / 25.0;
}

std::vector<float> heights(Terrain& land, int resolution = 0) {
    return test::values_of(land.surface({Channel::height}, resolution));
}

// ---- The estimator: periodogram of a whole period, rings four to an octave inside the inscribed
// circle, mean of log k, weight by the number of waves.

struct RingMean {
    double log_k = 0.0, density = 0.0, count = 0.0;
};

/// Returns the rings of two maps, by one transform: a + i b, whose even and odd parts are those of
/// a and of b.
std::array<std::vector<RingMean>, 2> rings_of(std::span<const float> a, std::span<const float> b,
                                              int size, double period) {
    std::vector<std::complex<float>> values(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) values[i] = {a[i], b[i]};
    Radix2Fft<float>(size).transform_2d(values, FftDirection::forward);
    std::array<std::vector<RingMean>, 2> rings;
    for (auto& list : rings) list.resize(static_cast<std::size_t>(4 * std::log2(size)));
    const double dk = kTwoPi / period;
    const double density = 1.0 / (std::pow(static_cast<double>(size), 4.0) * dk * dk);
    for (const auto [n, m] : test::pairs({1 - size / 2, size / 2}, {0, size / 2})) {
        const double index = std::hypot(n, m);
        if (index < 1.0 || index > size / 2 - 1) continue;
        const std::complex<double> here = values[mode_index(n, m, size)];
        const std::complex<double> there = std::conj(values[mode_index(-n, -m, size)]);
        const auto at = static_cast<std::size_t>(4.0 * std::log2(index) + 1e-9);
        for (std::size_t map = 0; map < 2; ++map) {
            const double energy = 0.25 * std::norm(map == 0 ? here + there : here - there);
            rings[map][at].log_k += std::log(index * dk);
            rings[map][at].density += energy * density;
            rings[map][at].count += 1.0;
        }
    }
    for (auto& list : rings) {
        std::erase_if(list, [](const RingMean& ring) { return ring.count == 0.0; });
        for (RingMean& ring : list) {
            ring.log_k /= ring.count;
            ring.density /= ring.count;
        }
    }
    return rings;
}

/// Returns beta of the rings with wavenumbers of the last two decades.
double exponent_of(const std::vector<RingMean>& rings, double lowest, double highest) {
    test::LineFit line;
    for (const RingMean& ring : rings) {
        if (ring.log_k < std::log(lowest) || ring.log_k > std::log(highest)) continue;
        line.add(ring.log_k, std::log(ring.density), ring.count);
    }
    return -0.5 * line.slope();
}

TEST(Terrain, ItsExponentIsWhatWasAskedForOverTwoDecades) {
    constexpr int size = 1024;
    const double kBetas[] = {1.2, 2.0, 2.4, 2.8};
    const double top = kTwoPi / 2000.0 * (size / 2);
    std::vector<double> sums(4), worst(4);
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        TerrainModel terrain = tile(size);
        terrain.seed = seed;
        Terrain land(terrain);
        const auto map = [&](double beta) {
            land.set("beta", std::to_string(beta));
            return heights(land);
        };
        for (std::size_t pair = 0; pair < 4; pair += 2) {
            const auto first = map(kBetas[pair]), second = map(kBetas[pair + 1]);
            const auto rings = rings_of(first, second, size, 2000.0);
            for (std::size_t i = 0; i < 2; ++i) {
                const double found = exponent_of(rings[i], top / 100.0, top) / kBetas[pair + i];
                sums[pair + i] += found / 4.0;
                worst[pair + i] = std::max(worst[pair + i], std::abs(found - 1.0));
            }
        }
        EXPECT_EQ(land.runs().noise, 1);
    }
    for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_NEAR(sums[b], 1.0, 0.01) << kBetas[b];
        EXPECT_LT(worst[b], 0.02) << kBetas[b];
    }
}

TEST(Terrain, ABrokenLawHasBothExponentsAndItsBreak) {
    TerrainModel terrain = tile(1024, 1.1);
    terrain.patch_size = 10000.0;
    terrain.breaks = {{300.0, 2.7}};
    double low = 0.0, high = 0.0, crossing = 0.0;
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        terrain.seed = seed;
        Terrain land(terrain);
        const auto map = heights(land);
        const auto rings = rings_of(map, map, 1024, 10000.0)[0];
        const double kb = kTwoPi / 300.0;
        // An octave and a half away from the break the law is a power.
        low += exponent_of(rings, 0.0, kb / 2.8) / 4.0;
        high += exponent_of(rings, 2.8 * kb, 1e9) / 4.0;
        // The two lines through the rings meet at the break: the exact law's lines meet at kb.
        const auto line = [&](double from, double to, double beta) {
            double sum = 0.0, weight = 0.0;
            for (const RingMean& ring : rings) {
                if (ring.log_k < std::log(from) || ring.log_k > std::log(to)) continue;
                sum += ring.count * (std::log(ring.density) + 2.0 * beta * ring.log_k);
                weight += ring.count;
            }
            return sum / weight;
        };
        const double a = line(1e-9, kb / 2.8, 1.1), b = line(2.8 * kb, 1e9, 2.7);
        crossing += std::exp((b - a) / (2.0 * (2.7 - 1.1))) / kb / 4.0;
    }
    EXPECT_NEAR(low / 1.1, 1.0, 0.03);
    EXPECT_NEAR(high / 2.7, 1.0, 0.03);
    EXPECT_NEAR(crossing, 1.0, 0.05);
}

// ---- rms by Parseval

TEST(Terrain, TheModesHaveTheRmsThatWasAskedFor) {
    for (const int size : {256, 512, 1024, 2048, 4096}) {
        const TerrainModel terrain = tile(size, 1.7);
        const TerrainNoise noise(terrain, test::pool());
        Modes modes = empty_terrain_modes(terrain);
        const TerrainScale scale = set_terrain_modes(terrain, noise, 25.0, test::pool(), modes);
        EXPECT_EQ(scale.rms, 25.0);
        // The same sum from the public law and noise, in another order.
        const double dk = kTwoPi / terrain.patch_size;
        const TerrainAmplitudes amplitude(TerrainLaw(terrain), dk, size * dk);
        double sum = 0.0;
        for (int m = size / 2 - 1; m > -size / 2; --m) {
            const auto row = noise.row(m);
            for (std::size_t n = row.size(); n-- > 0;) {
                const double h = scale.gain * dk * amplitude(static_cast<double>(n) * dk, m * dk);
                sum += h * h * std::norm(std::complex<double>(row[n]));
            }
        }
        EXPECT_NEAR(std::sqrt(sum) / 25.0, 1.0, 1e-9) << size;
    }
}

TEST(Terrain, MapsHaveTheRmsTheMeanAndTheRange) {
    TerrainModel terrain = tile(512);
    Terrain land(terrain);
    EXPECT_NEAR(test::rms(heights(land)) / 25.0, 1.0, 1e-6);
    land.set("mean", "300");
    const std::vector<float> raised = heights(land);
    EXPECT_NEAR(std::accumulate(raised.begin(), raised.end(), 0.0) / (512.0 * 512.0), 300.0, 1e-3);
    EXPECT_EQ(land.runs().filter, 1);  // the mean costs no filter
    terrain.rms.reset();
    terrain.range = {-20.0, 180.0};
    land.set_model(terrain);
    const auto fitted = heights(land);
    const auto [low, high] = std::ranges::minmax(fitted);
    EXPECT_NEAR(low, -20.0, 1e-4);
    EXPECT_NEAR(high, 180.0, 1e-4);
    terrain.range.clear();
    land.set_model(terrain);
    EXPECT_NEAR(test::rms(heights(land)) / kDefaultTerrainRms, 1.0, 1e-6);
}

TEST(Terrain, MeasuredRingsKeepTheirOwnRms) {
    TerrainModel terrain = tile(256);
    terrain.rms.reset();
    MeasuredRings rings;
    for (int i = 0; i < 24; ++i) {
        rings.wavenumber.push_back(0.003 * std::pow(2.0, 0.25 * i));
        rings.density.push_back(std::pow(rings.wavenumber.back(), -3.2));
    }
    terrain.rings = std::make_shared<const MeasuredRings>(rings);
    terrain.longest_wavelength = 500.0;
    double mean_square = 0.0, asked = 0.0;
    constexpr int kSeeds = 24;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        terrain.seed = seed;
        Terrain land(terrain);
        const double found = test::rms(heights(land));
        EXPECT_NEAR(found / land.scale().rms, 1.0, 1e-6);
        mean_square += found * found / kSeeds;
        asked = land.state().rms.asked;
    }
    EXPECT_NEAR(std::sqrt(mean_square) / asked, 1.0, 0.02);
}

// ---- One noise for every grid

TEST(Terrain, AFinerGridKeepsTheNoiseOfSharedWavesBitForBit) {
    TerrainModel terrain = tile(256);
    terrain.layers = {{500.0, 0.5, 9}};
    const TerrainNoise coarse(terrain, test::pool());
    terrain.resolution = 1024;
    const TerrainNoise fine(terrain, test::pool());
    for (int m = -127; m < 128; ++m) {
        const auto a = coarse.row(m), b = fine.row(m);
        ASSERT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0) << m;
    }
}

TEST(Terrain, TheNoiseIsThatOfTheFormula) {
    const TerrainModel terrain = tile(64);
    const TerrainNoise noise(terrain, test::pool());
    for (const auto& [n, m] : {std::pair{1, 0}, {0, 5}, {7, -3}, {31, 31}, {20, -31}}) {
        const auto xi =
            wave::double_precision::gaussian_noise(1, noise_stream(NoiseStream::terrain), n, m);
        const std::complex<float> g = noise.row(m)[static_cast<std::size_t>(n)];
        EXPECT_EQ(g.real(), static_cast<float>(xi.re));
        EXPECT_EQ(g.imag(), static_cast<float>(xi.im));
    }
    EXPECT_EQ(noise.row(0)[0], 0.0f);
    EXPECT_EQ(noise.row(-4)[0], 0.0f);
    EXPECT_EQ(noise.row(-32)[3], 0.0f);
}

TEST(Terrain, WithAShortestWaveEveryGridHasTheSameHeights) {
    TerrainModel terrain = tile(256);
    terrain.shortest_wavelength = 20.0;
    Terrain coarse(terrain);
    const auto few = heights(coarse);
    terrain.resolution = 1024;
    Terrain fine(terrain);
    const auto many = heights(fine);
    std::vector<float> shared;
    for (const auto [i, j] : test::pairs<std::size_t>(256, 256)) {
        shared.push_back(many[j * 4 * 1024 + i * 4]);
    }
    EXPECT_LT(error_of(few, shared), 2e-6);
}

TEST(Terrain, AnyNumberOfThreadsAndAnyBackendGiveTheSameHeights) {
    const TerrainModel terrain = tile(256);
    Terrain one(terrain, {.threads = 1});
    const auto expected = heights(one);
    for (const int threads : {2, 3, 7}) {
        Terrain land(terrain, {.threads = threads});
        EXPECT_EQ(heights(land), expected) << threads;
        Terrain shared(land, {.threads = 2});
        EXPECT_EQ(heights(shared), expected);
        EXPECT_EQ(shared.runs().noise, 0);
    }
    for (const Backend& backend : core_backends()) {
        Terrain land(terrain, {.backend = backend});
        EXPECT_LT(error_of(heights(land), expected), 2e-6) << backend.name;
    }
}

TEST(Terrain, AChangedLandLeavesItsCopiesAlone) {
    Terrain land(tile(128));
    const auto before = heights(land);
    Terrain copy(land, {});
    land.set("beta", "2.6");
    EXPECT_NE(heights(land), before);
    EXPECT_EQ(heights(copy), before);
    land.set("beta", "2");
    EXPECT_EQ(heights(land), before);
}

TEST(Terrain, LayersRepeatWithTheirOwnPeriod) {
    TerrainModel terrain = tile(256);
    terrain.layers = {{500.0, 1.0, 5}};
    Terrain both(terrain);
    terrain.layers.clear();
    Terrain alone(terrain);
    // The difference of the unscaled sums is the layer.
    const auto with = heights(both), without = heights(alone);
    const double a = 1.0 / both.scale().gain, b = 1.0 / alone.scale().gain;
    std::vector<double> layer;
    for (std::size_t i = 0; i < with.size(); ++i) layer.push_back(a * with[i] - b * without[i]);
    double sum = 0.0, off = 0.0;
    for (const auto [i, j, at] : test::cells<std::size_t>(256, 256)) {
        const double here = layer[at], next = layer[j * 256 + (i + 64) % 256];
        sum += here * here;
        off += (here - next) * (here - next);
    }
    EXPECT_LT(std::sqrt(off / sum), 1e-5);
    EXPECT_NEAR(test::rms(with) / 25.0, 1.0, 1e-6);
}

// ---- Anisotropy

TEST(Terrain, TheLandIsSteepestInTheDirectionOfTheFile) {
    for (const double direction : {0.0, 25.0, 70.0}) {
        TerrainModel terrain = tile(512, 1.8);
        // A round limit: the corners of the lattice would pull the slopes to the diagonals.
        terrain.shortest_wavelength = 8.0;
        terrain.anisotropy = 3.0;
        terrain.direction = direction;
        double xx = 0.0, yy = 0.0, xy = 0.0;
        for (std::uint32_t seed = 1; seed <= 2; ++seed) {
            terrain.seed = seed;
            Terrain land(terrain);
            const Surface map = land.surface({Channel::slope_x, Channel::slope_y});
            const auto x = map.channel(Channel::slope_x), y = map.channel(Channel::slope_y);
            for (std::size_t i = 0; i < x.size(); ++i) {
                const double a = x[i], b = y[i];
                xx += a * a;
                yy += b * b;
                xy += a * b;
            }
        }
        const double found = 0.5 * std::atan2(2.0 * xy, xx - yy) * 360.0 / kTwoPi;
        EXPECT_NEAR(found, direction, 1.0);
    }
}

// ---- Slopes, normals, queries

TEST(Terrain, SlopesAndNormalsAreThoseOfTheHeights) {
    TerrainModel terrain = tile(256, 2.4);
    terrain.shortest_wavelength = 60.0;
    terrain.mean = 1234.0;
    Terrain land(terrain);
    using enum Channel;
    const Surface map = land.surface({height, slope_x, nx, ny, nz}, 512);
    const auto h = map.channel(height), s = map.channel(slope_x);
    const double step = 2000.0 / 512.0;
    double error = 0.0, sum = 0.0;
    for (std::size_t i = 2; i < 510; ++i) {
        const std::size_t at = 100 * 512 + i;
        const auto d = [&](std::size_t k) {
            return (static_cast<double>(h[at + k]) - static_cast<double>(h[at - k])) /
                   (2.0 * step * static_cast<double>(k));
        };
        const double slope = (4.0 * d(1) - d(2)) / 3.0;
        error += std::pow(slope - s[at], 2.0);
        sum += std::pow(s[at], 2.0);
        const double unit = std::pow(map.channel(nx)[at], 2.0) +
                            std::pow(map.channel(ny)[at], 2.0) + std::pow(map.channel(nz)[at], 2.0);
        ASSERT_NEAR(unit, 1.0, 1e-6);
        ASSERT_NEAR(-map.channel(nx)[at] / map.channel(nz)[at], s[at], 1e-5);
    }
    EXPECT_LT(std::sqrt(error / sum), 5e-3);
}

TEST(Terrain, QueriesMeetTheMapAndTheExactSum) {
    TerrainModel terrain = tile(256);
    terrain.mean = 300.0;
    Terrain land(terrain);
    const Surface map = land.surface({Channel::height, Channel::nx});
    std::vector<WorldPoint> points;
    for (int i = 0; i < 50; ++i) {
        // Samples, some of them several periods away.
        points.push_back({(37 * i % 256 + 256 * (i % 5 - 2)) * (2000.0 / 256.0),
                          (91 * i % 256) * (2000.0 / 256.0)});
    }
    std::vector<QuerySample> found(points.size()), exact(points.size());
    land.query(points, found);
    land.query(points, exact, {.exact = true});
    for (int i = 0; i < 50; ++i) {
        const auto at = static_cast<std::size_t>((91 * i % 256) * 256 + 37 * i % 256);
        const auto n = static_cast<std::size_t>(i);
        EXPECT_NEAR(exact[n].height, map.channel(Channel::height)[at], 2e-6 * 25.0 + 3e-5);
        EXPECT_NEAR(found[n].height, exact[n].height, 1e-3 * 25.0);
        EXPECT_NEAR(exact[n].normal[0], map.channel(Channel::nx)[at], 2e-5);
    }
    // Between the samples the rms error is the one that is told.
    double error = 0.0;
    for (int i = 0; i < 50; ++i) {
        points[static_cast<std::size_t>(i)] = {101.7 * i - 800.0, 57.3 * i + 11.1 * (i % 7)};
    }
    land.query(points, found);
    land.query(points, exact, {.exact = true});
    for (std::size_t n = 0; n < 50; ++n) {
        error += std::pow(found[n].height - exact[n].height, 2.0) / 50.0;
    }
    EXPECT_LT(std::sqrt(error), 1.5 * land.query_height_error());
    EXPECT_LT(land.query_height_error() / 25.0, 1e-3);
}

TEST(Terrain, ChannelsOfASeaAreRefused) {
    Terrain land(tile(64));
    EXPECT_THROW(land.surface({Channel::foam}), Error);
    EXPECT_THROW(land.surface({Channel::height, Channel::dx}), Error);
    EXPECT_THROW(land.surface({Channel::height}, 100), Error);
}

// ---- Stages

TEST(TerrainStages, LeadFromWhiteNoiseToTheTerrainsOwnHeight) {
    TerrainModel terrain = tile(256);
    terrain.mean = 40.0;
    terrain.layers = {{500.0, 0.7, 3}};
    Terrain land(terrain);
    const TerrainStages stages = terrain_stages(land);
    Terrain plain(tile(256));  // without the noise of a layer
    const auto noise = terrain_stages(plain).noise;
    EXPECT_NEAR(test::rms(noise), 1.0, 0.02);
    double neighbours = 0.0;
    for (std::size_t i = 1; i < noise.size(); ++i) neighbours += double{noise[i]} * noise[i - 1];
    EXPECT_LT(std::abs(neighbours / static_cast<double>(noise.size())), 0.01);
    double filtered = 0.0;
    for (const float value : stages.filtered) filtered += static_cast<double>(value) * value;
    EXPECT_NEAR(std::sqrt(filtered) / 25.0, 1.0, 1e-5);  // Parseval
    EXPECT_EQ(stages.filtered[128 * 256 + 128], 0.0f);   // k = 0 in the middle
    for (std::size_t i = 0; i < stages.filter.size(); ++i) {
        ASSERT_NEAR(stages.filtered[i], stages.transform[i] * stages.filter[i], 1e-3);
    }
    EXPECT_LT(error_of(stages.height, heights(land)), 2e-6);
}

TEST(TerrainState, SaysWhatWasAskedForAndWhatTheTileHolds) {
    TerrainModel terrain = tile(512, 1.8);
    Terrain land(terrain);
    const TerrainState state = land.state();
    EXPECT_NEAR(state.rms.asked, 25.0, 1e-9);
    EXPECT_NEAR(state.rms.resolved, 25.0, 1e-5);
    const Surface map = land.surface({Channel::slope_x, Channel::slope_y});
    const double x = test::rms(map.channel(Channel::slope_x)),
                 y = test::rms(map.channel(Channel::slope_y));
    EXPECT_NEAR(state.rms_slope.resolved, std::hypot(x, y), 1e-5);
    EXPECT_NEAR(state.rms_slope.asked / state.rms_slope.resolved, 1.0, 0.1);
    double octaves = 0.0;
    for (const TerrainOctave& octave : state.octaves) {
        octaves += octave.rms.resolved * octave.rms.resolved;
        EXPECT_NEAR(octave.exponent.asked, 1.8, 1e-6);
    }
    EXPECT_NEAR(std::sqrt(octaves) / 25.0, 1.0, 1e-3);  // without the corners
    EXPECT_NEAR(state.octaves.back().exponent.resolved, 1.8, 0.05);
    terrain.rms = 0.0;
    land.set_model(terrain);
    ASSERT_EQ(land.state().warnings.size(), 1u);
    EXPECT_TRUE(test::says(land.state().warnings[0], "flat"));
}

}  // namespace
}  // namespace ocean
