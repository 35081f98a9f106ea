// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lands as functions of the place: splines, fine waves, elevation models with detail, gullies,
// streams and shores together.
#include "ocean/land_function.hpp"

#include "field/spline_grid.hpp"
#include "land/function/base_detail.hpp"
#include "land/function/fine_waves.hpp"
#include "land/function/place_hash.hpp"
#include "ocean/internal/ring_spectrum.hpp"
#include "ocean/internal/terrain_base.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_table.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// Returns the rms about the mean.
double rms_of(std::span<const float> values) {
    return std::sqrt(test::variance(values));
}

TerrainModel gullied_tile(int resolution) {
    TerrainModel terrain;
    terrain.resolution = resolution;
    terrain.patch_size = 16.0 * resolution;
    terrain.beta = 1.8;
    terrain.breaks = {{600.0, 2.6}};
    terrain.outer_scale = 9000.0;
    terrain.rms = 200.0;
    terrain.gullies.depth = 0.055;
    terrain.gullies.longest = 0.25 * std::min(terrain.patch_size, 2800.0);
    return terrain;
}

TerrainModel island(int resolution) {
    TerrainModel terrain;
    terrain.kind = TerrainKind::placed;
    terrain.resolution = resolution;
    terrain.patch_size = 16384.0;
    terrain.seed = 8;
    terrain.rms = 200.0;
    terrain.mean = 620.0;
    terrain.island = 1000.0;
    terrain.beta = 1.9;
    terrain.breaks = {{1500.0, 2.5}};
    terrain.outer_scale = 9000.0;
    terrain.stream.slope = 0.62;
    terrain.coast.beach_slope = 1.0 / 30.0;
    return terrain;
}

/// Returns a square of samples from a place on.
Domain square(double x, double y, int side, double cell) {
    return {{x, y}, {cell * (side - 1), cell * (side - 1)}, {side, side}, false};
}

/// Returns a tile of beta 2.2.
TerrainModel smooth_tile(double cell) {
    TerrainModel tile;
    tile.resolution = 2048;
    tile.patch_size = cell * 2048.0;
    tile.beta = 2.2;
    tile.rms = 150.0;
    tile.outer_scale = 0.5 * tile.patch_size;
    return tile;
}

/// Returns a land on a base: every `stride`-th sample of such a tile.
TerrainModel placed_on_samples(int side, int stride, double cell) {
    Terrain land(smooth_tile(cell / stride));
    const auto heights = test::values_of(land.surface({Channel::height}));
    TerrainBase base;
    base.model.domain = square(0.0, 0.0, side, cell);
    for (const auto [i, j] : test::pairs(side, side)) {
        base.model.heights.push_back(
            heights[static_cast<std::size_t>(j * stride * 2048 + i * stride)]);
    }
    for (const Ring& ring : measure_rings(base.model.domain, base.model.heights, test::pool())) {
        base.rings.wavenumber.push_back(ring.wavenumber);
        base.rings.density.push_back(ring.density);
    }
    TerrainModel terrain;
    terrain.kind = TerrainKind::placed;
    terrain.base = "made";
    terrain.base_model = std::make_shared<const TerrainBase>(base);
    return terrain;
}

// ---- Splines

std::vector<float> noise(std::size_t count) {
    std::vector<float> values;
    for (std::uint32_t i = 0; i < count; ++i) {
        values.push_back(static_cast<float>(place_hash(i, 7, 3) >> 8) / 16777216.0f - 0.5f);
    }
    return values;
}

TEST(SplineGrids, PassThroughTheirSamplesAndWrapOrEnd) {
    for (const bool wraps : {false, true}) {
        const double width = wraps ? 37.0 : 36.0, height = wraps ? 23.0 : 22.0;
        const Domain domain{{-3.0, 11.0}, {2.0 * width, 2.5 * height}, {37, 23}, wraps};
        const std::vector<float> samples = noise(domain.count());
        const SplineGrid grid(domain, samples, test::pool());
        for (const auto [i, j, at] : test::cells(37, 23)) {
            const auto [x, y] = domain.place(i, j);
            const float sample = samples[at];
            EXPECT_NEAR(grid.value_at(x, y), static_cast<double>(sample), 1e-6);
            if (!wraps) continue;
            EXPECT_NEAR(grid.value_at(x + 3.0 * domain.size[0], y - domain.size[1]),
                        static_cast<double>(sample), 1e-5);
        }
        if (wraps) continue;
        EXPECT_EQ(grid.value_at(-100.0, 1e6), grid.value_at(-3.0, 11.0 + domain.size[1]));
    }
}

