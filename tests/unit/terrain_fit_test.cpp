// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the table law of a crop of land has the land's density in each octave above the lowest
// within 0.05 in log10, judged by seeds that corrected nothing; a broken law gives back the
// exponents and the break that made the land; the variance of the land is kept within 5 % by every
// law, but for a tilt; what a law cannot say is a warning.
#include "ocean/internal/terrain_fit.hpp"

#include <cstdint>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_table.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// A crop of the land of a terrain, which no period fits into.
ElevationModel crop_of(const TerrainModel& terrain, int columns, int rows) {
    const auto heights = test::values_of(Terrain(terrain).surface({Channel::height}));
    const double cell = terrain.patch_size / terrain.resolution;
    ElevationModel model;
    model.domain = {.origin = {},
                    .size = {cell * (columns - 1), cell * (rows - 1)},
                    .samples = {columns, rows},
                    .wraps = false};
    for (const auto [i, j] : test::pairs(columns, rows)) {
        model.heights.push_back(
            heights[static_cast<std::size_t>((j + 31) * terrain.resolution + i + 17)] + 700.0f);
    }
    return model;
}

/// Hills of an exponent 1.4 above 600 m and 2.6 below.
TerrainModel hills() {
    TerrainModel terrain;
    terrain.resolution = 1024;
    terrain.patch_size = 20000.0;
    terrain.beta = 1.4;
    terrain.breaks = {{600.0, 2.6}};
    terrain.rms = 120.0;
    terrain.seed = 77;
    return terrain;
}

TEST(TerrainFit, TheTableLawHasTheDensityOfBrokenLandsRidgesAndSmoothLands) {
    TerrainModel ridges = hills(), smooth = hills();
    ridges.ridge_wavelength = 900.0;
    ridges.ridge_gain = 6.0;
    ridges.ridge_width = 0.4;
    smooth.breaks.clear();
    smooth.beta = 2.4;
    for (const ElevationModel& model :
         {crop_of(hills(), 400, 360), crop_of(ridges, 512, 512), crop_of(smooth, 300, 500)}) {
        SCOPED_TRACE(model.domain.samples[1]);
        const TerrainFit fit = fit_terrain(model);
        ASSERT_NE(fit.terrain.rings, nullptr);
        EXPECT_NO_THROW(validate(fit.terrain));
        EXPECT_LE(fit.error_above_lowest(), 0.05);
        EXPECT_GE(fit.octaves.size(), 4u);
    }
}

TEST(TerrainFit, ABrokenLawGivesBackTheLawThatMadeTheLand) {
    double beta = 0.0, length = 0.0, short_beta = 0.0;
    constexpr int kSeeds = 12;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        TerrainModel terrain = hills();
        terrain.patch_size = 60000.0;  // many waves on either side of the break
        terrain.seed = 500 + seed;
        const TerrainFit fit =
            fit_terrain(crop_of(terrain, 500, 500), {.law = FitLaw::broken, .seeds = 4});
        ASSERT_EQ(fit.parameters.size(), 3u);
        beta += fit.parameters[0].value / kSeeds;
        length += std::log(fit.parameters[1].value) / kSeeds;
        short_beta += fit.parameters[2].value / kSeeds;
        EXPECT_EQ(fit.terrain.beta, fit.parameters[0].value);
        EXPECT_NEAR(fit.terrain.mean, 700.0, 150.0);
        EXPECT_FALSE(fit.parameters[1].is_at_bound);
    }
    EXPECT_NEAR(beta, 1.4, 0.03 * 1.4);
    EXPECT_NEAR(short_beta, 2.6, 0.03 * 2.6);
    EXPECT_NEAR(std::exp(length), 600.0, 0.05 * 600.0);
}

TEST(TerrainFit, OneExponentIsFoundAndABrokenLandIsAWarning) {
    TerrainModel smooth = hills();
    smooth.breaks.clear();
    smooth.beta = 2.2;
    const TerrainFit good =
        fit_terrain(crop_of(smooth, 512, 512), {.law = FitLaw::one, .seeds = 4});
    EXPECT_NEAR(good.parameters[0].value, 2.2, 0.03 * 2.2);
    const TerrainFit bad =
        fit_terrain(crop_of(hills(), 512, 512), {.law = FitLaw::one, .seeds = 4});
    EXPECT_GT(bad.error_above_lowest(), 0.15);
    EXPECT_TRUE(test::says(bad.warnings, "the table law follows the rings"));
}

double variance_of_tile(const TerrainModel& terrain) {
    return std::pow(Terrain(terrain).state().rms.resolved, 2);
}

/// A whole tile of one exponent, whose rms is known: 60 m.
ElevationModel known_land(std::uint32_t seed) {
    TerrainModel terrain = hills();
    terrain.breaks.clear();
    terrain.beta = 2.2;
    terrain.rms = 60.0;
    terrain.resolution = 128;
    terrain.patch_size = 1280.0;
    terrain.seed = seed;
    const auto heights = test::values_of(Terrain(terrain).surface({Channel::height}));
    ElevationModel model;
    model.domain = {.origin = {}, .size = {1270.0, 1270.0}, .samples = {128, 128}, .wraps = false};
    model.heights.assign(heights.begin(), heights.end());
    return model;
}

