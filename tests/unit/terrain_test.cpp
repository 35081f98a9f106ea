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