TEST(SplineGrids, HaveTheGradientOfTheirValues) {
    const Domain domain = Domain::tile(64.0, 32);
    const SplineGrid grid(domain, noise(domain.count()), test::pool());
    constexpr double kStep = 1e-4;
    for (const auto& [x, y] : {std::array{3.3, 60.1}, {17.0, 20.5}, {63.9, 0.2}}) {
        const GroundJet jet = grid.at(x, y);
        EXPECT_EQ(jet.height, grid.value_at(x, y));
        const double by_x = grid.value_at(x + kStep, y) - grid.value_at(x - kStep, y);
        const double by_y = grid.value_at(x, y + kStep) - grid.value_at(x, y - kStep);
        EXPECT_NEAR(jet.slope_x, by_x / (2.0 * kStep), 1e-6);
        EXPECT_NEAR(jet.slope_y, by_y / (2.0 * kStep), 1e-6);
    }
}

TEST(SplinePyramids, KeepLongWavesOnCoarserLevelsAndTheirPlace) {
    constexpr int kSide = 256;
    for (const bool wraps : {false, true}) {
        const Domain domain{
            {0.0, 0.0}, {wraps ? 256.0 : 255.0, wraps ? 256.0 : 255.0}, {kSide, kSide}, wraps};
        std::vector<float> samples;
        for (const auto [i, j] : test::pairs(kSide, kSide)) {
            samples.push_back(
                static_cast<float>(std::sin(kTwoPi * i / 64.0) + std::cos(kTwoPi * j / 64.0)));
        }
        const SplinePyramid pyramid(domain, samples, test::pool());
        EXPECT_EQ(pyramid.level(1.0).domain().samples[0], kSide);
        EXPECT_EQ(pyramid.level(3.9).domain().samples[0], kSide / 2);
        const SplineGrid& coarse = pyramid.level(4.0);
        EXPECT_EQ(coarse.domain().samples[0], kSide / 4);
        for (const double x : {40.0, 71.3, 128.0, 200.9}) {
            EXPECT_NEAR(coarse.value_at(x, x), pyramid.finest().value_at(x, x), 5e-3);
        }
    }
}

// ---- Fine waves

TEST(FineWaves, HaveTheEnergyOfTheirDensityInEachOctaveAndItsGradient) {
    const RadialDensity density = [](double k) { return 1e-3 * std::pow(k, -4.4); };
    const FineWaves waves(density, 64.0, 2.0, 5, test::pool());
    const double variance = ring_variance(density, kTwoPi / 64.0, kTwoPi / 2.0);
    EXPECT_NEAR(waves.variance(), variance, 1e-3 * variance);
    // Places far apart, so that they are independent.
    double sum = 0.0;
    constexpr int kPlaces = 40000;
    for (int i = 0; i < kPlaces; ++i) {
        const double x = 97.31 * (i % 200), y = 101.7 * (i / 200) - 5000.0;
        const double h = waves.at(x, y, 0.0).height;
        sum += h * h;
    }
    EXPECT_NEAR(sum / kPlaces, variance, 0.03 * variance);
    constexpr double kStep = 1e-4;
    for (const auto& [x, y] : {std::array{12.3, -4567.8}, {1e5, 3.0}, {0.0, 0.0}}) {
        const GroundJet jet = waves.at(x, y, 0.0);
        const double by_x = waves.at(x + kStep, y, 0.0).height - waves.at(x - kStep, y, 0.0).height;
        const double by_y = waves.at(x, y + kStep, 0.0).height - waves.at(x, y - kStep, 0.0).height;
        EXPECT_NEAR(jet.slope_x, by_x / (2.0 * kStep), 1e-5);
        EXPECT_NEAR(jet.slope_y, by_y / (2.0 * kStep), 1e-5);
    }
    EXPECT_EQ(waves.at(5.0, 5.0, 32.0).height, 0.0);
    EXPECT_GE(FineWaves::bytes(64.0, 2.0), 1024u * 1024u * 4u);
}

TEST(FineWaves, DoNotRepeat) {
    const FineWaves waves([](double k) { return std::pow(k, -5.0); }, 32.0, 4.0, 1, test::pool());
    const double period = 8.0 * 32.0;
    for (const auto& [x, y] : {std::array{period, 0.0}, {0.0, period}, {96.0 * 8.0, 0.0}}) {
        double product = 0.0;
        constexpr int kPlaces = 4000;
        for (int i = 0; i < kPlaces; ++i) {
            const double u = 61.7 * (i % 64), v = 59.3 * (i / 64);
            product += waves.at(u, v, 0.0).height * waves.at(u + x, v + y, 0.0).height;
        }
        EXPECT_LT(std::abs(product / kPlaces), 0.1 * waves.variance()) << x << " " << y;
    }
}