TEST(TerrainFit, EveryLawKeepsTheVarianceOfTheLandAndItsExponent) {
    for (const std::uint32_t seed : {3u, 4u}) {
        const ElevationModel land = known_land(seed);
        for (const FitLaw law : {FitLaw::table, FitLaw::broken, FitLaw::one}) {
            const TerrainFit fit = fit_terrain(land, {.law = law, .seeds = 4});
            EXPECT_NEAR(variance_of_tile(fit.terrain), 3600.0, 0.05 * 3600.0) << seed;
            EXPECT_NEAR(fit.terrain.beta, 2.2, 0.15) << seed;
            EXPECT_EQ(bool(test::says(fit.warnings, "have no break")), law == FitLaw::broken)
                << seed;
            EXPECT_TRUE(fit.terrain.breaks.empty());
        }
    }
}

TEST(TerrainFit, OfATiltedLandTheVarianceAboutThePlaneIsKeptAndSaid) {
    ElevationModel land = known_land(3);
    const double about_plane = fit_terrain(land, {.seeds = 4}).bed.rms;
    for (std::size_t i = 0; i < land.heights.size(); ++i) {
        land.heights[i] += 3.0f * static_cast<float>(i % 128);
    }
    for (const FitLaw law : {FitLaw::table, FitLaw::one}) {
        const TerrainFit fit = fit_terrain(land, {.law = law, .seeds = 4});
        EXPECT_NEAR(variance_of_tile(fit.terrain), about_plane * about_plane,
                    0.05 * about_plane * about_plane);
        EXPECT_TRUE(test::says(fit.warnings, "m, and " + significant_text(about_plane, 4) +
                                                 " m about its plane, which the terrain has"));
    }
}

TEST(TerrainFit, WavesLongerThanTheModelAreLeftOut) {
    const TerrainFit fit = fit_terrain(crop_of(hills(), 300, 260), {.seeds = 4});
    EXPECT_EQ(fit.terrain.resolution, 512);
    EXPECT_DOUBLE_EQ(fit.terrain.longest_wavelength, fit.terrain.patch_size / 2.0);
    EXPECT_NEAR(variance_of_tile(fit.terrain), fit.kept_rms * fit.kept_rms,
                0.05 * fit.kept_rms * fit.kept_rms);
}

TEST(TerrainFit, AParameterAtItsBoundIsAWarning) {
    TerrainModel noise = hills();
    noise.breaks.clear();
    noise.beta = 0.0;
    const TerrainFit fit = fit_terrain(crop_of(noise, 256, 256), {.law = FitLaw::one, .seeds = 4});
    EXPECT_TRUE(fit.parameters[0].is_at_bound);
    EXPECT_TRUE(test::says(fit.warnings, "at the bound"));
}

TEST(TerrainFit, ReliefOfTheModelAndOfTheTerrainAreBothTold) {
    TerrainModel terrain = hills();
    terrain.anisotropy = 2.0;
    terrain.direction = 30.0;
    const TerrainFit fit = fit_terrain(crop_of(terrain, 400, 400), {.seeds = 4});
    EXPECT_GT(fit.bed.anisotropy, 1.5);
    EXPECT_NEAR(fit.bed.direction, 30.0, 3.0);
    EXPECT_NEAR(fit.model.rms / fit.bed.rms, 1.0, 0.15);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(fit.model.slopes[i] / fit.bed.slopes[i], 1.0, 0.15);
    }
    EXPECT_LT(fit.bed.slopes[0], fit.bed.slopes[2]);
    EXPECT_TRUE(test::says(fit.warnings, "steeper along 3") ||
                test::says(fit.warnings, "steeper along 2"));
}

TEST(TerrainFit, WhatCannotBeFittedIsRefused) {
    ElevationModel flat = crop_of(hills(), 64, 64);
    EXPECT_NO_THROW(fit_terrain(flat, {.seeds = 4}));
    EXPECT_THROW(fit_terrain(flat, {.seeds = 1}), Error);
    std::ranges::fill(flat.heights, 5.0f);
    EXPECT_THROW(fit_terrain(flat), Error);
    EXPECT_THROW(fit_terrain(crop_of(hills(), 64, 31)), Error);
    ElevationModel hole = crop_of(hills(), 64, 64);
    hole.heights[9] = std::nanf("");
    EXPECT_THROW(fit_terrain(hole), Error);
}

TEST(TerrainFit, ProgressCountsTheTerrainsAndMayEndTheFit) {
    const ElevationModel model = crop_of(hills(), 64, 64);
    int last = 0, all = 0;
    fit_terrain(model, {.seeds = 4, .progress = [&](int done, int of) {
                            last = done;
                            all = of;
                        }});
    EXPECT_EQ(last, all);
    EXPECT_EQ(all, 4);
    EXPECT_THROW(
        fit_terrain(model,
                    {.progress = [](int, int) { throw Error(ErrorKind::interrupted, "stopped"); }}),
        Error);
}

}  // namespace
}  // namespace ocean