// ---- Elevation models

TEST(BaseDetail, ContinuesTheSpectrumAcrossTheCellWithin15HundredthsOfADecade) {
    constexpr double kCell = 30.0;
    TerrainModel terrain = placed_on_samples(256, 4, kCell);
    terrain.detail_wavelength = 7.5;
    // The tile that the base was sampled from is the truth, down to its own cell of 7.5 m.
    Terrain true_land(smooth_tile(7.5));
    const Domain window = square(100.0, 100.0, 1536, 3.75);
    const Surface real = true_land.region(window, {Channel::height});
    const auto wanted = measure_rings(window, real.channel(Channel::height), test::pool());
    const double nyquist = kPi / kCell;
    // Where the samples are held, they take long waves out of any detail; free ones do not.
    for (const double error : {default_base_error(*terrain.base_model), 1000.0}) {
        terrain.base_error = error;
        const Surface shown = Terrain(terrain).region(window, {Channel::height});
        const auto rings = measure_rings(window, shown.channel(Channel::height), test::pool());
        ASSERT_EQ(rings.size(), wanted.size());
        int compared = 0;
        for (std::size_t i = 0; i < rings.size(); ++i) {
            const double k = rings[i].wavenumber;
            if (k < 0.1 * nyquist || k > 3.0 * nyquist) continue;
            EXPECT_NEAR(std::log10(rings[i].density), std::log10(wanted[i].density), 0.15)
                << k / nyquist << " with an error of " << error << " m";
            ++compared;
        }
        EXPECT_GE(compared, 15);
    }
}

TEST(BaseDetail, MovesTheSamplesByAtMostBaseError) {
    TerrainModel terrain = placed_on_samples(128, 8, 30.0);
    terrain.detail_wavelength = 1.0;
    const double default_error = default_base_error(*terrain.base_model);
    EXPECT_GT(default_error, 0.0);
    for (const double asked : {-1.0, 0.5, 0.0}) {
        if (asked >= 0.0) terrain.base_error = asked;
        Terrain land(terrain);
        std::vector<WorldPoint> places;
        for (const auto [i, j] : test::pairs(128, 128)) {
            places.push_back({30.0 * i, 30.0 * j});
        }
        std::vector<QuerySample> samples(places.size());
        // The land itself, with all its waves.
        land.function()->query(places, samples, 0.01, land.pool());
        double sum = 0.0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double moved =
                samples[i].height - static_cast<double>(terrain.base_model->model.heights[i]);
            sum += moved * moved;
        }
        const double limit = asked >= 0.0 ? asked : default_error;
        // The waves that the seed happens to have at these places scatter by 2 %.
        EXPECT_LE(std::sqrt(sum / static_cast<double>(samples.size())), 1.05 * limit + 1e-3)
            << asked;
    }
}

// ---- Lands

/// Counts the values of a region that differ from the same places of another one.
std::size_t differing(const Surface& large, const Surface& small, int i0, int j0) {
    std::size_t count = 0;
    for (const Channel channel : test::channels_of(small)) {
        const auto a = large.channel(channel), b = small.channel(channel);
        for (int j = 0; j < small.domain().samples[1]; ++j) {
            const auto at = static_cast<std::size_t>((j + j0) * large.domain().samples[0] + i0);
            const auto width = static_cast<std::size_t>(small.domain().samples[0]);
            if (std::memcmp(&a[at], &b[static_cast<std::size_t>(j) * width], 4 * width) != 0) {
                ++count;
            }
        }
    }
    return count;
}

TEST(LandFunctions, HaveTheSameBitsInEveryRegion) {
    TerrainModel with_detail = island(128);
    with_detail.detail_wavelength = 2.0;
    for (const TerrainModel& terrain :
         {gullied_tile(256), with_detail, placed_on_samples(64, 8, 30.0)}) {
        Terrain land(terrain, {.threads = 2});
        const double cell = 0.7;
        const int columns = 400, rows = 150;
        const double x0 = cell * 1500, y0 = cell * 900;
        const Domain whole{
            {x0, y0}, {cell * (columns - 1), cell * (rows - 1)}, {columns, rows}, false};
        const ChannelSet channels = land.channels();
        const Surface large = land.region(whole, channels);
        Terrain other(terrain, {.threads = 1});
        for (std::uint32_t n = 0; n < 70; ++n) {
            const int i0 = static_cast<int>(place_hash(n, 0, 1) % (columns - 2));
            const int j0 = static_cast<int>(place_hash(n, 0, 2) % (rows - 2));
            const int width = 2 + static_cast<int>(place_hash(n, 0, 3) % 30);
            const int height = 2 + static_cast<int>(place_hash(n, 0, 4) % 20);
            const int w = std::min(width, columns - i0), h = std::min(height, rows - j0);
            const Domain part{
                {x0 + cell * i0, y0 + cell * j0}, {cell * (w - 1), cell * (h - 1)}, {w, h}, false};
            EXPECT_EQ(differing(large, other.region(part, channels), i0, j0), 0u) << n;
        }
    }
}

TEST(LandFunctions, HaveTheSameHeightsWithAndWithoutSlopes) {
    TerrainModel tile = gullied_tile(64);
    tile.gullies.depth = 0.0;
    const Domain region{{-70.0, 30.0}, {3.7 * 99, 3.7 * 59}, {100, 60}, false};
    TerrainModel detailed = tile;
    detailed.kind = TerrainKind::placed;
    detailed.detail_wavelength = 8.0;
    for (const TerrainModel& terrain : {tile, gullied_tile(64), detailed}) {
        Terrain land(terrain, {.threads = 1});
        const std::shared_ptr<const LandFunction> function = land.function();
        EXPECT_TRUE(test::same_bits(
            function->surface(region, {Channel::height, Channel::slope_x}, test::pool()),
            function->surface(region, {Channel::height}, test::pool())));
    }
}

TEST(LandFunctions, OfTilesRepeatAndJoinTheirOwnMaps) {
    Terrain land(gullied_tile(256));
    const Surface map = land.surface({Channel::height, Channel::slope_x});
    const double period = land.model().patch_size;
    const Surface copy =
        land.region(square(-period, 2.0 * period, 256, 16.0), {Channel::height, Channel::slope_x});
    const double rms = rms_of(map.channel(Channel::height));
    EXPECT_LT(test::largest_difference(map.channel(Channel::height), copy.channel(Channel::height)),
              1e-5 * rms);
    EXPECT_LT(
        test::largest_difference(map.channel(Channel::slope_x), copy.channel(Channel::slope_x)),
        1e-4);
    // A plain tile, whose maps are made by transforms.
    TerrainModel plain = gullied_tile(256);
    plain.gullies.depth = 0.0;
    Terrain waves(plain);
    EXPECT_LT(
        test::largest_difference(
            waves.surface({Channel::height}).channel(Channel::height),
            waves.region(square(0.0, 0.0, 256, 16.0), {Channel::height}).channel(Channel::height)),
        1e-5 * 200.0);
}

TEST(LandFunctions, AnswerQueriesWithTheirMaps) {
    for (const TerrainModel& terrain : {gullied_tile(128), island(128)}) {
        Terrain land(terrain);
        const Surface map = land.surface({Channel::height, Channel::nx, Channel::nz});
        std::vector<std::size_t> indices;
        std::vector<WorldPoint> places;
        for (const auto [i, j, at] : test::cells(128, 128)) {
            if (i % 5 != 1 || j % 7 != 1) continue;
            const auto [x, y] = map.domain().place(i, j);
            places.push_back({x, y});
            indices.push_back(at);
        }
        std::vector<QuerySample> samples(places.size());
        land.query(places, samples);
        const double rms = rms_of(map.channel(Channel::height));
        for (std::size_t n = 0; n < places.size(); ++n) {
            const std::size_t at = indices[n];
            EXPECT_NEAR(samples[n].height, double{map.channel(Channel::height)[at]}, 1e-5 * rms);
            EXPECT_NEAR(samples[n].normal[0], double{map.channel(Channel::nx)[at]}, 1e-4);
        }
        const WorldPoint nowhere[] = {{std::nan(""), 0.0}};
        EXPECT_THROW(land.query(nowhere, samples), Error);
    }
}

/// Returns how many cells lie lower than all their eight neighbours, on land.
int pits_in(std::span<const float> height, int side) {
    int pits = 0;
    for (int j = 1; j + 1 < side; ++j) {
        for (int i = 1; i + 1 < side; ++i) {
            const auto at = [&](int x, int y) {
                return height[static_cast<std::size_t>(y * side + x)];
            };
            float lowest = at(i - 1, j);
            for (const auto [x, y] : test::pairs({i - 1, i + 2}, {j - 1, j + 2})) {
                if (x != i || y != j) lowest = std::min(lowest, at(x, y));
            }
            pits += at(i, j) > 0.0f && at(i, j) < lowest ? 1 : 0;
        }
    }
    return pits;
}

/// Heights with and without a shore.
struct ShoredMaps {
    Surface with, without;

    ShoredMaps(Terrain& shored, Terrain& plain, const Domain& region)
        : with(shored.region(region, {Channel::height})),
          without(plain.region(region, {Channel::height})) {}
    float after(std::size_t at) const { return with.channel(Channel::height)[at]; }
    float before(std::size_t at) const { return without.channel(Channel::height)[at]; }
    bool is_changed(std::size_t at) const { return after(at) != before(at); }
};

/// Returns true if water lies up to `reach` samples to each side.
bool is_near_water(const Surface& map, int i, int j, int reach) {
    const int side = map.domain().samples[0];
    for (int y = std::max(j - reach, 0); y <= std::min(j + reach, side - 1); ++y) {
        for (int x = std::max(i - reach, 0); x <= std::min(i + reach, side - 1); ++x) {
            if (map.channel(Channel::height)[static_cast<std::size_t>(y * side + x)] < 0.0f) {
                return true;
            }
        }
    }
    return false;
}

TEST(Islands, KeepTheBitsOfLandThatTheShoreDoesNotReach) {
    TerrainModel terrain = island(128);
    Terrain shored(terrain);
    terrain.coast.beach_slope = 0.0;
    Terrain plain(terrain);
    const Domain own = plain.domain();
    const ShoredMaps maps(shored, plain, own);
    const int side = own.samples[0];
    // A beach is 130 m wide, a cell of 129 m and a diagonal; all land is at least 3 m high.
    constexpr int kReach = 2;
    int beyond = 0, changed = 0;
    for (const auto [i, j, at] : test::cells(side, side)) {
        if (maps.before(at) < 3.0f || is_near_water(maps.with, i, j, kReach)) continue;
        ++beyond;
        changed += maps.is_changed(at) ? 1 : 0;
    }
    EXPECT_GT(beyond, side * side / 10);
    EXPECT_EQ(changed, 0);
    EXPECT_EQ(pits_in(maps.without.channel(Channel::height), side), 0);
    EXPECT_EQ(pits_in(maps.with.channel(Channel::height), side), 0);
    // Where the reach ends both join without a step, on cells far below those of their grids.
    const double cell = 0.5;
    const ShoredMaps fine(shored, plain, {{1500.0, 8000.0}, {cell * 8191, cell}, {8192, 2}, false});
    int ends = 0;
    for (std::size_t i = 1; i < 8192; ++i) {
        if (fine.is_changed(i) == fine.is_changed(i - 1)) continue;
        ++ends;
        const double here = double{fine.after(i)} - double{fine.before(i)};
        const double there = double{fine.after(i - 1)} - double{fine.before(i - 1)};
        EXPECT_LT(std::abs(here - there), 0.01) << i;
    }
    EXPECT_GT(ends, 0);
}

TEST(Islands, KeepTheirStreamsWhileTheShoreChanges) {
    Terrain land(island(128));
    land.function();
    EXPECT_EQ(land.runs().streams, 1);
    land.set("terrain.coast.berm", "3");
    const auto function = land.function();
    EXPECT_EQ(land.runs().streams, 1);
    EXPECT_EQ(land.runs().shape, 2);
    land.set("terrain.stream.age", "0.5");
    land.function();
    EXPECT_EQ(land.runs().streams, 2);
    EXPECT_TRUE(function->channels().contains(channel_of(LandMask::beach)));
}

TEST(Islands, ReportProgressAndStop) {
    struct Stop {};
    int calls = 0;
    Terrain land(island(128), {.progress = [&](std::string_view work, double share) {
                     EXPECT_TRUE(share >= 0.0 && share <= 1.0);
                     if (work == "streams" && ++calls == 2) throw Stop();
                 }});
    EXPECT_THROW(land.function(), Stop);
    EXPECT_NO_THROW(land.function());
    EXPECT_GE(calls, 3);
}

TEST(Lands, HaveTheMasksOfTheirSectionsAndRefuseOthers) {
    Terrain tile(gullied_tile(64));
    EXPECT_TRUE(tile.channels().contains(channel_of(LandMask::wear)));
    EXPECT_FALSE(tile.channels().contains(channel_of(LandMask::beach)));
    EXPECT_THROW(tile.surface({channel_of(LandMask::flow)}), Error);
    EXPECT_THROW(tile.surface({Channel::foam}), Error);
    const Surface map = tile.surface({channel_of(LandMask::gully), channel_of(LandMask::ridge)});
    EXPECT_GT(rms_of(map.channel(channel_of(LandMask::gully))), 0.01);
}

}  // namespace
}  // namespace ocean
